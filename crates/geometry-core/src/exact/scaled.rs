//! The last stage: coordinates as integers times one common power of two.
//!
//! A finite `f64` is an integer of at most 53 bits times a power of two. Dividing all coordinates of a
//! question by the least of those powers leaves integers, and the sign of the determinant is unchanged.
//! The integers have at most 53 + 2045 bits; a question whose exponents lie together (the usual case) is
//! answered with few limbs, any other with enough for the whole range of `f64`.

use super::integer::Integer;
use crate::dyadic::decompose;
use crate::points::{Point2, Point3};
use crate::sign::Sign;

/// Limbs for coordinates that span at most [`NARROW_BITS`] bits: a determinant of degree 4 needs
/// 4 · (NARROW_BITS + 1) + 5 bits.
const NARROW: usize = 8;
const NARROW_BITS: u32 = 125;

/// Limbs for any finite coordinates: 4 · (2098 + 1) + 5 bits.
const WIDE: usize = 132;

/// Calls `$evaluate` with the points, further arguments and their least exponent, at the narrower width if that
/// suffices.
macro_rules! at_least_width {
    ($evaluate:ident, $points:expr $(, $argument:expr)*) => {
        match Span::of($points.as_flattened()) {
            Span::Narrow(least) => $evaluate::<NARROW>($points $(, $argument)*, least),
            Span::Wide(least) => $evaluate::<WIDE>($points $(, $argument)*, least),
        }
    };
}

/// The sign of (b-a) × (d-c).
pub(super) fn cross(a: Point2, b: Point2, c: Point2, d: Point2) -> Sign {
    fn evaluate<const L: usize>(points: &[Point2; 4], least: i32) -> Sign {
        let [a, b, c, d] = points.map(|p| p.map(|x| integer::<L>(x, least)));
        let left = b[0].minus(&a[0]).times(&d[1].minus(&c[1]));
        let right = b[1].minus(&a[1]).times(&d[0].minus(&c[0]));
        left.minus(&right).sign()
    }
    let points = [a, b, c, d];
    at_least_width!(evaluate, &points)
}

/// The sign of (b-a) × (c-a) · (q-p) for the points a, b, c, p, q.
pub(super) fn volume(points: [Point3; 5]) -> Sign {
    fn evaluate<const L: usize>(points: &[Point3; 5], least: i32) -> Sign {
        let [a, b, c, p, q] = points.map(|p| p.map(|x| integer::<L>(x, least)));
        let difference = |to: &[Integer<L>; 3], from: &[Integer<L>; 3]| {
            [
                to[0].minus(&from[0]),
                to[1].minus(&from[1]),
                to[2].minus(&from[2]),
            ]
        };
        determinant(
            &difference(&b, &a),
            &difference(&c, &a),
            &difference(&q, &p),
        )
        .sign()
    }
    at_least_width!(evaluate, &points)
}

/// The sign of (b-a) × (c-a) · (q-p) for the points a, b, c, p, q of the plane lifted to the paraboloid.
///
/// Heights are taken over the tangent plane at a, |p - a|², which shears space and changes no determinant of
/// differences.
pub(crate) fn lifted_volume(points: [Point2; 5]) -> Sign {
    fn evaluate<const L: usize>(points: &[Point2; 5], least: i32) -> Sign {
        let [a, b, c, p, q] = points.map(|p| p.map(|x| integer::<L>(x, least)));
        let over_a = |p: &[Integer<L>; 2]| {
            let (x, y) = (p[0].minus(&a[0]), p[1].minus(&a[1]));
            let lift = x.times(&x).plus(&y.times(&y));
            [x, y, lift]
        };
        let [p, q] = [over_a(&p), over_a(&q)];
        let w = [q[0].minus(&p[0]), q[1].minus(&p[1]), q[2].minus(&p[2])];
        determinant(&over_a(&b), &over_a(&c), &w).sign()
    }
    at_least_width!(evaluate, &points)
}

/// The orientation of a, b, c in the plane of one of their coordinates, as (coordinate, x² + y²).
pub(crate) fn lifted_shadow(a: Point2, b: Point2, c: Point2, coordinate: usize) -> Sign {
    fn evaluate<const L: usize>(points: &[Point2; 3], coordinate: usize, least: i32) -> Sign {
        let [a, b, c] = points.map(|p| p.map(|x| integer::<L>(x, least)));
        let lift = |p: &[Integer<L>; 2]| p[0].times(&p[0]).plus(&p[1].times(&p[1]));
        let along = |p: &[Integer<L>; 2]| p[coordinate].minus(&a[coordinate]);
        let up = |p: &[Integer<L>; 2]| lift(p).minus(&lift(&a));
        along(&b)
            .times(&up(&c))
            .minus(&up(&b).times(&along(&c)))
            .sign()
    }
    let points = [a, b, c];
    at_least_width!(evaluate, &points, coordinate)
}

/// The sign of the in-circle determinant of a, b, c and d.
pub(super) fn in_circle(a: Point2, b: Point2, c: Point2, d: Point2) -> Sign {
    fn evaluate<const L: usize>(points: &[Point2; 4], least: i32) -> Sign {
        let [a, b, c, d] = points.map(|p| p.map(|x| integer::<L>(x, least)));
        let lifted = |p: &[Integer<L>; 2]| {
            let (x, y) = (p[0].minus(&d[0]), p[1].minus(&d[1]));
            let lift = x.times(&x).plus(&y.times(&y));
            [x, y, lift]
        };
        determinant(&lifted(&a), &lifted(&b), &lifted(&c)).sign()
    }
    let points = [a, b, c, d];
    at_least_width!(evaluate, &points)
}

/// u × v · w, expanded along the third column.
fn determinant<const L: usize>(
    u: &[Integer<L>; 3],
    v: &[Integer<L>; 3],
    w: &[Integer<L>; 3],
) -> Integer<L> {
    let minor =
        |p: &[Integer<L>; 3], q: &[Integer<L>; 3]| p[0].times(&q[1]).minus(&p[1].times(&q[0]));
    let first = u[2].times(&minor(v, w));
    let second = v[2].times(&minor(w, u));
    let third = w[2].times(&minor(u, v));
    first.plus(&second).plus(&third)
}

/// The least exponent among the coordinates of a question, and whether all of them fit [`NARROW_BITS`].
enum Span {
    Narrow(i32),
    Wide(i32),
}

impl Span {
    fn of(coordinates: &[f64]) -> Self {
        let (mut least, mut top) = (i32::MAX, i32::MIN);
        for &x in coordinates {
            let (_, magnitude, exponent) = decompose(x);
            if magnitude != 0 {
                let low = exponent + magnitude.trailing_zeros() as i32;
                let high = exponent + (64 - magnitude.leading_zeros()) as i32;
                least = least.min(low);
                top = top.max(high);
            }
        }
        if least > top {
            Span::Narrow(0)
        } else if (top - least) as u32 <= NARROW_BITS {
            Span::Narrow(least)
        } else {
            Span::Wide(least)
        }
    }
}

/// `x` / 2^`least`, which must be an integer.
fn integer<const L: usize>(x: f64, least: i32) -> Integer<L> {
    let (negative, magnitude, exponent) = decompose(x);
    if magnitude == 0 {
        return Integer::ZERO;
    }
    let zeros = magnitude.trailing_zeros();
    let shift = exponent + zeros as i32 - least;
    debug_assert!(shift >= 0, "least is the least exponent of all coordinates");
    Integer::shifted(negative, magnitude >> zeros, shift as u32)
}
