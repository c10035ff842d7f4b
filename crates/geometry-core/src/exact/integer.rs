//! Signed integers of a fixed capacity on the stack, enough for the determinants of scaled coordinates.

use crate::sign::Sign;
use std::cmp::Ordering;

/// An integer of up to `64 * LIMBS` bits and a sign.
///
/// Invariant: `limbs[len..]` is zero, `limbs[len - 1]` is not, and zero has `len == 0` and is not negative.
/// Exceeding the capacity is a panic (index out of bounds), never a wrong value; [`super::scaled`] chooses a
/// capacity that suffices.
#[derive(Clone, Copy)]
pub(super) struct Integer<const LIMBS: usize> {
    limbs: [u64; LIMBS],
    len: usize,
    negative: bool,
}

impl<const LIMBS: usize> Integer<LIMBS> {
    pub(super) const ZERO: Self = Self {
        limbs: [0; LIMBS],
        len: 0,
        negative: false,
    };

    /// ±`magnitude` · 2^`shift`.
    pub(super) fn shifted(negative: bool, magnitude: u64, shift: u32) -> Self {
        if magnitude == 0 {
            return Self::ZERO;
        }
        let mut result = Self {
            negative,
            ..Self::ZERO
        };
        let (limb, bit) = ((shift / 64) as usize, shift % 64);
        let wide = u128::from(magnitude) << bit;
        result.limbs[limb] = wide as u64;
        let high = (wide >> 64) as u64;
        if high != 0 {
            result.limbs[limb + 1] = high;
        }
        result.len = limb + 1 + usize::from(high != 0);
        result
    }

    pub(super) fn sign(&self) -> Sign {
        match (self.len, self.negative) {
            (0, _) => Sign::Zero,
            (_, true) => Sign::Negative,
            (_, false) => Sign::Positive,
        }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        if self.negative == other.negative {
            return self.add_magnitudes(other);
        }
        match self.compare_magnitudes(other) {
            Ordering::Equal => Self::ZERO,
            Ordering::Greater => self.subtract_magnitudes(other),
            Ordering::Less => other.subtract_magnitudes(self),
        }
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        let mut negated = *other;
        negated.negative = !other.negative && other.len > 0;
        self.plus(&negated)
    }

    /// Schoolbook: at these lengths (mostly one to four limbs) nothing is faster.
    pub(super) fn times(&self, other: &Self) -> Self {
        if self.len == 0 || other.len == 0 {
            return Self::ZERO;
        }
        let mut result = Self {
            negative: self.negative != other.negative,
            ..Self::ZERO
        };
        for (i, &x) in self.limbs[..self.len].iter().enumerate() {
            let mut carry = 0;
            for (j, &y) in other.limbs[..other.len].iter().enumerate() {
                let sum = u128::from(x) * u128::from(y)
                    + u128::from(result.limbs[i + j])
                    + u128::from(carry);
                result.limbs[i + j] = sum as u64;
                carry = (sum >> 64) as u64;
            }
            if carry != 0 {
                result.limbs[i + other.len] = carry;
            }
        }
        result.len = self.len + other.len;
        if result.limbs.get(result.len - 1).is_none_or(|&top| top == 0) {
            result.len -= 1;
        }
        result
    }

    /// |self| + |other|, with the sign of self.
    fn add_magnitudes(&self, other: &Self) -> Self {
        let (long, short) = if self.len >= other.len {
            (self, other)
        } else {
            (other, self)
        };
        let mut result = *long;
        result.negative = self.negative;
        let mut carry = false;
        for i in 0..long.len {
            if i >= short.len && !carry {
                return result;
            }
            (result.limbs[i], carry) = long.limbs[i].add_with_carry(short.limbs[i], carry);
        }
        if carry {
            result.limbs[long.len] = 1;
            result.len += 1;
        }
        result
    }

    /// |self| - |other| for |self| > |other|, with the sign of self.
    fn subtract_magnitudes(&self, other: &Self) -> Self {
        let mut result = *self;
        let mut borrow = false;
        for i in 0..self.len {
            if i >= other.len && !borrow {
                break;
            }
            (result.limbs[i], borrow) = self.limbs[i].sub_with_borrow(other.limbs[i], borrow);
        }
        while result.limbs[result.len - 1] == 0 {
            result.len -= 1;
        }
        result
    }

    fn compare_magnitudes(&self, other: &Self) -> Ordering {
        self.len.cmp(&other.len).then_with(|| {
            let (mine, theirs) = (&self.limbs[..self.len], &other.limbs[..other.len]);
            mine.iter().rev().cmp(theirs.iter().rev())
        })
    }
}

/// Addition and subtraction of one limb with a carry.
trait Limb: Sized {
    fn add_with_carry(self, other: Self, carry: bool) -> (Self, bool);
    fn sub_with_borrow(self, other: Self, borrow: bool) -> (Self, bool);
}

impl Limb for u64 {
    fn add_with_carry(self, other: u64, carry: bool) -> (u64, bool) {
        let (sum, first) = self.overflowing_add(other);
        let (sum, second) = sum.overflowing_add(u64::from(carry));
        (sum, first || second)
    }

    fn sub_with_borrow(self, other: u64, borrow: bool) -> (u64, bool) {
        let (difference, first) = self.overflowing_sub(other);
        let (difference, second) = difference.overflowing_sub(u64::from(borrow));
        (difference, first || second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::{BigInt, Sign as BigSign};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    type Small = Integer<12>;

    fn big(x: &Small) -> BigInt {
        let digits: Vec<u32> = x
            .limbs
            .iter()
            .flat_map(|&l| [l as u32, (l >> 32) as u32])
            .collect();
        let sign = if x.negative {
            BigSign::Minus
        } else {
            BigSign::Plus
        };
        BigInt::from_slice(sign, &digits)
    }

    /// Magnitudes that make long carries and borrows as likely as ordinary ones.
    fn random(rng: &mut ChaCha8Rng) -> Small {
        let magnitude = match rng.random_range(0..4) {
            0 => 0,
            1 => u64::MAX,
            2 => 1 << rng.random_range(0..64),
            _ => rng.random(),
        };
        let shift = rng.random_range(0..120);
        let x = Small::shifted(rng.random(), magnitude, shift);
        let unit = Small::shifted(rng.random(), rng.random_range(0..3), 0);
        x.plus(&unit)
    }

    #[test]
    fn agrees_with_big_integers() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        for _ in 0..200_000 {
            let (x, y, z) = (random(&mut rng), random(&mut rng), random(&mut rng));
            let product = x.times(&y);
            assert_eq!(big(&product), big(&x) * big(&y));
            let sum = product.plus(&z);
            assert_eq!(big(&sum), big(&x) * big(&y) + big(&z));
            let difference = product.minus(&z.times(&y));
            let expected = big(&x) * big(&y) - big(&z) * big(&y);
            assert_eq!(big(&difference), expected);
            assert_eq!(difference.sign() == Sign::Zero, expected == BigInt::ZERO);
            for value in [product, sum, difference] {
                assert!(value.len == 0 || value.limbs[value.len - 1] != 0);
            }
        }
    }
}
