//! Which facets of one hull have all points of another strictly below their planes.
//!
//! From facet to facet the normal turns a little, and so does the corner of the other hull that is furthest along it. It is
//! found by walking up: from a corner to the neighbour that is highest, until none is higher. On a convex surface that corner
//! is the highest of all.
//!
//! ```text
//!           n
//!      \    |    /           f  a facet, n its normal
//!       \___|___/            v  the corner of the other hull that is highest along n;
//!           f                   from there the walk for the next facet begins
//!            . - v - .
//!         .             .
//! ```
//!
//! # Proof
//!
//! Let n be the normal of a facet *as rounded*, and b its [bound](Plane), for points of both hulls. What is computed of n · (q - p)
//! is off by less than b.
//!
//! 1. Where it is at most -b for all neighbours q of v, and a number (a difference may overflow), these are not higher than v
//!    along n. They span the cone of the hull at v, even where triangles are coplanar or v is not extreme, so no point of the hull is
//!    higher.
//! 2. Then, for every point, n · (p - a) is at most that of v, which is below what is computed of it plus b. The height over the
//!    exact plane differs from that by less than b again. So below -4 b there is no doubt.
//! 3. A step goes up, by more than b as computed, so it does in truth, and a walk ends.
//!
//! For most facets it is enough to ask about the box around the other hull, of which a corner is highest along n.
//!
//! Where rounding leaves it open, a facet is not said to have all points below.

use super::plane::{Plane, Span};
use geometry_core::Point3;
use geometry_core::mesh::{SideId, TriMesh, TriangleId};

/// A surface with a way from each corner to its neighbours.
#[derive(Debug)]
pub(super) struct Stars<'a> {
    mesh: &'a TriMesh,
    /// A side from each corner; [`NOWHERE`] from other points.
    spokes: Vec<SideId>,
}

const NOWHERE: SideId = SideId(u32::MAX);

impl<'a> Stars<'a> {
    /// Those of `mesh`, whose corners are numbers below `count`.
    pub(super) fn of(mesh: &'a TriMesh, count: usize) -> Self {
        let mut spokes = vec![NOWHERE; count];
        for triangle in mesh.triangles() {
            for (side, origin) in triangle.sides().into_iter().zip(mesh.corners(triangle)) {
                spokes[origin as usize] = side;
            }
        }
        Self { mesh, spokes }
    }

    /// The sides from `corner`, in clockwise order round it; none if it is not a corner.
    pub(super) fn sides(&self, corner: u32) -> impl Iterator<Item = SideId> + '_ {
        let first = self.spokes[corner as usize];
        let mut next = (first != NOWHERE).then_some(first);
        std::iter::from_fn(move || {
            let side = next?;
            let following = self.mesh.next_around(side);
            next = (following != first).then_some(following);
            Some(side)
        })
    }

    fn any_corner(&self) -> Option<u32> {
        self.mesh
            .triangles()
            .next()
            .map(|t| self.mesh.corners(t)[0])
    }
}

/// What a walk came to.
struct Top {
    corner: u32,
    is_certain: bool,
}

/// Walks up from `corner` along the normal of the plane.
fn climb(plane: &Plane, points: &[Point3], stars: &Stars, mut corner: u32) -> Top {
    loop {
        let at = points[corner as usize];
        let (mut best, mut greatest, mut is_number) = (corner, f64::NEG_INFINITY, true);
        for side in stars.sides(corner) {
            let neighbour = stars.mesh.target(side);
            let rise = plane.rise(at, points[neighbour as usize]);
            is_number &= !rise.is_nan();
            if rise > greatest {
                (best, greatest) = (neighbour, rise);
            }
        }
        if plane.is_surely_up(greatest) {
            corner = best;
        } else {
            let is_certain = is_number && plane.is_surely_not_up(greatest);
            return Top { corner, is_certain };
        }
    }
}

/// For each slot of `mesh`, whether it holds a facet with all points of the other hull strictly below; in doubt it does not.
///
/// `plane` gives the plane of a facet, with a bound for all points of both.
pub(super) fn facets_above(
    mesh: &TriMesh,
    plane: impl Fn(TriangleId) -> Plane,
    other_points: &[Point3],
    other: &Stars,
) -> Vec<bool> {
    let mut is_above = vec![false; mesh.slots()];
    let (Some(start), Some(corner)) = (mesh.triangles().next(), other.any_corner()) else {
        return is_above;
    };
    let around = Span::of(other_points);
    let mut is_met = vec![false; mesh.slots()];
    is_met[start.0 as usize] = true;
    let mut to_visit = vec![(start, corner)];
    while let Some((facet, mut corner)) = to_visit.pop() {
        let plane = plane(facet);
        let height = plane.height(plane.highest_corner(&around));
        is_above[facet.0 as usize] = plane.is_surely_beneath(height) || {
            let top = climb(&plane, other_points, other, corner);
            corner = top.corner;
            let height = plane.height(other_points[corner as usize]);
            top.is_certain && plane.is_surely_beneath(height)
        };
        for twin in mesh.twins(facet) {
            let neighbour = twin.triangle();
            if !std::mem::replace(&mut is_met[neighbour.0 as usize], true) {
                to_visit.push((neighbour, corner));
            }
        }
    }
    is_above
}

#[cfg(test)]
mod tests {
    use super::super::surface::{Surface, surface};
    use super::*;
    use geometry_core::{Exact, HullError, Kernel3, Points, Silent};
    use hull_verify::families_space::{grids, random};

    /// What is said of the facets of `near`, against the exact answers; how many are said to have all of `far` below.
    fn count_right(near: &[Point3], far: &[Point3]) -> Result<usize, HullError> {
        let mesh_of = |points| {
            let surface = surface(Points::new(points)?, &Exact, &mut Silent)?;
            let Surface::Solid(mesh, _) = surface else {
                panic!("flat");
            };
            Ok(mesh)
        };
        let (mesh, other) = (mesh_of(near)?, mesh_of(far)?);
        let span = Span::of(&[near, far].concat());
        let corners = |facet| mesh.corners(facet).map(|id| near[id as usize]);
        let plane = |facet| Plane::through(corners(facet), &span);
        let is_above = facets_above(&mesh, plane, far, &Stars::of(&other, far.len()));
        for facet in mesh.triangles().filter(|t| is_above[t.0 as usize]) {
            let [a, b, c] = corners(facet);
            assert!(far.iter().all(|&p| Exact.orient3(a, b, c, p).is_negative()));
        }
        Ok(is_above.into_iter().filter(|&it| it).count())
    }

    #[test]
    fn facets_said_to_be_above_are() -> Result<(), HullError> {
        let halves = |points: Vec<Point3>, at: f64| points.into_iter().partition(|p| p[0] < at);
        let (near, far): (Vec<_>, Vec<_>) = halves(random::ball(1, 3_000), 0.0);
        assert!(count_right(&near, &far)? > 100);
        // All facets of half a cube but one lie in planes with points of the other half, or face it.
        let (near, far): (Vec<_>, Vec<_>) = halves(grids::lattice(8), 4.0);
        assert_eq!(count_right(&near, &far)?, 2);
        Ok(())
    }

    /// The difference to the corner that is higher overflows, and times a normal without that component it is no number.
    #[test]
    fn a_rise_that_is_not_a_number_leaves_it_open() {
        let points = [
            [-f64::MAX, 0.0, 0.0],
            [f64::MAX, 0.0, 5.0],
            [-f64::MAX, 1.0, -1.0],
            [-f64::MAX, 0.0, -2.0],
        ];
        let upward = [[0.0, 0.0, 9.0], [1.0, 0.0, 9.0], [0.0, 1.0, 9.0]];
        let plane = Plane::through(upward, &Span::of(&points));
        let mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
        let stars = Stars::of(&mesh, points.len());
        assert!(plane.rise(points[0], points[1]).is_nan());
        assert!(!climb(&plane, &points, &stars, 0).is_certain);
    }
}
