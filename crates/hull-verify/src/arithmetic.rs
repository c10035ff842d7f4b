//! The side of a line, exactly, for any finite coordinates.
//!
//! A finite `f64` is an integer times a power of two. A [`Frame`] holds the least such power of a whole point
//! set; divided by it, all coordinates are integers, and no orientation changes. How wide those integers are
//! decides how they are multiplied:
//!
//! | [`Width`] | coordinates | products |
//! |---|---|---|
//! | `Narrow` | up to 61 bits, in `i64` | `i128` |
//! | `Medium` | up to 125 bits, in `i128` | 256 bits, compared limb by limb ([`wide`]) |
//! | `Big` | any (2098 bits at most) | [`BigInt`] |
//!
//! Points drawn uniformly are narrow, a million from a normal distribution medium. The only operation on
//! `f64` values themselves is comparison, which the machine does exactly. The sides of planes and the insides of
//! circles are decided in the same way ([`scale`]).

pub mod dyadic;
pub mod ring;
pub mod scale;
pub mod wide;

use dyadic::Dyadic;
use geometry_core::Point2;
use num_bigint::BigInt;
use std::cmp::Ordering;

/// Where the third of three points lies, seen along the line from the first to the second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// To the left: the three points run anticlockwise.
    Left,
    /// On the line.
    Straight,
    /// To the right: the three points run clockwise.
    Right,
}

impl From<Ordering> for Turn {
    /// The turn whose determinant compares with zero as given.
    fn from(determinant: Ordering) -> Self {
        match determinant {
            Ordering::Greater => Turn::Left,
            Ordering::Equal => Turn::Straight,
            Ordering::Less => Turn::Right,
        }
    }
}

/// How wide the scaled coordinates of a point set are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Width {
    /// At most 61 bits: products fit `i128`.
    Narrow,
    /// At most 125 bits: products fit 256 bits.
    Medium,
    /// More: big integers.
    Big,
}

/// The power of two over which all coordinates of a point set are integers.
///
/// ```
/// use hull_verify::arithmetic::{Frame, Turn, Width};
/// let points = [[0.0, 0.0], [1e300, 1e300], [5e-324, 0.0]];
/// let frame = Frame::of(&points);
/// assert_eq!(frame.width(), Width::Big);
/// assert_eq!(frame.turn(points[0], points[1], points[2]), Turn::Right);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The exponent of that power.
    least: i32,
    width: Width,
}

impl Frame {
    /// The frame of `points`, whose coordinates must be finite.
    ///
    /// # Cost
    ///
    /// One pass, no allocation.
    pub fn of(points: &[Point2]) -> Self {
        let (least, bits) = extent(points);
        Self::new(least, bits)
    }

    fn new(least: i32, bits: i32) -> Self {
        let width = match bits {
            ..=61 => Width::Narrow,
            62..=125 => Width::Medium,
            _ => Width::Big,
        };
        Self { least, width }
    }

    /// How wide the integers of this frame are.
    pub fn width(&self) -> Width {
        self.width
    }

    /// Where c lies, seen along the line a→b. The points must be of the set this frame was made for.
    ///
    /// # Cost
    ///
    /// A few nanoseconds if narrow or medium; O(w²) for w limbs if big.
    #[inline]
    pub fn turn(&self, a: Point2, b: Point2, c: Point2) -> Turn {
        let determinant = match self.width {
            Width::Narrow => self.narrow(a, b, c),
            Width::Medium => self.medium(a, b, c),
            Width::Big => self.big(a, b, c),
        };
        Turn::from(determinant)
    }

    /// Coordinates below 2⁶¹, differences below 2⁶², products below 2¹²⁴.
    #[inline]
    fn narrow(&self, a: Point2, b: Point2, c: Point2) -> Ordering {
        let [a, b, c] = [a, b, c].map(|p| p.map(|x| Dyadic::of(x).over::<i64>(self.least)));
        let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
        let left = product(b[0] - a[0], c[1] - a[1]);
        let right = product(b[1] - a[1], c[0] - a[0]);
        left.cmp(&right)
    }

    /// Coordinates below 2¹²⁵, differences below 2¹²⁶, products below 2²⁵².
    fn medium(&self, a: Point2, b: Point2, c: Point2) -> Ordering {
        let [a, b, c] = [a, b, c].map(|p| p.map(|x| Dyadic::of(x).over::<i128>(self.least)));
        wide::compare_products([b[0] - a[0], c[1] - a[1]], [b[1] - a[1], c[0] - a[0]])
    }

    #[cold]
    fn big(&self, a: Point2, b: Point2, c: Point2) -> Ordering {
        let [a, b, c] = [a, b, c].map(|p| p.map(|x| Dyadic::of(x).big_over(self.least)));
        let left: BigInt = (&b[0] - &a[0]) * (&c[1] - &a[1]);
        let right: BigInt = (&b[1] - &a[1]) * (&c[0] - &a[0]);
        left.cmp(&right)
    }
}

/// The exponent of the least power of two over which all coordinates are integers, and the number of bits of the
/// widest of these integers.
fn extent<const D: usize>(points: &[[f64; D]]) -> (i32, i32) {
    let (mut least, mut top) = (i32::MAX, i32::MIN);
    for &coordinate in points.as_flattened() {
        if coordinate != 0.0 {
            let value = Dyadic::of(coordinate);
            least = least.min(value.lowest_bit());
            top = top.max(value.above_highest_bit());
        }
    }
    (least, top.saturating_sub(least).max(0))
}

/// Compares by x, then by y: the order in which a polygon starts and a segment runs.
///
/// Total on finite points; the two zeros are equal.
#[inline]
pub fn order(a: Point2, b: Point2) -> Ordering {
    let axis = |i: usize| a[i].partial_cmp(&b[i]).unwrap_or(Ordering::Equal);
    axis(0).then_with(|| axis(1))
}

#[cfg(test)]
mod tests;
