//! A floating-point format in software: any of base 2 or 16, any length up to 64 bits, rounded or truncated.
//!
//! The exponent is not bounded: overflow and underflow of the old formats are not modelled, because their
//! ranges (16^±64, 2^±1023) exceed anything that areas of the papers' data reach.

use crate::dyadic::decompose;
use std::cmp::Ordering;

/// How a result that is too long is shortened. Constants instead of an enum, to serve as a const parameter.
#[derive(Debug)]
pub struct Rounding;

impl Rounding {
    /// To nearest, ties to even: IEEE 754.
    pub const NEAREST: u8 = 0;
    /// Towards zero, after an exact (double-length) operation: CDC 6000 and 7000 unrounded arithmetic.
    pub const TRUNCATE: u8 = 1;
    /// Towards zero; in additions the smaller operand is first shortened to one guard digit beyond the
    /// larger: IBM System/360 and 370.
    pub const TRUNCATE_WITH_GUARD_DIGIT: u8 = 2;
}

/// ± significand · 2^exponent, the significand normalised to `DIGITS` digits of base `BASE`.
///
/// Invariant: a nonzero significand has a nonzero leading digit; in base 16 the exponent is a multiple of 4.
#[derive(Clone, Copy, Debug)]
pub struct Soft<const BASE: u32, const DIGITS: u32, const ROUNDING: u8> {
    negative: bool,
    significand: u64,
    exponent: i32,
}

impl<const BASE: u32, const DIGITS: u32, const ROUNDING: u8> Soft<BASE, DIGITS, ROUNDING> {
    /// Bits in a digit.
    const DIGIT: i32 = BASE.trailing_zeros() as i32;
    /// Bits in a significand.
    const LENGTH: i32 = DIGITS as i32 * Self::DIGIT;

    /// `x`, shortened to this format.
    pub fn of(x: f64) -> Self {
        let (negative, magnitude, exponent) = decompose(x);
        Self::shorten(negative, u128::from(magnitude), exponent)
    }

    /// The value as `f64`, rounded to nearest even.
    pub fn to_f64(self) -> f64 {
        // A u64 converts to f64 with one correct rounding; the scaling is exact within the range of f64.
        let magnitude = self.significand as f64;
        let scaled = scale(magnitude, self.exponent);
        if self.negative { -scaled } else { scaled }
    }

    /// The product, shortened.
    pub fn times(self, other: Self) -> Self {
        let product = u128::from(self.significand) * u128::from(other.significand);
        Self::shorten(
            self.negative != other.negative,
            product,
            self.exponent + other.exponent,
        )
    }

    /// The difference, shortened.
    pub fn minus(self, other: Self) -> Self {
        self.plus(Self {
            negative: !other.negative,
            ..other
        })
    }

    /// The quotient, shortened; `None` if `other` is zero, for there are no infinities.
    pub fn over(self, other: Self) -> Option<Self> {
        if other.significand == 0 {
            return None;
        }
        let divisor = u128::from(other.significand);
        // Long division in two steps: 64 bits after the point, then 60 more. That is more than twice the longest result
        // and at most 128 bits, and of what is still left only whether it is zero matters.
        let dividend = u128::from(self.significand) << 64;
        let rest = (dividend % divisor) << 60;
        let quotient = ((dividend / divisor) << 60) | (rest / divisor);
        let sticky = u128::from(!rest.is_multiple_of(divisor) && ROUNDING == Rounding::NEAREST);
        Some(Self::shorten(
            self.negative != other.negative,
            quotient | sticky,
            self.exponent - other.exponent - 124,
        ))
    }

    /// The square root, shortened; `None` of a negative number.
    ///
    /// ```
    /// use geometry_core::tolerance::soft::{Rounding, Soft};
    /// type Binary64 = Soft<2, 53, { Rounding::NEAREST }>;
    /// let root = Binary64::of(2.0).root().map(Binary64::to_f64);
    /// assert_eq!(root, Some(std::f64::consts::SQRT_2));
    /// ```
    pub fn root(self) -> Option<Self> {
        if self.significand == 0 {
            return Some(self);
        }
        if self.negative {
            return None;
        }
        // As many bits as fit, with an even exponent: the root then has 64 bits, the longest result.
        let magnitude = u128::from(self.significand);
        let room = magnitude.leading_zeros() as i32;
        let up = room - (room - self.exponent).rem_euclid(2);
        let square = magnitude << up;
        let root = square.isqrt();
        let rest = square - root * root;
        // Two bits more: whether the exact root is past the middle, and whether there is anything at all past root.
        let more = match ROUNDING {
            Rounding::NEAREST => 2 * u128::from(rest > root) + u128::from(rest > 0),
            _ => 0,
        };
        let exponent = (self.exponent - up) / 2 - 2;
        Some(Self::shorten(false, root << 2 | more, exponent))
    }

    /// The sum, shortened.
    pub fn plus(self, other: Self) -> Self {
        if other.significand == 0 {
            return self;
        }
        if self.significand == 0 {
            return other;
        }
        let (large, small) = if self.exponent >= other.exponent {
            (self, other)
        } else {
            (other, self)
        };
        // The larger operand is shifted up as far as 128 bits (less one for the carry) allow; what the smaller
        // one still loses lies below every digit of the result and is kept as one sticky bit.
        let room = match ROUNDING {
            Rounding::TRUNCATE_WITH_GUARD_DIGIT => Self::DIGIT,
            _ => 126 - Self::LENGTH,
        };
        let gap = large.exponent - small.exponent;
        let up = gap.min(room);
        let down = (gap - up).min(127) as u32;
        let high = u128::from(large.significand) << up;
        let shifted = u128::from(small.significand) >> down;
        let lost = shifted << down != u128::from(small.significand);
        let sticky = u128::from(lost && ROUNDING == Rounding::NEAREST);
        let low = shifted | sticky;
        let exponent = large.exponent - up;
        if large.negative == small.negative {
            return Self::shorten(large.negative, high + low, exponent);
        }
        match high.cmp(&low) {
            Ordering::Less => Self::shorten(small.negative, low - high, exponent),
            _ => Self::shorten(large.negative, high - low, exponent),
        }
    }

    /// ± `magnitude` · 2^`exponent` in this format.
    fn shorten(negative: bool, magnitude: u128, exponent: i32) -> Self {
        if magnitude == 0 {
            return Self {
                negative: false,
                significand: 0,
                exponent: 0,
            };
        }
        // The target exponent: that of the last digit kept, on the grid of whole digits.
        let top = exponent + (128 - magnitude.leading_zeros() as i32);
        let top_digit = top.div_euclid(Self::DIGIT) + i32::from(top.rem_euclid(Self::DIGIT) != 0);
        let target = top_digit * Self::DIGIT - Self::LENGTH;
        let drop = target - exponent;
        if drop <= 0 {
            return Self {
                negative,
                significand: (magnitude << -drop) as u64,
                exponent: target,
            };
        }
        let kept = magnitude >> drop;
        if ROUNDING != Rounding::NEAREST {
            return Self {
                negative,
                significand: kept as u64,
                exponent: target,
            };
        }
        let (half, rest) = (1_u128 << (drop - 1), magnitude & ((1_u128 << drop) - 1));
        let up = rest > half || (rest == half && kept & 1 == 1);
        let rounded = kept + u128::from(up);
        if rounded >> Self::LENGTH == 0 {
            Self {
                negative,
                significand: rounded as u64,
                exponent: target,
            }
        } else {
            Self {
                negative,
                significand: (rounded >> Self::DIGIT) as u64,
                exponent: target + Self::DIGIT,
            }
        }
    }
}

/// `x` · 2^`exponent`, in steps that stay within the range of normal numbers as long as the result does.
fn scale(x: f64, exponent: i32) -> f64 {
    let mut result = x;
    let mut left = exponent;
    while left != 0 && result != 0.0 && result.is_finite() {
        let step = left.clamp(-1000, 1000);
        result *= 2_f64.powi(step);
        left -= step;
    }
    result
}
