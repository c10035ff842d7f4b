//! Triangulations of two and of three points.

use super::faces::{FACES_PER_VERTEX, Faces, edge_of};
use super::part::{Corner, Part};
use super::site::{Site, Sited};
use geometry_core::kernel::lexicographic;
use geometry_core::{Kernel2, Sign};

/// The edge between two distinct points, the first two sites from `first` on.
#[inline(always)]
pub(super) fn edge(sites: &[Site], faces: &mut Faces<'_>, first: u32) -> Part {
    let hull = [first, first + 1];
    let ghosts = FACES_PER_VERTEX as u32 * first;
    faces.surround(ghosts, hull);
    faces.glue(edge_of(ghosts), edge_of(ghosts + 1));
    Part::of(sites, &Corner::around(hull, ghosts))
}

/// The triangle of three distinct points, the sites from `first` on, or two edges if they are collinear.
#[inline(always)]
pub(super) fn triangle(
    sites: &[Site],
    faces: &mut Faces<'_>,
    kernel: &impl Kernel2,
    first: u32,
) -> Part {
    let [a, b, c] = [first, first + 1, first + 2];
    let [p, q, r] = [a, b, c].map(|vertex| sites[vertex as usize].at());
    let hull = match kernel.orient(p, q, r) {
        Sign::Positive => [a, b, c],
        Sign::Negative => [a, c, b],
        Sign::Zero => return path(sites, faces, [a, b, c]),
    };
    let face = FACES_PER_VERTEX as u32 * first;
    let (inside, ghosts) = (edge_of(face), face + 1);
    faces.set_corners(inside, hull);
    faces.surround(ghosts, hull);
    for i in 0..3 {
        faces.glue(inside + i, edge_of(ghosts + i));
    }
    Part::of(sites, &Corner::around(hull, ghosts))
}

/// Two edges from end to end.
fn path(sites: &[Site], faces: &mut Faces<'_>, mut vertices: [u32; 3]) -> Part {
    let ghosts = FACES_PER_VERTEX as u32 * vertices[0];
    let at = |vertex: u32| sites[vertex as usize].at();
    vertices.sort_unstable_by(|&a, &b| lexicographic(at(a), at(b)));
    let [a, b, c] = vertices;
    let hull = [a, b, c, b];
    faces.surround(ghosts, hull);
    for [there, back] in [[0, 3], [1, 2]] {
        faces.glue(edge_of(ghosts + there), edge_of(ghosts + back));
    }
    let [a, _, c, _] = Corner::around(hull, ghosts);
    Part::of(sites, &[a, c])
}
