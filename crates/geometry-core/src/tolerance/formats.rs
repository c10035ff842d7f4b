//! Number formats for [`Tolerance`](super::Tolerance): today's and those of the machines of Table 1.

use super::soft::{Rounding, Soft};

/// A number format in which areas and angles are computed.
pub trait Format: Copy {
    /// Its name in tables and on the command line.
    const NAME: &'static str;
    /// The number nearest to `x` in the sense of the format's rounding.
    fn of(x: f64) -> Self;
    /// The sum, rounded.
    fn plus(self, other: Self) -> Self;
    /// The difference, rounded.
    fn minus(self, other: Self) -> Self;
    /// The product, rounded.
    fn times(self, other: Self) -> Self;
    /// The quotient, rounded; `None` if `other` is zero.
    fn over(self, other: Self) -> Option<Self>;
    /// The square root, rounded; `None` of a negative number.
    fn root(self) -> Option<Self>;
    /// The value as `f64` (rounded to nearest where `f64` is shorter).
    fn to_f64(self) -> f64;
}

/// IEEE 754 binary32.
#[derive(Clone, Copy, Debug)]
pub struct Single(f32);

impl Format for Single {
    const NAME: &'static str = "f32";
    fn of(x: f64) -> Self {
        Self(x as f32)
    }
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
    fn minus(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
    fn times(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
    fn over(self, other: Self) -> Option<Self> {
        (other.0 != 0.0).then(|| Self(self.0 / other.0))
    }
    fn root(self) -> Option<Self> {
        (self.0 >= 0.0).then(|| Self(self.0.sqrt()))
    }
    fn to_f64(self) -> f64 {
        f64::from(self.0)
    }
}

/// IEEE 754 binary64.
#[derive(Clone, Copy, Debug)]
pub struct Double(f64);

impl Format for Double {
    const NAME: &'static str = "f64";
    fn of(x: f64) -> Self {
        Self(x)
    }
    fn plus(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
    fn minus(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
    fn times(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
    fn over(self, other: Self) -> Option<Self> {
        (other.0 != 0.0).then(|| Self(self.0 / other.0))
    }
    fn root(self) -> Option<Self> {
        (self.0 >= 0.0).then(|| Self(self.0.sqrt()))
    }
    fn to_f64(self) -> f64 {
        self.0
    }
}

/// Gives a [`Soft`] instance the interface of a format.
macro_rules! soft_format {
    ($(#[$doc:meta])* $name:ident, $label:literal, $soft:ty) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub struct $name($soft);

        impl Format for $name {
            const NAME: &'static str = $label;
            fn of(x: f64) -> Self {
                Self(<$soft>::of(x))
            }
            fn plus(self, other: Self) -> Self {
                Self(self.0.plus(other.0))
            }
            fn minus(self, other: Self) -> Self {
                Self(self.0.minus(other.0))
            }
            fn times(self, other: Self) -> Self {
                Self(self.0.times(other.0))
            }
            fn over(self, other: Self) -> Option<Self> {
                self.0.over(other.0).map(Self)
            }
            fn root(self) -> Option<Self> {
                self.0.root().map(Self)
            }
            fn to_f64(self) -> f64 {
                self.0.to_f64()
            }
        }
    };
}

soft_format!(
    /// The 80-bit extended format of the x87 and of SANE: 64-bit significand, rounded to nearest even.
    Extended,
    "extended",
    Soft<2, 64, { Rounding::NEAREST }>
);
soft_format!(
    /// IBM System/370 short: six hexadecimal digits, one guard digit, truncated.
    IbmShort,
    "ibm370",
    Soft<16, 6, { Rounding::TRUNCATE_WITH_GUARD_DIGIT }>
);
soft_format!(
    /// CDC 7600 single: 48 binary digits, a double-length sum, truncated.
    Cdc7600,
    "cdc7600",
    Soft<2, 48, { Rounding::TRUNCATE }>
);
