//! The determinants in big integers: coordinates over the least power of two among them.

use geometry_core::{Axis, Sign};
use num_bigint::BigInt;

/// The sign of (b-a) × (d-c).
pub(crate) fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Sign {
    let [a, b, c, d] = integers(&[a, b, c, d]);
    sign(&cross_of(&difference(&b, &a), &difference(&d, &c)))
}

/// The sign of (b-a) × (c-a) · (d-a).
pub(crate) fn orient_in_space(&[a, b, c, d]: &[[f64; 3]; 4]) -> Sign {
    height_difference(&[a, b, c, d, a])
}

/// The sign of (b-a) × (c-a) · (p-q): `Positive` if p is higher over the plane abc than q.
pub(crate) fn height_difference(points: &[[f64; 3]; 5]) -> Sign {
    higher(&integers(points))
}

/// [`height_difference`] of points lifted to the paraboloid.
pub(crate) fn lifted_height_difference(points: &[[f64; 2]; 5]) -> Sign {
    let lifted = integers(points).map(|[x, y]| {
        let square = &x * &x + &y * &y;
        [x, y, square]
    });
    higher(&lifted)
}

/// The sign of the coordinate `axis` of (b-a) × (c-a) for a, b, c lifted to the paraboloid.
pub(crate) fn lifted_shadow(points: &[[f64; 2]; 3], axis: Axis) -> Sign {
    let [a, b, c] = integers(points).map(|[x, y]| {
        let square = &x * &x + &y * &y;
        [x, y, square]
    });
    let [b, c] = [b, c].map(|p| difference(&p, &a));
    let (i, j) = match axis {
        Axis::X => (1, 2),
        Axis::Y => (2, 0),
        Axis::Z => (0, 1),
    };
    sign(&(&b[i] * &c[j] - &b[j] * &c[i]))
}

fn higher([a, b, c, p, q]: &[[BigInt; 3]; 5]) -> Sign {
    let [b, c, up] = [difference(b, a), difference(c, a), difference(p, q)];
    let minor = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
    sign(&(minor(1, 2) * &up[0] + minor(2, 0) * &up[1] + minor(0, 1) * &up[2]))
}

/// The sign of the in-circle determinant: `Positive` for d inside the circle through a, b, c anticlockwise.
pub(crate) fn in_circle(points: &[[f64; 2]; 4]) -> Sign {
    let [a, b, c, d] = integers(points);
    let [a, b, c] = [a, b, c].map(|p| difference(&p, &d));
    let square = |p: &[BigInt; 2]| &p[0] * &p[0] + &p[1] * &p[1];
    let term = |p, q, r| square(p) * cross_of(q, r);
    sign(&(term(&a, &b, &c) + term(&b, &c, &a) + term(&c, &a, &b)))
}

fn difference<const D: usize>(p: &[BigInt; D], q: &[BigInt; D]) -> [BigInt; D] {
    std::array::from_fn(|i| &p[i] - &q[i])
}

fn cross_of(p: &[BigInt; 2], q: &[BigInt; 2]) -> BigInt {
    &p[0] * &q[1] - &p[1] * &q[0]
}

fn sign(value: &BigInt) -> Sign {
    Sign::from(value.cmp(&BigInt::ZERO))
}

/// The coordinates divided by the least power of two that any of them is a multiple of.
fn integers<const D: usize, const N: usize>(points: &[[f64; D]; N]) -> [[BigInt; D]; N] {
    let parts = points.map(|p| p.map(parts));
    let nonzero = parts
        .iter()
        .flatten()
        .filter(|&&(mantissa, _)| mantissa != 0);
    let least = nonzero.map(|&(_, exponent)| exponent).min().unwrap_or(0);
    parts.map(|p| {
        p.map(|(mantissa, exponent)| {
            if mantissa == 0 {
                BigInt::ZERO
            } else {
                BigInt::from(mantissa) << (exponent - least)
            }
        })
    })
}

/// (m, e) with x = m · 2^e, by IEEE 754's definition of binary64.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i32;
    let fraction = (bits & 0x000f_ffff_ffff_ffff) as i64;
    let (magnitude, exponent) = match exponent {
        0 => (fraction, -1074),
        _ => (fraction + (1 << 52), exponent - 1075),
    };
    (
        if bits >> 63 == 0 {
            magnitude
        } else {
            -magnitude
        },
        exponent,
    )
}
