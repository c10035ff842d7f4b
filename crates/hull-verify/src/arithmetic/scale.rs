//! Sides of planes, turns of shadows and insides of circles, exactly, for any finite coordinates.
//!
//! As in the plane ([`super`]), the coordinates of a whole set become integers times one power of two. With w bits
//! each, differences are below 2ʷ⁺¹ and
//!
//! | question | determinant below | bits with sign |
//! |---|---|---|
//! | [`side`](Scale::side) | 2³ʷ⁺⁶ | 3w + 7 |
//! | [`in_circle`](Scale::in_circle) | 2⁴ʷ⁺⁸ | 4w + 9 |
//!
//! which decides whether it is computed in 128, 192, 256, 384 or 512 bits or in big integers. The bounds hold for every
//! intermediate result too. The turn of a shadow is that of the plane ([`Frame::turn`]).

use super::dyadic::Dyadic;
use super::ring::{Int, Ring};
use super::{Frame, Turn, extent};
use geometry_core::{Axis, Point2, Point3};
use num_bigint::BigInt;
use std::cmp::Ordering;

/// Where a fourth point lies with regard to the plane through three.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// On the side from which the three run anticlockwise.
    Above,
    /// In the plane.
    On,
    /// On the side from which they run clockwise.
    Below,
}

impl From<Ordering> for Side {
    /// The side whose determinant compares with zero as given.
    fn from(determinant: Ordering) -> Self {
        match determinant {
            Ordering::Greater => Side::Above,
            Ordering::Equal => Side::On,
            Ordering::Less => Side::Below,
        }
    }
}

/// The power of two over which all coordinates of a set are integers, and how wide they are.
///
/// ```
/// use hull_verify::arithmetic::scale::{Scale, Side};
/// let points = [[0.0; 3], [1e300, 0.0, 0.0], [0.0, 1e300, 0.0], [7.0, 7.0, -5e-324]];
/// let scale = Scale::of(&points);
/// let [a, b, c, d] = points;
/// assert_eq!(scale.side(a, b, c, d), Side::Below);
/// assert!(scale.bits() > 2000);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scale {
    /// The exponent of that power.
    least: i32,
    bits: i32,
}

/// The integers wide enough for a determinant.
enum Width {
    Bits128,
    Bits192,
    Bits256,
    Bits384,
    Bits512,
    Big,
}

impl Scale {
    /// The scale of `points`, whose coordinates must be finite.
    ///
    /// # Cost
    ///
    /// One pass, no allocation.
    pub fn of<const D: usize>(points: &[[f64; D]]) -> Self {
        let (least, bits) = extent(points);
        Self { least, bits }
    }

    /// How many bits the widest coordinate has.
    pub fn bits(&self) -> u32 {
        self.bits.unsigned_abs()
    }

    /// Where d lies with regard to the plane abc. The points must be of the set this scale was made for.
    ///
    /// # Cost
    ///
    /// Some tens of nanoseconds up to 168 bits; O(w²) for w limbs beyond.
    #[inline]
    pub fn side(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> Side {
        let others = [b, c, d];
        Side::from(match self.width(3 * self.bits + 7) {
            Width::Bits128 => volume::<i128>(self.vectors(a, others)),
            Width::Bits192 => volume::<Int<3>>(self.vectors(a, others)),
            Width::Bits256 => volume::<Int<4>>(self.vectors(a, others)),
            Width::Bits384 => volume::<Int<6>>(self.vectors(a, others)),
            Width::Bits512 => volume::<Int<8>>(self.vectors(a, others)),
            Width::Big => volume(self.big_vectors(a, others)),
        })
    }

    /// The turn of the shadows of a, b, c, seen from the far positive end of `axis`.
    #[inline]
    pub fn turn(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> Turn {
        let [a, b, c] = [a, b, c].map(|p| shadow(axis, p));
        Frame::new(self.least, self.bits).turn(a, b, c)
    }

    /// Whether a, b, c lie on one line.
    pub fn collinear(&self, a: Point3, b: Point3, c: Point3) -> bool {
        Axis::ALL
            .into_iter()
            .all(|axis| self.turn(axis, a, b, c) == Turn::Straight)
    }

    /// Whether d lies inside the circle through a, b, c, which run anticlockwise: `Greater` inside, `Equal` on it.
    #[inline]
    pub fn in_circle(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> Ordering {
        let others = [a, b, c];
        match self.width(4 * self.bits + 9) {
            Width::Bits128 => lifted::<i128>(self.vectors(d, others)),
            Width::Bits192 => lifted::<Int<3>>(self.vectors(d, others)),
            Width::Bits256 => lifted::<Int<4>>(self.vectors(d, others)),
            Width::Bits384 => lifted::<Int<6>>(self.vectors(d, others)),
            Width::Bits512 => lifted::<Int<8>>(self.vectors(d, others)),
            Width::Big => lifted(self.big_vectors(d, others)),
        }
    }

    fn width(&self, needed: i32) -> Width {
        // Differences of coordinates of more than 126 bits do not fit i128.
        match needed {
            _ if self.bits > 126 => Width::Big,
            ..=128 => Width::Bits128,
            129..=192 => Width::Bits192,
            193..=256 => Width::Bits256,
            257..=384 => Width::Bits384,
            385..=512 => Width::Bits512,
            _ => Width::Big,
        }
    }

    /// The vectors from `origin` to `others`.
    #[inline(always)]
    fn vectors<T: From<i128>, const D: usize, const N: usize>(
        &self,
        origin: [f64; D],
        others: [[f64; D]; N],
    ) -> [[T; D]; N] {
        let origin = self.integers(origin);
        others.map(|p| {
            let p = self.integers(p);
            std::array::from_fn(|i| T::from(p[i] - origin[i]))
        })
    }

    #[inline(always)]
    fn integers<const D: usize>(&self, p: [f64; D]) -> [i128; D] {
        p.map(|x| Dyadic::of(x).over(self.least))
    }

    #[cold]
    fn big_vectors<const D: usize, const N: usize>(
        &self,
        origin: [f64; D],
        others: [[f64; D]; N],
    ) -> [[BigInt; D]; N] {
        let big = |p: [f64; D]| p.map(|x| Dyadic::of(x).big_over(self.least));
        let origin = big(origin);
        others.map(|p| {
            let p = big(p);
            std::array::from_fn(|i| &p[i] - &origin[i])
        })
    }
}

/// The shadow of `p` along `axis`, as seen from its far positive end.
#[inline(always)]
pub fn shadow(axis: Axis, [x, y, z]: Point3) -> Point2 {
    match axis {
        Axis::X => [y, z],
        Axis::Y => [z, x],
        Axis::Z => [x, y],
    }
}

/// Compares by x, then y, then z. Total on finite points; the two zeros are equal.
#[inline]
pub fn order3(a: Point3, b: Point3) -> Ordering {
    let axis = |i: usize| a[i].partial_cmp(&b[i]).unwrap_or(Ordering::Equal);
    axis(0).then_with(|| axis(1)).then_with(|| axis(2))
}

#[inline(always)]
fn cross<T: Ring>(a: &T, b: &T, c: &T, d: &T) -> T {
    a.times(d).minus(&b.times(c))
}

/// The sign of u × v · w.
#[inline(always)]
fn volume<T: Ring>([u, v, w]: [[T; 3]; 3]) -> Ordering {
    let x = cross(&u[1], &u[2], &v[1], &v[2]).times(&w[0]);
    let y = cross(&u[2], &u[0], &v[2], &v[0]).times(&w[1]);
    let z = cross(&u[0], &u[1], &v[0], &v[1]).times(&w[2]);
    x.plus(&y).plus(&z).ordering()
}

/// The sign of the volume of the vectors lifted to the paraboloid.
#[inline(always)]
fn lifted<T: Ring>(vectors: [[T; 2]; 3]) -> Ordering {
    volume(vectors.map(|[x, y]| {
        let square = x.times(&x).plus(&y.times(&y));
        [x, y, square]
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// Everything over the least power of two of all.
    const FINEST: Scale = Scale {
        least: -1074,
        bits: 2098,
    };

    fn coordinate(rng: &mut ChaCha8Rng, low: i32, high: i32) -> f64 {
        let exponent = rng.random_range(low..high);
        let significand = 1.0 + f64::from(rng.random::<u32>()) / 4_294_967_296.0;
        match rng.random_range(0..12) {
            0 => 0.0,
            1 => -0.0,
            k => {
                let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
                sign * significand
                    * 2.0_f64.powi(exponent / 2)
                    * 2.0_f64.powi(exponent - exponent / 2)
            }
        }
    }

    /// Four points with exponents in `low..high`; now and then the last is nearly in the plane of the others.
    fn four<const D: usize>(rng: &mut ChaCha8Rng, low: i32, high: i32) -> [[f64; D]; 4] {
        let mut points = [[0.0; D]; 4];
        for x in points.as_flattened_mut() {
            *x = coordinate(rng, low, high);
        }
        if rng.random_range(0..3) == 0 {
            points[3] = std::array::from_fn(|i| {
                points[0][i] / 4.0 + points[1][i] / 4.0 + points[2][i] / 2.0
            });
        }
        points
    }

    #[test]
    fn every_width_agrees_with_big_integers() {
        let mut rng = ChaCha8Rng::seed_from_u64(32);
        let ranges = [
            (0, 1),
            (-8, 8),
            (-20, 20),
            (-40, 40),
            (-90, -20),
            (-1080, 1023),
            (-1080, -1020),
        ];
        for (low, high) in ranges {
            for _ in 0..2000 {
                let points = four::<3>(&mut rng, low, high);
                let scale = Scale::of(&points);
                let [a, b, c, d] = points;
                assert_eq!(
                    scale.side(a, b, c, d),
                    FINEST.side(a, b, c, d),
                    "{points:?}"
                );
                for axis in Axis::ALL {
                    assert_eq!(
                        scale.turn(axis, a, b, c),
                        FINEST.turn(axis, a, b, c),
                        "{points:?}"
                    );
                }
                let points = four::<2>(&mut rng, low, high);
                let scale = Scale::of(&points);
                let [a, b, c, d] = points;
                assert_eq!(
                    scale.in_circle(a, b, c, d),
                    FINEST.in_circle(a, b, c, d),
                    "{points:?}"
                );
            }
        }
    }

    #[test]
    fn extreme_digits_fill_every_width() {
        // All ones, and both signs: the largest determinants of each number of bits.
        for bits in (1..=53).chain([60, 61, 62, 83, 84, 125, 126, 127, 168, 169]) {
            let top = (2.0_f64.powi(bits.min(53)) - 1.0) * 2.0_f64.powi((bits - 53).max(0));
            let unit = [[1.0; 3]];
            let corners = [
                [-top, -top, -top],
                [top, top, -top],
                [-top, top, top],
                [top, -top, top],
            ];
            let mut points = corners.to_vec();
            points.extend(unit);
            let scale = Scale::of(&points);
            assert_eq!(scale.bits(), bits as u32);
            for [i, j, k, l] in [
                [0, 1, 2, 3],
                [1, 0, 2, 3],
                [0, 1, 2, 4],
                [3, 2, 1, 0],
                [0, 0, 1, 2],
            ] {
                let [a, b, c, d] = [i, j, k, l].map(|i: usize| points[i]);
                assert_eq!(scale.side(a, b, c, d), FINEST.side(a, b, c, d));
                let [p, q, r, s] = [a, b, c, d].map(|p| shadow(Axis::Z, p));
                assert_eq!(scale.in_circle(p, q, r, s), FINEST.in_circle(p, q, r, s));
            }
        }
    }

    #[test]
    fn orientations_are_as_documented() {
        let [o, x, y, z] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let scale = Scale::of(&[o, x, y, z]);
        assert_eq!(scale.side(o, x, y, z), Side::Above);
        assert_eq!(scale.side(o, y, x, z), Side::Below);
        assert_eq!(scale.turn(Axis::X, o, y, z), Turn::Left);
        assert_eq!(scale.turn(Axis::Y, o, z, x), Turn::Left);
        assert_eq!(scale.turn(Axis::Z, o, x, y), Turn::Left);
        let [a, b, c] = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        assert!(scale.in_circle(a, b, c, [1.0, 1.0]).is_gt());
        assert!(scale.in_circle(a, b, c, [2.0, 2.0]).is_eq());
        assert!(scale.in_circle(a, b, c, [2.0, 3.0]).is_lt());
    }
}
