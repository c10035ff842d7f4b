//! A finite `f64` taken apart into an integer and a power of two.

use num_bigint::BigInt;
use std::ops::{Neg, Shl};

/// ±`magnitude` · 2^`exponent`, with `magnitude` below 2⁵³.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dyadic {
    negative: bool,
    magnitude: u64,
    exponent: i32,
}

impl Dyadic {
    /// The value of `x`, which must be finite.
    ///
    /// ```
    /// use hull_verify::arithmetic::dyadic::Dyadic;
    /// let x = Dyadic::of(-0.375); // -3 · 2⁻³
    /// assert_eq!((x.lowest_bit(), x.above_highest_bit()), (-3, -1));
    /// assert_eq!(x.over::<i64>(-4), -6);
    /// ```
    #[inline]
    pub fn of(x: f64) -> Self {
        let bits = x.to_bits();
        let fraction = bits & ((1 << 52) - 1);
        let field = ((bits >> 52) & 0x7ff) as i32;
        // A biased exponent of zero marks zero and the subnormals, which have no hidden bit.
        let (magnitude, exponent) = if field == 0 {
            (fraction, -1074)
        } else {
            (fraction | (1 << 52), field - 1075)
        };
        Self {
            negative: bits >> 63 == 1,
            magnitude,
            exponent,
        }
    }

    /// The exponent of the lowest bit that is set. The value must not be zero.
    #[inline]
    pub fn lowest_bit(&self) -> i32 {
        self.exponent + self.magnitude.trailing_zeros() as i32
    }

    /// One more than the exponent of the highest bit that is set. The value must not be zero.
    #[inline]
    pub fn above_highest_bit(&self) -> i32 {
        self.exponent + 64 - self.magnitude.leading_zeros() as i32
    }

    /// This value divided by 2^`least`, which must leave an integer that fits `I`.
    #[inline]
    pub fn over<I>(&self, least: i32) -> I
    where
        I: From<i64> + Shl<i32, Output = I> + Neg<Output = I>,
    {
        if self.magnitude == 0 {
            return I::from(0);
        }
        let shift = self.exponent - least;
        // Where the shift is negative the bits shifted out are zero, since none is below 2^least.
        let magnitude = if shift < 0 {
            I::from((self.magnitude >> -shift) as i64)
        } else {
            I::from(self.magnitude as i64) << shift
        };
        if self.negative { -magnitude } else { magnitude }
    }

    /// This value divided by 2^`least`, which must leave an integer.
    pub fn big_over(&self, least: i32) -> BigInt {
        self.over(least)
    }
}
