//! Exact answers about points of one box, with the filters' bounds computed once for the box.
//!
//! The filters of orientation and in-circle compare a rounded determinant with a multiple of its permanent, which
//! costs as much again as the determinant. Where many questions are about points of one small box, the bound can be taken
//! once, at the largest differences that the box allows:
//!
//! 1. A rounded sum or product of numbers that are not negative never falls when a number grows. The
//!    permanents are made of such sums and products of magnitudes of differences, and a rounded difference of
//!    coordinates is in magnitude at most the rounded width or height of the box. So the permanent of any question about
//!    the box, *as rounded*, is at most that of the width and height, as rounded.
//! 2. So a determinant that beats the bound of the box beats its own, and the proofs of the filters hold: overflow
//!    makes the bound infinite or NaN, and nothing beats it; underflow is in the bound.
//!
//! **Lattices.** Where all coordinates are multiples of a power of two, the [`Unit`], every number in the determinant of
//! in-circle is a multiple of a power of the unit. If the permanent is at most 2⁵² units to the fourth, each of these is an
//! integer of at most 53 bits of its unit, nothing is rounded, and even a zero is certain (`Unit::is_exact`).

use super::lattice::Digits;
use super::{circle, planar};
use crate::kernel::{InCircle, Kernel2, Stage};
use crate::points::Point2;
use crate::sign::Sign;
use std::ops::RangeInclusive;

/// A power of two of which all coordinates of a set are multiples; or that none is known that could help.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// 2⁵² units to the fourth; zero if none is known.
    most: f64,
}

/// A set whose unit is smaller than this part of its largest coordinate is not a lattice in any useful sense.
const USEFUL: i32 = 40;

/// Exponents of units whose fourth power neither overflows nor underflows, with room for 2⁵².
const EXPONENTS: RangeInclusive<i32> = -240..=200;

impl Unit {
    /// No unit is known: zeros are settled by the kernel.
    pub const UNKNOWN: Self = Self { most: 0.0 };

    /// The largest power of two of which all coordinates of `points` are multiples, if it is not too small to help.
    ///
    /// # Cost
    ///
    /// One pass, left at once where a coordinate uses all its bits.
    ///
    /// ```
    /// use geometry_core::exact::Unit;
    /// assert_ne!(Unit::of(&[[0.5, 3.0], [-2.0, 0.0]]), Unit::UNKNOWN);
    /// assert_eq!(Unit::of(&[[0.1, 0.2]]), Unit::UNKNOWN);
    /// assert_eq!(Unit::of(&[[0.0, 0.0]]), Unit::UNKNOWN);
    /// ```
    pub fn of(points: &[Point2]) -> Self {
        match Digits::of(points, USEFUL) {
            Some(Digits { lowest, .. }) if EXPONENTS.contains(&lowest) => Self {
                most: f64::from_bits(((1023 + 52 + 4 * lowest) as u64) << 52),
            },
            _ => Self::UNKNOWN,
        }
    }

    /// Whether in-circle of points of a box of this size is computed without rounding.
    ///
    /// With u the unit, and the width and height at least u (else the points are collinear, and every product
    /// of a width and a height is zero): the permanent is more than 6 (w² + h²) w h, so at 2⁵² u⁴ at most, w² + h², w h and
    /// the partial sums are below 2⁵³ u², 2⁵³ u² and 2⁵³ u⁴, and multiples of these units. A unit is at least
    /// 2⁻²⁴⁰, so nothing underflows, and 2⁵² u⁴ is finite.
    #[inline(always)]
    fn is_exact(self, permanent: f64) -> bool {
        permanent <= self.most
    }
}

/// The kernel for points of a box: the answers of [`Exact`](super::Exact), sooner.
///
/// ```
/// use geometry_core::exact::{Boxed, Unit};
/// use geometry_core::{InCircle, Kernel2, Sign};
/// let square = [[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]];
/// let kernel = Boxed::new(3.0, 3.0, Unit::of(&square));
/// let [a, b, c, d] = square;
/// assert_eq!(kernel.orient(a, b, c), Sign::Positive);
/// assert_eq!(kernel.in_circle(a, b, c, d), Sign::Zero);
/// assert_eq!(kernel.in_circle(a, b, c, [1.0, 2.0]), Sign::Positive);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Boxed {
    orient: f64,
    circle: f64,
    unit: Unit,
}

impl Boxed {
    /// The kernel for points of a box `width` by `height`, rounded differences of its sides, whose coordinates are
    /// multiples of `unit`.
    ///
    /// Answers about points outside the box, or off the unit, may be wrong.
    #[inline(always)]
    pub fn new(width: f64, height: f64, unit: Unit) -> Self {
        let minor = width * height;
        let permanent = circle::largest_permanent(width, height);
        if unit.is_exact(permanent) {
            return Self {
                orient: 0.0,
                circle: 0.0,
                unit,
            };
        }
        Self {
            orient: planar::FILTER * (minor + minor + f64::MIN_POSITIVE),
            circle: circle::FILTER * permanent,
            unit,
        }
    }

    #[cold]
    #[inline(never)]
    fn orient_closely(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        if self.orient == 0.0 {
            return (Sign::Zero, Stage::Filter);
        }
        planar::cross(a, b, a, c)
    }

    #[cold]
    #[inline(never)]
    fn in_circle_closely(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
        if self.circle == 0.0 {
            return (Sign::Zero, Stage::Filter);
        }
        let extent = |axis: usize| {
            let largest = a[axis].max(b[axis]).max(c[axis]).max(d[axis]);
            largest - a[axis].min(b[axis]).min(c[axis]).min(d[axis])
        };
        if self
            .unit
            .is_exact(circle::largest_permanent(extent(0), extent(1)))
        {
            let det = circle::rounded_determinant(a, b, c, d);
            return (Sign::of(det), Stage::Filter);
        }
        circle::in_circle(a, b, c, d)
    }
}

impl Kernel2 for Boxed {
    #[inline(always)]
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        let det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if det > self.orient {
            (Sign::Positive, Stage::Filter)
        } else if det < -self.orient {
            (Sign::Negative, Stage::Filter)
        } else {
            self.orient_closely(a, b, c)
        }
    }

    #[inline(always)]
    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (std::cmp::Ordering, Stage) {
        super::Exact.compare_distance_staged(a, b, p, q)
    }
}

impl InCircle for Boxed {
    #[inline(always)]
    fn in_circle_staged(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
        let det = circle::rounded_determinant(a, b, c, d);
        if det > self.circle {
            (Sign::Positive, Stage::Filter)
        } else if det < -self.circle {
            (Sign::Negative, Stage::Filter)
        } else {
            self.in_circle_closely(a, b, c, d)
        }
    }
}
