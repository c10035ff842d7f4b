//! Two questions of the plane, one determinant: (b-a) × (d-c).
//!
//! Orientation of a, b, p is the case c = a, d = p. The comparison of the distances of p and q from the line
//! a→b is the case c = q, d = p.

use super::expansion::{Expansion, difference_of_products, difference_tail};
use super::{RESULT, ROUNDING, scaled, within};
use crate::kernel::Stage;
use crate::points::Point2;
use crate::sign::Sign;

/// Bounds the error of the determinant relative to the sum of its two products: each product is of two
/// rounded differences and rounded itself, and so is the final difference (Shewchuk's bound A).
pub(super) const FILTER: f64 = (3.0 + 16.0 * ROUNDING) * ROUNDING;

/// The same when only the differences are rounded (bound B).
const ROUNDED_DIFFERENCES: f64 = (2.0 + 12.0 * ROUNDING) * ROUNDING;

/// The same when the roundoff of the differences has been added to first order (bound C).
const FIRST_ORDER: f64 = (9.0 + 64.0 * ROUNDING) * ROUNDING * ROUNDING;

/// Magnitudes for which no term of the adaptive stage overflows or loses a bit: a product of two differences
/// is a multiple of 2^(2·(-480-52)) ≥ 2^-1074 and below 2^(2·502).
const SMALLEST: f64 = f64::from_bits((1023 - 480) << 52);
const LARGEST: f64 = f64::from_bits((1023 + 500) << 52);

/// The sign of (b-a) × (d-c), and the stage that settled it.
///
/// The filter `|det| > FILTER · (|left + right| + MIN_POSITIVE)` is right on all finite input:
///
/// - if left and right have the same sign, it is Shewchuk's test; if not, no digits cancel and the sign of det
///   is that of the exact value;
/// - a product that underflows is off by at most 2⁻¹⁰⁷⁵, both by 2⁻¹⁰⁷⁴, which the term in MIN_POSITIVE
///   (times FILTER more than 2⁻¹⁰⁷³) covers; differences never underflow;
/// - a product or difference that overflows makes the bound infinite or NaN, and the test fails, except where
///   left and right have opposite signs and det is right in any case.
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
    cross_closely(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1])
}

/// Takes numbers rather than points: arrays go by reference, and every inlined filter would keep a copy of its
/// points in memory to refer to.
#[cold]
#[inline(never)]
#[allow(clippy::too_many_arguments)]
fn cross_closely(
    ax: f64,
    ay: f64,
    bx: f64,
    by: f64,
    cx: f64,
    cy: f64,
    dx: f64,
    dy: f64,
) -> (Sign, Stage) {
    let [a, b, c, d] = [[ax, ay], [bx, by], [cx, cy], [dx, dy]];
    if within([a, b, c, d].as_flattened(), SMALLEST, LARGEST) {
        (cross_adaptively(a, b, c, d), Stage::Adaptive)
    } else {
        (scaled::cross(a, b, c, d), Stage::Integer)
    }
}

/// Shewchuk's stages B, C and D. `u` is b-a, `v` is d-c, each a rounded difference and its tail.
fn cross_adaptively(a: Point2, b: Point2, c: Point2, d: Point2) -> Sign {
    let [u, v] = [[b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]];
    // A rounded difference is zero only if the exact one is: on level and upright lines, nothing is left to do.
    let is_zero = |p: f64, q: f64| p == 0.0 || q == 0.0;
    if is_zero(u[0], v[1]) && is_zero(u[1], v[0]) {
        return Sign::Zero;
    }
    let rounded = difference_of_products(u[0], v[1], u[1], v[0]);
    let u_tail = [
        difference_tail(b[0], a[0], u[0]),
        difference_tail(b[1], a[1], u[1]),
    ];
    let v_tail = [
        difference_tail(d[0], c[0], v[0]),
        difference_tail(d[1], c[1], v[1]),
    ];
    if [u_tail, v_tail]
        .as_flattened()
        .iter()
        .all(|&tail| tail == 0.0)
    {
        return rounded.sign();
    }
    let magnitude = (u[0] * v[1]).abs() + (u[1] * v[0]).abs();
    let mut det = rounded.estimate();
    if det.abs() > ROUNDED_DIFFERENCES * magnitude {
        return Sign::of(det);
    }
    let bound = FIRST_ORDER * magnitude + RESULT * det.abs();
    det += (u[0] * v_tail[1] + v[1] * u_tail[0]) - (u[1] * v_tail[0] + v[0] * u_tail[1]);
    if det.abs() > bound {
        return Sign::of(det);
    }
    let first = difference_of_products(u_tail[0], v[1], u_tail[1], v[0]);
    let second = difference_of_products(u[0], v_tail[1], u[1], v_tail[0]);
    let third = difference_of_products(u_tail[0], v_tail[1], u_tail[1], v_tail[0]);
    let sum: Expansion<8> = rounded.plus(&first);
    let sum: Expansion<12> = sum.plus(&second);
    let sum: Expansion<16> = sum.plus(&third);
    sum.sign()
}
