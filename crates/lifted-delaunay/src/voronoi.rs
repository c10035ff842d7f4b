//! The Voronoi diagram as the dual of a Delaunay triangulation.
//!
//! Each triangle becomes a vertex, the centre of its circumcircle; each edge between two triangles an edge between
//! their vertices, equally far from the two points it separates; each edge of the outline a ray.
//!
//! ```text
//!            p            p, q        two points, a Delaunay edge
//!          / | \          L, R        the circumcentres of the triangles on its left and right
//!         /  |  \
//!        / L-+-R \        L R         the Voronoi edge between p and q
//!         \  |  /
//!          \ | /
//!            q
//! ```
//!
//! The combinatorics are those of the triangulation, exact. The places of the vertices are rounded, and round badly for
//! triangles that are nearly flat, whose circumcentres are far away. Where more than three points are cocircular,
//! several vertices stand in one place, up to rounding, joined by edges of no length. Collinear points have no
//! triangles, so the parallel lines that separate them are not represented.

use geometry_core::{Point2, Points, Triangulation};
use std::collections::BTreeMap;

/// An edge of a Voronoi diagram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VoronoiEdge {
    /// Between two vertices.
    Segment {
        /// The two points that it separates, smaller index first.
        sites: [u32; 2],
        /// The vertices at its ends: to the left of the way from the first point to the second, and to the right.
        ends: [u32; 2],
    },
    /// From a vertex without end.
    Ray {
        /// The two points that it separates, in the order in which they follow each other anticlockwise on the outline.
        sites: [u32; 2],
        /// The vertex where it begins.
        start: u32,
        /// Where it goes: outward, at right angles to the way from the first point to the second, and as long as
        /// that way. Rounded; infinite where a difference of coordinates overflows.
        direction: Point2,
    },
}

impl VoronoiEdge {
    /// The two points that it separates.
    pub fn sites(&self) -> [u32; 2] {
        match *self {
            VoronoiEdge::Segment { sites, .. } | VoronoiEdge::Ray { sites, .. } => sites,
        }
    }
}

/// The Voronoi diagram of a point set.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Voronoi {
    /// The circumcentre of each Delaunay triangle, in the order of [`Triangulation::triangles`].
    pub vertices: Vec<Point2>,
    /// One edge for each edge of the triangulation, in the order of [`Triangulation::edges`].
    pub edges: Vec<VoronoiEdge>,
}

impl Voronoi {
    /// The dual of the Delaunay triangulation of `points`.
    ///
    /// # Cost
    ///
    /// O(t log t) time and O(t) space for t triangles.
    ///
    /// # Panics
    ///
    /// If the triangulation names a point that is not in `points`.
    ///
    /// ```
    /// use geometry_core::{Points, Triangulation};
    /// use lifted_delaunay::{Voronoi, VoronoiEdge};
    /// let kite = [[0.0, 0.0], [1.0, -1.0], [4.0, 0.0], [1.0, 1.0]];
    /// let triangulation = Triangulation::new(vec![[0, 1, 3], [1, 2, 3]]);
    /// let voronoi = Voronoi::of(Points::new(&kite)?, &triangulation);
    /// assert_eq!(voronoi.vertices[0], [1.0, 0.0]);
    /// assert!((voronoi.vertices[1][0] - 7.0 / 3.0).abs() < 1e-15);
    /// assert_eq!(voronoi.edges.len(), 5);
    /// // Between 1 and 3; going up from 1 to 3 the triangle on the left is the first.
    /// assert_eq!(voronoi.edges[3], VoronoiEdge::Segment { sites: [1, 3], ends: [0, 1] });
    /// # Ok::<(), geometry_core::HullError>(())
    /// ```
    pub fn of(points: Points<'_, 2>, triangulation: &Triangulation) -> Self {
        let centres = triangulation.triangles().iter();
        Self {
            vertices: centres
                .map(|corners| circumcentre(corners.map(|id| points[id])))
                .collect(),
            edges: edges(points, triangulation),
        }
    }
}

fn edges(points: Points<'_, 2>, triangulation: &Triangulation) -> Vec<VoronoiEdge> {
    // The triangle on the left of the way from the smaller index to the larger, and the one on the right.
    let mut sides: BTreeMap<[u32; 2], [Option<u32>; 2]> = BTreeMap::new();
    for (number, &[a, b, c]) in (0..).zip(triangulation.triangles()) {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let side = usize::from(from > to);
            sides.entry([from.min(to), from.max(to)]).or_default()[side] = Some(number);
        }
    }
    let ray = |[from, to]: [u32; 2], start| {
        let (p, q) = (points[from], points[to]);
        VoronoiEdge::Ray {
            sites: [from, to],
            start,
            direction: [q[1] - p[1], p[0] - q[0]],
        }
    };
    sides
        .into_iter()
        .filter_map(|([low, high], sides)| match sides {
            [Some(left), Some(right)] => Some(VoronoiEdge::Segment {
                sites: [low, high],
                ends: [left, right],
            }),
            [Some(start), None] => Some(ray([low, high], start)),
            [None, Some(start)] => Some(ray([high, low], start)),
            [None, None] => None,
        })
        .collect()
}

/// The centre of the circle through three points, rounded.
///
/// Differences are taken first and scaled by a power of two, so that no magnitude of the coordinates alone makes it
/// overflow or underflow; a triangle that is flat to rounding may still have an infinite centre or none (NaN).
fn circumcentre([a, b, c]: [Point2; 3]) -> Point2 {
    // Halves, because the difference of two large coordinates may overflow.
    let half_difference = |p: Point2, q: Point2| [p[0] / 2.0 - q[0] / 2.0, p[1] / 2.0 - q[1] / 2.0];
    let (u, v) = (half_difference(b, a), half_difference(c, a));
    let largest = [u, v]
        .as_flattened()
        .iter()
        .fold(0.0_f64, |m, x| m.max(x.abs()));
    let scale = power_of_two_near(largest);
    let (u, v) = (u.map(|x| x / scale), v.map(|x| x / scale));
    let (uu, vv) = (u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]);
    let doubled_area = u[0] * v[1] - u[1] * v[0];
    let offset = [
        (v[1] * uu - u[1] * vv) / doubled_area,
        (u[0] * vv - v[0] * uu) / doubled_area,
    ];
    // From the first point it is half of the quotient, in units of twice the scale.
    [a[0] + offset[0] * scale, a[1] + offset[1] * scale]
}

/// The largest power of two that is not greater than `x`; the smallest normal one if `x` is less.
fn power_of_two_near(x: f64) -> f64 {
    f64::from_bits(x.max(f64::MIN_POSITIVE).to_bits() & f64::INFINITY.to_bits())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_centre_of_a_right_angle_is_the_middle_of_its_hypotenuse() {
        for scale in [1.0, 1e300, 1e-300, 1e-320] {
            let corners = [[0.0, 0.0], [8.0 * scale, 0.0], [0.0, 6.0 * scale]];
            let [x, y] = circumcentre(corners);
            let error = (x / scale - 4.0).abs() + (y / scale - 3.0).abs();
            assert!(error < 1e-3, "at {scale}: {x}, {y}");
        }
        let largest = circumcentre([
            [-f64::MAX, -f64::MAX],
            [f64::MAX, -f64::MAX],
            [-f64::MAX, f64::MAX],
        ]);
        assert_eq!(largest, [0.0, 0.0]);
    }

    #[test]
    fn rays_leave_the_outline() {
        let triangle = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        let points = Points::new(&triangle).expect("finite points");
        let voronoi = Voronoi::of(points, &Triangulation::new(vec![[0, 1, 2]]));
        assert_eq!(voronoi.vertices, [[2.0, 2.0]]);
        let rays: Vec<_> = voronoi
            .edges
            .iter()
            .map(|edge| match *edge {
                VoronoiEdge::Ray {
                    sites,
                    start,
                    direction,
                } => (sites, start, direction),
                VoronoiEdge::Segment { .. } => panic!("one triangle has no inner edge"),
            })
            .collect();
        assert_eq!(
            rays,
            [
                ([0, 1], 0, [0.0, -4.0]),
                ([2, 0], 0, [-4.0, 0.0]),
                ([1, 2], 0, [4.0, 4.0])
            ]
        );
    }
}
