//! Two questions of space, one determinant: (b-a) × (c-a) · (q-p).
//!
//! Orientation of a, b, c, d is the case p = a, q = d. The comparison of the heights of two points over the plane
//! abc is the determinant itself.

use super::expansion::{Expansion, difference_of_products, difference_tail};
use super::{RESULT, ROUNDING, UNDERFLOW, scaled, within};
use crate::kernel::Stage;
use crate::points::Point3;
use crate::sign::Sign;

/// Shewchuk's bound A, relative to the permanent.
const FILTER: f64 = (7.0 + 56.0 * ROUNDING) * ROUNDING;

/// Bound B: only the differences are rounded.
const ROUNDED_DIFFERENCES: f64 = (3.0 + 28.0 * ROUNDING) * ROUNDING;

/// Bound C: the roundoff of the differences added to first order.
const FIRST_ORDER: f64 = (26.0 + 288.0 * ROUNDING) * ROUNDING * ROUNDING;

/// Magnitudes for which no term of the adaptive stage overflows or loses a bit: a product of three differences
/// is a multiple of 2^(3·(-300-52)) ≥ 2^-1074 and below 2^(3·332).
const SMALLEST: f64 = f64::from_bits((1023 - 300) << 52);
const LARGEST: f64 = f64::from_bits((1023 + 330) << 52);

/// The sign of (b-a) × (c-a) · (q-p), and the stage that settled it.
///
/// The filter is right on all finite input: each product that underflows is off by at most 2⁻¹⁰⁷⁵, times the
/// third factor where it is one of the inner products, and [`UNDERFLOW`] enters the permanent in each of those
/// places; overflow makes the permanent, which is never less than |det|, infinite or NaN.
#[inline(always)]
pub(super) fn volume(a: Point3, b: Point3, c: Point3, p: Point3, q: Point3) -> (Sign, Stage) {
    let u = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    let v = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    let w = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
    let (vw, wv) = (v[0] * w[1], v[1] * w[0]);
    let (wu, uw) = (w[0] * u[1], w[1] * u[0]);
    let (uv, vu) = (u[0] * v[1], u[1] * v[0]);
    let det = u[2] * (vw - wv) + v[2] * (wu - uw) + w[2] * (uv - vu);
    let permanent = u[2].abs() * (vw.abs() + wv.abs() + UNDERFLOW)
        + v[2].abs() * (wu.abs() + uw.abs() + UNDERFLOW)
        + w[2].abs() * (uv.abs() + vu.abs() + UNDERFLOW)
        + UNDERFLOW;
    if det.abs() > FILTER * permanent {
        let sign = if det > 0.0 {
            Sign::Positive
        } else {
            Sign::Negative
        };
        return (sign, Stage::Filter);
    }
    volume_closely([a, b, c, p, q], permanent)
}

#[cold]
#[inline(never)]
fn volume_closely(points: [Point3; 5], permanent: f64) -> (Sign, Stage) {
    if within(points.as_flattened(), SMALLEST, LARGEST)
        && let Some(sign) = volume_adaptively(points, permanent)
    {
        return (sign, Stage::Adaptive);
    }
    (scaled::volume(points), Stage::Integer)
}

/// Shewchuk's stages B and C. What they leave open goes to the integers, which at these lengths are as fast
/// as his stage D.
fn volume_adaptively([a, b, c, p, q]: [Point3; 5], permanent: f64) -> Option<Sign> {
    let difference =
        |to: Point3, from: Point3| std::array::from_fn::<f64, 3, _>(|i| to[i] - from[i]);
    let [u, v, w] = [difference(b, a), difference(c, a), difference(q, p)];
    let minor = |p: &Point3, q: &Point3| difference_of_products(p[0], q[1], p[1], q[0]);
    let first: Expansion<8> = minor(&v, &w).times(u[2]);
    let second: Expansion<8> = minor(&w, &u).times(v[2]);
    let third: Expansion<8> = minor(&u, &v).times(w[2]);
    let rounded: Expansion<16> = first.plus(&second);
    let rounded: Expansion<24> = rounded.plus(&third);

    let tail = |to: Point3, from: Point3, rounded: &Point3| {
        std::array::from_fn::<f64, 3, _>(|i| difference_tail(to[i], from[i], rounded[i]))
    };
    let [u_tail, v_tail, w_tail] = [tail(b, a, &u), tail(c, a, &v), tail(q, p, &w)];
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
    // The derivative of p[2]·(q × r) in the tails.
    let first_order =
        |p: &Point3, q: &Point3, r: &Point3, p_tail: &Point3, q_tail: &Point3, r_tail: &Point3| {
            let minor_tail =
                (q[0] * r_tail[1] + r[1] * q_tail[0]) - (q[1] * r_tail[0] + r[0] * q_tail[1]);
            p[2] * minor_tail + p_tail[2] * (q[0] * r[1] - q[1] * r[0])
        };
    det += first_order(&u, &v, &w, &u_tail, &v_tail, &w_tail)
        + first_order(&v, &w, &u, &v_tail, &w_tail, &u_tail)
        + first_order(&w, &u, &v, &w_tail, &u_tail, &v_tail);
    (det.abs() > bound).then(|| Sign::of(det))
}
