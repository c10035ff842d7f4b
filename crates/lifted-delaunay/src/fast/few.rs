//! Triangulations of two and of three points.

use super::part::{Corner, Part};
use super::rings::Rings;
use super::site::{Site, Sited};
use geometry_core::kernel::lexicographic;
use geometry_core::{Kernel2, Sign};

/// The edge between two distinct points.
#[inline(always)]
pub(super) fn edge(sites: &[Site], rings: &mut Rings<'_>, [a, b]: [u32; 2]) -> Part {
    let e = rings.allocate();
    rings.put_alone(e, a);
    rings.put_alone(e ^ 1, b);
    let corner = |vertex, out| Corner { vertex, out };
    Part::of(sites, &[corner(a, e), corner(b, e ^ 1)])
}

/// The triangle of three distinct points, or two edges if they are collinear.
#[inline(always)]
pub(super) fn triangle(
    sites: &[Site],
    rings: &mut Rings<'_>,
    kernel: &impl Kernel2,
    [a, b, c]: [u32; 3],
) -> Part {
    let [p, q, r] = [a, b, c].map(|vertex| sites[vertex as usize].at());
    let [a, b, c] = match kernel.orient(p, q, r) {
        Sign::Positive => [a, b, c],
        Sign::Negative => [a, c, b],
        Sign::Zero => return path(sites, rings, [a, b, c]),
    };
    let [ab, bc, ca] = [rings.allocate(), rings.allocate(), rings.allocate()];
    for (out, back, vertex) in [(ab, ca ^ 1, a), (bc, ab ^ 1, b), (ca, bc ^ 1, c)] {
        rings.put_alone(out, vertex);
        rings.put_after(back, out, vertex);
    }
    let corner = |vertex, out| Corner { vertex, out };
    Part::of(sites, &[corner(a, ab), corner(b, bc), corner(c, ca)])
}

/// Two edges from end to end.
fn path(sites: &[Site], rings: &mut Rings<'_>, mut vertices: [u32; 3]) -> Part {
    let at = |vertex: u32| sites[vertex as usize].at();
    vertices.sort_unstable_by(|&a, &b| lexicographic(at(a), at(b)));
    let [a, b, c] = vertices;
    let [ab, bc] = [rings.allocate(), rings.allocate()];
    rings.put_alone(ab, a);
    rings.put_alone(ab ^ 1, b);
    rings.put_after(bc, ab ^ 1, b);
    rings.put_alone(bc ^ 1, c);
    let corner = |vertex, out| Corner { vertex, out };
    Part::of(sites, &[corner(a, ab), corner(c, bc ^ 1)])
}
