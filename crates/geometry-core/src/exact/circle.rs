//! In-circle: whether d lies inside the circle through a, b, c.
//!
//! The determinant is the orientation in space of the points lifted to the paraboloid, with d as the origin:
//! rows (x, y, x² + y²) of a-d, b-d, c-d.

use super::expansion::{Expansion, difference_of_products, difference_tail};
use super::{RESULT, ROUNDING, UNDERFLOW, scaled, within};
use crate::kernel::Stage;
use crate::points::Point2;
use crate::sign::Sign;

/// Shewchuk's bound A, relative to the permanent.
pub(super) const FILTER: f64 = (10.0 + 96.0 * ROUNDING) * ROUNDING;

/// Bound B: only the differences are rounded.
const ROUNDED_DIFFERENCES: f64 = (4.0 + 48.0 * ROUNDING) * ROUNDING;

/// Bound C: the roundoff of the differences added to first order.
const FIRST_ORDER: f64 = (44.0 + 576.0 * ROUNDING) * ROUNDING * ROUNDING;

/// Magnitudes for which no term of the adaptive stage overflows or loses a bit: a product of four differences
/// is a multiple of 2^(4·(-210-52)) ≥ 2^-1074 and below 2^(4·252).
const SMALLEST: f64 = f64::from_bits((1023 - 210) << 52);
const LARGEST: f64 = f64::from_bits((1023 + 250) << 52);

/// The sign of the in-circle determinant, and the stage that settled it.
///
/// The filter is right on all finite input: each product that underflows is off by at most 2⁻¹⁰⁷⁵ times the
/// factors it is multiplied by, and [`UNDERFLOW`] enters the permanent in each of those places; overflow makes
/// the permanent, which is never less than |det|, infinite or NaN.
#[inline(always)]
pub(super) fn in_circle(a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
    let u = [a[0] - d[0], a[1] - d[1]];
    let v = [b[0] - d[0], b[1] - d[1]];
    let w = [c[0] - d[0], c[1] - d[1]];
    let (vw, wv) = (v[0] * w[1], v[1] * w[0]);
    let (wu, uw) = (w[0] * u[1], w[1] * u[0]);
    let (uv, vu) = (u[0] * v[1], u[1] * v[0]);
    let [u_lift, v_lift, w_lift] = [u, v, w].map(|p| p[0] * p[0] + p[1] * p[1]);
    let det = u_lift * (vw - wv) + v_lift * (wu - uw) + w_lift * (uv - vu);
    let permanent = (u_lift + UNDERFLOW) * (vw.abs() + wv.abs() + UNDERFLOW)
        + (v_lift + UNDERFLOW) * (wu.abs() + uw.abs() + UNDERFLOW)
        + (w_lift + UNDERFLOW) * (uv.abs() + vu.abs() + UNDERFLOW)
        + UNDERFLOW;
    if det.abs() > FILTER * permanent {
        let sign = if det > 0.0 {
            Sign::Positive
        } else {
            Sign::Negative
        };
        return (sign, Stage::Filter);
    }
    in_circle_closely(a, b, c, d, permanent)
}

/// The determinant as [`in_circle`] rounds it, alone.
#[inline(always)]
pub(super) fn rounded_determinant(a: Point2, b: Point2, c: Point2, d: Point2) -> f64 {
    let u = [a[0] - d[0], a[1] - d[1]];
    let v = [b[0] - d[0], b[1] - d[1]];
    let w = [c[0] - d[0], c[1] - d[1]];
    let [u_lift, v_lift, w_lift] = [u, v, w].map(|p| p[0] * p[0] + p[1] * p[1]);
    u_lift * (v[0] * w[1] - v[1] * w[0])
        + v_lift * (w[0] * u[1] - w[1] * u[0])
        + w_lift * (u[0] * v[1] - u[1] * v[0])
}

/// The permanent of [`in_circle`] at differences of `width` and `height`, the largest of all points in such a box.
#[inline(always)]
pub(super) fn largest_permanent(width: f64, height: f64) -> f64 {
    let lift = width * width + height * height;
    let minor = width * height;
    let term = (lift + UNDERFLOW) * (minor + minor + UNDERFLOW);
    term + term + term + UNDERFLOW
}

#[cold]
#[inline(never)]
fn in_circle_closely(a: Point2, b: Point2, c: Point2, d: Point2, permanent: f64) -> (Sign, Stage) {
    if within([a, b, c, d].as_flattened(), SMALLEST, LARGEST)
        && let Some(sign) = in_circle_adaptively(a, b, c, d, permanent)
    {
        return (sign, Stage::Adaptive);
    }
    (scaled::in_circle(a, b, c, d), Stage::Integer)
}

/// Shewchuk's stages B and C. What they leave open goes to the integers, which are faster here than the
/// thousand-term sum of his stage D.
fn in_circle_adaptively(
    a: Point2,
    b: Point2,
    c: Point2,
    d: Point2,
    permanent: f64,
) -> Option<Sign> {
    let [u, v, w] = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1]]);
    let first = lift_times_minor(u, v, w);
    let second = lift_times_minor(v, w, u);
    let third = lift_times_minor(w, u, v);
    let rounded: Expansion<64> = first.plus(&second);
    let rounded: Expansion<96> = rounded.plus(&third);

    let tail = |p: Point2, rounded: Point2| [0, 1].map(|i| difference_tail(p[i], d[i], rounded[i]));
    let [u_tail, v_tail, w_tail] = [tail(a, u), tail(b, v), tail(c, w)];
    if [u_tail, v_tail, w_tail]
        .as_flattened()
        .iter()
        .all(|&t| t == 0.0)
    {
        return Some(rounded.sign());
    }
    let mut det = rounded.estimate();
    if det.abs() > ROUNDED_DIFFERENCES * permanent {
        return Some(Sign::of(det));
    }
    let bound = FIRST_ORDER * permanent + RESULT * det.abs();
    // The derivative of |p|²·(q × r) in the tails.
    let first_order =
        |[p, p_tail]: [Point2; 2], [q, q_tail]: [Point2; 2], [r, r_tail]: [Point2; 2]| {
            let minor_tail =
                (q[0] * r_tail[1] + r[1] * q_tail[0]) - (q[1] * r_tail[0] + r[0] * q_tail[1]);
            let lift_tail = 2.0 * (p[0] * p_tail[0] + p[1] * p_tail[1]);
            (p[0] * p[0] + p[1] * p[1]) * minor_tail + lift_tail * (q[0] * r[1] - q[1] * r[0])
        };
    let [u, v, w] = [[u, u_tail], [v, v_tail], [w, w_tail]];
    det += first_order(u, v, w) + first_order(v, w, u) + first_order(w, u, v);
    (det.abs() > bound).then(|| Sign::of(det))
}

/// |p|² · (q × r), exactly.
fn lift_times_minor(p: Point2, q: Point2, r: Point2) -> Expansion<32> {
    let minor = difference_of_products(q[0], r[1], q[1], r[0]);
    let square = |x: f64| -> Expansion<16> {
        let once: Expansion<8> = minor.times(x);
        once.times(x)
    };
    square(p[0]).plus(&square(p[1]))
}
