//! Exact answers for every finite `f64`.
//!
//! Every question is a determinant of coordinate differences, and is settled in up to three stages:
//!
//! 1. **Filter.** The determinant in plain floating point with a bound on its error, one branch. The bound
//!    covers underflow, and overflow makes the comparison fail, so what passes is right on any input.
//! 2. **Adaptive** (`expansion`). Multi-term floating point (Shewchuk 1997), for coordinates whose
//!    exponents leave no room for overflow or underflow of any term.
//! 3. **Integer** (`scaled`). The coordinates as integers times one power of two; always right.
//!
//! The filter is inlined where the question is asked; the other stages are out of line and marked cold.
//!
//! # Source
//!
//! J. R. Shewchuk, *Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates*,
//! Discrete & Computational Geometry 18 (1997). The single-branch filter that covers underflow follows
//! K. Ozaki, F. Bünger, T. Ogita, S. Oishi, S. M. Rump, *Simple floating-point filters for the
//! two-dimensional orientation problem*, BIT 56 (2016).

mod boxed;
mod circle;
mod expansion;
mod integer;
mod lattice;
mod planar;
pub(crate) mod scaled;
mod spatial;

pub use boxed::{Boxed, Unit};
pub use lattice::Unrounded;

use crate::kernel::space::{Axis, Basis, Kernel3};
use crate::kernel::{InCircle, Kernel2, Stage};
use crate::points::{Point2, Point3};
use crate::sign::Sign;
use std::cmp::Ordering;

/// The kernel that is never wrong, for any finite coordinates: 1e300 and subnormals included.
///
/// ```
/// use geometry_core::{Exact, Kernel2, Sign};
/// // 0.3 is not three times 0.1 in binary, and the kernel knows.
/// assert_eq!(Exact.orient([0.0, 0.0], [0.1, 0.1], [0.3, 0.3]), Sign::Zero);
/// assert_ne!(Exact.orient([0.0, 0.0], [0.1, 0.3], [0.2, 0.6000000000000001]), Sign::Zero);
/// // Products of these overflow; the answer does not.
/// assert_eq!(Exact.orient([0.0, 0.0], [1e300, 1e300], [1e300, 1.1e300]), Sign::Positive);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

impl Kernel2 for Exact {
    #[inline(always)]
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        planar::cross(a, b, a, c)
    }

    #[inline(always)]
    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        let (sign, stage) = planar::cross(a, b, q, p);
        (sign.ordering(), stage)
    }
}

impl InCircle for Exact {
    #[inline(always)]
    fn in_circle_staged(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
        circle::in_circle(a, b, c, d)
    }
}

impl Kernel3 for Exact {
    fn basis(&self) -> Basis {
        Basis::Coordinates
    }

    #[inline(always)]
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        spatial::volume(a, b, c, a, d)
    }

    #[inline(always)]
    fn compare_height_staged(
        &self,
        [a, b, c]: [Point3; 3],
        p: Point3,
        q: Point3,
    ) -> (Ordering, Stage) {
        let (sign, stage) = spatial::volume(a, b, c, q, p);
        (sign.ordering(), stage)
    }

    #[inline(always)]
    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let [a, b, c] = [a, b, c].map(|p| axis.shadow_of(p));
        planar::cross(a, b, a, c)
    }
}

/// Half the distance from 1 to the next `f64`: the largest relative error of one rounding.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Bounds the relative error of adding the terms of an expansion (Shewchuk's result bound).
const RESULT: f64 = (3.0 + 8.0 * ROUNDING) * ROUNDING;

/// 2⁻¹⁰⁰⁰: enters a permanent wherever a product may underflow. Far more than any underflow error even after
/// multiplication by a filter's constant, and far less than any permanent that does not itself nearly underflow.
const UNDERFLOW: f64 = f64::from_bits((1023 - 1000) << 52);

/// Whether each coordinate is zero or has a magnitude in `smallest..=largest`.
#[inline(always)]
fn within(coordinates: &[f64], smallest: f64, largest: f64) -> bool {
    // Without short circuits: the answer is nearly always yes, and this way it takes a few vector operations.
    coordinates.iter().fold(true, |all, c| {
        let magnitude = c.abs();
        all & ((magnitude == 0.0) | ((magnitude >= smallest) & (magnitude <= largest)))
    })
}
