//! Points of the plane asked about as if lifted to the paraboloid z = x² + y².
//!
//! The Delaunay triangulation of points of the plane is the lower hull of the lifted points, and the orientation
//! of four lifted points *is* the in-circle question about the points themselves. Computing x² + y² rounds, and the
//! rounded points leave the paraboloid: an exact answer about them answers the wrong question. Here no height is
//! ever computed; the third coordinate of a point is not looked at.

use super::space::{Axis, Kernel3};
use super::{InCircle, Kernel2, Stage};
use crate::exact::scaled;
use crate::points::{Point2, Point3};
use crate::sign::Sign;
use std::cmp::Ordering;

/// Answers about (x, y, z) as if z were x² + y² without rounding. `K` must be exact.
///
/// Under [`Perturbed`](crate::Perturbed), ask for shadows along Z only: a tie along X or Y would be broken by the
/// third coordinate as it is given.
///
/// ```
/// use geometry_core::{Exact, Kernel3, Lifted, Sign};
/// let kernel = Lifted(Exact);
/// // Four corners of a square are cocircular, so their lifts are coplanar, wherever the square is.
/// let corner = |x: f64, y: f64| [1e7 + x, 1e7 + y, 0.0];
/// let [a, b, c, d] = [corner(0.0, 0.0), corner(0.1, 0.0), corner(0.1, 0.1), corner(0.0, 0.1)];
/// assert_eq!(kernel.orient3(a, b, c, d), Sign::Zero);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Lifted<K>(pub K);

fn flat(p: Point3) -> Point2 {
    [p[0], p[1]]
}

impl<K: Kernel2 + InCircle> Kernel3 for Lifted<K> {
    /// A point inside the circle lies below the plane of the lifted circle.
    #[inline(always)]
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        let (sign, stage) = self.0.in_circle_staged(flat(a), flat(b), flat(c), flat(d));
        (-sign, stage)
    }

    fn compare_height_staged(
        &self,
        [a, b, c]: [Point3; 3],
        p: Point3,
        q: Point3,
    ) -> (Ordering, Stage) {
        let sign = scaled::lifted_volume([a, b, c, q, p].map(flat));
        (sign.ordering(), Stage::Integer)
    }

    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let [a, b, c] = [a, b, c].map(flat);
        match axis {
            Axis::Z => self.0.orient_staged(a, b, c),
            Axis::X => (scaled::lifted_shadow(a, b, c, 1), Stage::Integer),
            // The shadow is (z, x), the mirror image of (x, z).
            Axis::Y => (-scaled::lifted_shadow(a, b, c, 0), Stage::Integer),
        }
    }

    /// Lifted points are copies exactly if the points of the plane are.
    #[inline(always)]
    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        self.0.lexicographic(flat(a), flat(b))
    }
}
