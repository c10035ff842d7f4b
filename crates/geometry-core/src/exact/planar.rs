//! Two questions of the plane, one determinant: (b-a) × (d-c).
//!
//! Orientation of a, b, p is the case c = a, d = p. The comparison of the distances of p and q from the line
//! a→b is the case c = q, d = p.

use super::{ROUNDING, scaled};
use crate::kernel::Stage;
use crate::points::Point2;
use crate::sign::Sign;

/// Bounds the error of the determinant relative to the sum of its two products: each product is of two
/// rounded differences and rounded itself, and so is the final difference (Shewchuk's bound A).
const FILTER: f64 = (3.0 + 16.0 * ROUNDING) * ROUNDING;

/// The sign of (b-a) × (d-c), and the stage that settled it.
///
/// The filter `|det| > FILTER · (|left + right| + MIN_POSITIVE)` is right on all finite input:
///
/// - if left and right have the same sign, it is Shewchuk's test; if not, no digits cancel and the sign of det
///   is that of the exact value;
/// - a product that underflows is off by at most 2⁻¹⁰⁷⁵, both by 2⁻¹⁰⁷⁴, which the term in MIN_POSITIVE
///   (times FILTER more than 2⁻¹⁰⁷³) covers; differences never underflow;
/// - a product or difference that overflows makes both sides infinite or NaN, and the test fails.
#[inline(always)]
pub(super) fn cross(a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
    let left = (b[0] - a[0]) * (d[1] - c[1]);
    let right = (b[1] - a[1]) * (d[0] - c[0]);
    let det = left - right;
    let bound = FILTER * ((left + right).abs() + f64::MIN_POSITIVE);
    if det.abs() > bound {
        let sign = if det > 0.0 {
            Sign::Positive
        } else {
            Sign::Negative
        };
        return (sign, Stage::Filter);
    }
    cross_closely(a, b, c, d)
}

#[cold]
#[inline(never)]
fn cross_closely(a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
    (scaled::cross(a, b, c, d), Stage::Integer)
}
