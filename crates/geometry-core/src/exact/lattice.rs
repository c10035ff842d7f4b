//! Exact answers about points of a lattice so coarse that plain arithmetic rounds nothing.
//!
//! Where all coordinates are multiples of 2ˡ and below 2ˡ⁺²⁵ in magnitude, differences are multiples of 2ˡ of at most 2ˡ⁺²⁶, their
//! products multiples of 4ˡ of at most 2⁵² · 4ˡ, and the difference of two products is at most 2⁵³ · 4ˡ: each an integer of at most
//! 53 bits of its unit, so nothing is rounded. Even a zero is certain, without a filter that it would fail.

use crate::kernel::{Kernel2, Stage};
use crate::points::Point2;
use crate::sign::Sign;
use std::cmp::Ordering;

/// The digits that coordinates have in binary.
pub(super) struct Digits {
    /// The exponent of the lowest digit of all: all coordinates are multiples of 2 to it.
    pub(super) lowest: i32,
    /// That of the highest one.
    pub(super) highest: i32,
}

impl Digits {
    /// Those of the points, if they span no more than `most` binary places; none if all coordinates are zero.
    ///
    /// One pass, left at once where a coordinate uses all its bits.
    pub(super) fn of(points: &[Point2], most: i32) -> Option<Self> {
        let (mut lowest, mut highest) = (i32::MAX, i32::MIN);
        // The first point by itself: most sets are no lattice, and it says so.
        let (first, rest) = points.split_at(points.len().min(1));
        for block in std::iter::once(first).chain(rest.chunks(256)) {
            for &x in block.as_flattened().iter().filter(|&&x| x != 0.0) {
                let bits = x.to_bits();
                let exponent = (bits >> 52 & 0x7ff) as i32 - 1023;
                // The hidden bit stands in for the mantissa of a power of two; of subnormals nothing is said.
                let zeros = (bits & ((1 << 52) - 1) | 1 << 52).trailing_zeros();
                lowest = lowest.min(exponent - 52 + zeros as i32);
                highest = highest.max(exponent);
            }
            if lowest.saturating_add(most) < highest {
                return None;
            }
        }
        (lowest <= highest).then_some(Self { lowest, highest })
    }
}

/// The kernel for points of a coarse lattice: the answers of [`Exact`](super::Exact), sooner.
///
/// ```
/// use geometry_core::exact::Unrounded;
/// use geometry_core::{Kernel2, Sign};
/// let points = [[0.0, 0.0], [0.5, 1.5], [1.0, 3.0]];
/// let kernel = Unrounded::among(&points).expect("multiples of a half");
/// let [a, b, c] = points;
/// assert_eq!(kernel.orient(a, b, c), Sign::Zero);
/// assert!(Unrounded::among(&[[0.1, 0.2]]).is_none());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Unrounded(());

/// So many binary places at most beyond the first.
const PLACES: i32 = 24;

/// Exponents of digits whose products neither overflow nor underflow.
const LEAST_EXPONENT: i32 = -500;
const MOST_EXPONENT: i32 = 480;

impl Unrounded {
    /// The kernel for questions about these points; none if they are on no lattice that is coarse enough.
    ///
    /// # Cost
    ///
    /// One pass, left at once where a coordinate uses all its bits.
    pub fn among(points: &[Point2]) -> Option<Self> {
        let Digits { lowest, highest } = Digits::of(points, PLACES)?;
        (lowest >= LEAST_EXPONENT && highest <= MOST_EXPONENT).then_some(Self(()))
    }
}

impl Kernel2 for Unrounded {
    #[inline(always)]
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        (cross(a, b, a, c), Stage::Filter)
    }

    #[inline(always)]
    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        (cross(a, b, q, p).ordering(), Stage::Filter)
    }
}

/// The sign of (b-a) × (d-c).
#[inline(always)]
fn cross(a: Point2, b: Point2, c: Point2, d: Point2) -> Sign {
    Sign::of((b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Exact;

    /// All corners of the largest lattice, and points beside them, in every question.
    #[test]
    fn nothing_is_rounded_at_the_limit() {
        for exponent in [-500, -26, 0, 456] {
            let unit = 2.0_f64.powi(exponent);
            let largest = f64::from((1 << 25) - 1);
            let values = [-largest, 1.0 - largest, 0.0, 1.0, largest - 1.0, largest];
            let points: Vec<Point2> = (0..36)
                .map(|place| [values[place % 6] * unit, values[place / 6] * unit])
                .collect();
            let kernel = Unrounded::among(&points).expect("25 bits");
            for &a in &points {
                for &b in &points {
                    for &c in &points {
                        assert_eq!(kernel.orient(a, b, c), Exact.orient(a, b, c));
                        assert_eq!(
                            kernel.compare_distance(a, b, c, points[7]),
                            Exact.compare_distance(a, b, c, points[7])
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn finer_larger_and_smaller_points_have_none() {
        let largest = f64::from(1 << 25);
        assert!(Unrounded::among(&[[0.0, 1.0], [largest, 0.0]]).is_none());
        assert!(Unrounded::among(&[[0.0, 2.0], [largest, 0.0]]).is_some());
        let far = |exponent: i32| [[0.0, 2.0_f64.powi(exponent)]];
        assert!(Unrounded::among(&far(480)).is_some() && Unrounded::among(&far(481)).is_none());
        assert!(Unrounded::among(&far(-500)).is_some() && Unrounded::among(&far(-501)).is_none());
        for none in [5e-324, f64::MIN_POSITIVE / 2.0, f64::MAX, 0.0] {
            assert!(Unrounded::among(&[[none, 0.0]]).is_none(), "{none}");
        }
        assert!(Unrounded::among(&[]).is_none());
    }
}
