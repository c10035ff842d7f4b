//! The sign of a determinant: the only thing a hull algorithm ever learns about coordinates.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

/// The sign of an exact value.
///
/// For an orientation of three points, `Positive` is anticlockwise (a left turn), `Negative` clockwise,
/// `Zero` collinear.
///
/// ```
/// use geometry_core::Sign;
/// assert_eq!(Sign::of(-2.5), Sign::Negative);
/// assert_eq!(-Sign::Negative, Sign::Positive);
/// assert_eq!(Sign::Negative * Sign::Negative, Sign::Positive);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// Less than zero: clockwise, a right turn.
    Negative = -1,
    /// Exactly zero: collinear, cocircular, coplanar.
    Zero = 0,
    /// Greater than zero: anticlockwise, a left turn.
    Positive = 1,
}

impl Sign {
    /// The sign of `value`; `Zero` for both zeros and for NaN.
    #[inline(always)]
    pub fn of(value: f64) -> Self {
        if value > 0.0 {
            Sign::Positive
        } else if value < 0.0 {
            Sign::Negative
        } else {
            Sign::Zero
        }
    }

    /// Whether this is `Positive`.
    #[inline(always)]
    pub fn is_positive(self) -> bool {
        self == Sign::Positive
    }

    /// Whether this is `Negative`.
    #[inline(always)]
    pub fn is_negative(self) -> bool {
        self == Sign::Negative
    }

    /// Whether this is `Zero`.
    #[inline(always)]
    pub fn is_zero(self) -> bool {
        self == Sign::Zero
    }

    /// The comparison of a value of this sign with zero.
    #[inline(always)]
    pub fn ordering(self) -> Ordering {
        match self {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        }
    }
}

impl From<Ordering> for Sign {
    #[inline(always)]
    fn from(ordering: Ordering) -> Self {
        match ordering {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Sign;
    #[inline(always)]
    fn neg(self) -> Sign {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Sign;
    #[inline(always)]
    fn mul(self, other: Sign) -> Sign {
        match self {
            Sign::Negative => -other,
            Sign::Zero => Sign::Zero,
            Sign::Positive => other,
        }
    }
}
