//! The arithmetic of 1979: areas below a tolerance count as zero, in a chosen number format.
//!
//! Green and Silverman (1979, section 3) compute the area of a triangle in single precision and take areas
//! numerically less than ε for zero. [`Tolerance`] does that in any [`Format`]; [`formats`] holds those of
//! the machines of their Table 1 and those of today.
//!
//! This kernel exists to reproduce published behaviour. Its answers may contradict each other.

pub mod formats;
pub mod soft;

use crate::kernel::{Kernel2, Stage};
use crate::points::Point2;
use crate::sign::Sign;
use formats::Format;
use std::cmp::Ordering;
use std::marker::PhantomData;

/// Answers in the number format `F`, areas of magnitude below `epsilon` counted as zero.
///
/// ```
/// use geometry_core::tolerance::formats::Single;
/// use geometry_core::{Kernel2, Sign, Tolerance};
/// let kernel = Tolerance::<Single>::new(1e-4);
/// assert_eq!(kernel.orient([0.0, 0.0], [1.0, 0.0], [0.5, 1e-5]), Sign::Zero);
/// assert_eq!(kernel.orient([0.0, 0.0], [1.0, 0.0], [0.5, 1e-3]), Sign::Positive);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Tolerance<F> {
    epsilon: f64,
    format: PhantomData<F>,
}

impl<F: Format> Tolerance<F> {
    /// The kernel with tolerance `epsilon` (an area, in the square of the unit of the coordinates).
    pub fn new(epsilon: f64) -> Self {
        Self {
            epsilon,
            format: PhantomData,
        }
    }

    /// The area of the triangle abc as this format computes it, positive if anticlockwise.
    pub fn area(&self, a: Point2, b: Point2, c: Point2) -> f64 {
        let [a, b, c] = [a, b, c].map(|p| p.map(F::of));
        let left = b[0].minus(a[0]).times(c[1].minus(a[1]));
        let right = b[1].minus(a[1]).times(c[0].minus(a[0]));
        left.minus(right).times(F::of(0.5)).to_f64()
    }
}

impl<F: Format> Kernel2 for Tolerance<F> {
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        let area = self.area(a, b, c);
        let sign = if area.abs() < self.epsilon {
            Sign::Zero
        } else {
            Sign::of(area)
        };
        (sign, Stage::Filter)
    }

    /// Compares the computed areas, as the paper does when it looks for the most negative one.
    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        (
            self.area(a, b, p).total_cmp(&self.area(a, b, q)),
            Stage::Filter,
        )
    }

    /// By the coordinate in which a and b differ more: the paper's "appropriate coordinate".
    fn compare_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        let [from, to] = [a, b].map(|p| p.map(F::of));
        let [p, q] = [p, q].map(|p| p.map(|x| F::of(x).to_f64()));
        let extent = [0, 1].map(|axis| to[axis].minus(from[axis]).to_f64());
        let axis = usize::from(extent[1].abs() > extent[0].abs());
        let forward = p[axis].total_cmp(&q[axis]);
        if extent[axis] < 0.0 {
            forward.reverse()
        } else {
            forward
        }
    }

    fn lexicographic(&self, a: Point2, b: Point2) -> Ordering {
        crate::kernel::lexicographic(a.map(|x| F::of(x).to_f64()), b.map(|x| F::of(x).to_f64()))
    }

    /// By the polar angle itself, so that the order is total however the tolerance is chosen.
    fn compare_angle(&self, center: Point2, a: Point2, b: Point2) -> Ordering {
        let angle = |p: Point2| {
            let [x, y] = [0, 1].map(|axis| F::of(p[axis]).minus(F::of(center[axis])).to_f64());
            if x == 0.0 && y == 0.0 {
                return f64::NEG_INFINITY;
            }
            let angle = y.atan2(x);
            let from_below = if angle <= -std::f64::consts::FRAC_PI_2 {
                angle + std::f64::consts::TAU
            } else {
                angle
            };
            F::of(from_below).to_f64()
        };
        angle(a).total_cmp(&angle(b))
    }
}
