//! Integers of a fixed width, for determinants whose size is known beforehand.

use num_bigint::{BigInt, Sign};
use std::cmp::Ordering;

/// What a determinant needs of its numbers.
pub trait Ring: Sized {
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// How it compares with zero.
    fn ordering(&self) -> Ordering;
}

/// Exact as long as no result overflows, like [`Int`].
impl Ring for i128 {
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        self.wrapping_add(*other)
    }
    #[inline(always)]
    fn minus(&self, other: &Self) -> Self {
        self.wrapping_sub(*other)
    }
    #[inline(always)]
    fn times(&self, other: &Self) -> Self {
        self.wrapping_mul(*other)
    }
    #[inline(always)]
    fn ordering(&self) -> Ordering {
        self.cmp(&0)
    }
}

impl Ring for BigInt {
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn ordering(&self) -> Ordering {
        match self.sign() {
            Sign::Minus => Ordering::Less,
            Sign::NoSign => Ordering::Equal,
            Sign::Plus => Ordering::Greater,
        }
    }
}

/// An integer modulo 2^(64 L), in `L` limbs, lowest first. Its operations are exact as long as every result is
/// at least -2^(64 L - 1) and below 2^(64 L - 1); whoever uses it sees to that by counting bits.
///
/// ```
/// use hull_verify::arithmetic::ring::{Int, Ring};
/// let x = Int::<4>::from(i128::MAX);
/// let square = x.times(&x);
/// assert!(square.minus(&x).ordering().is_gt());
/// assert!(x.minus(&square).ordering().is_lt());
/// assert!(x.minus(&x).times(&square).ordering().is_eq());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Int<const L: usize>([u64; L]);

impl<const L: usize> From<i128> for Int<L> {
    /// Needs two limbs at least.
    #[inline(always)]
    fn from(x: i128) -> Self {
        let mut limbs = [if x < 0 { u64::MAX } else { 0 }; L];
        limbs[0] = x as u64;
        limbs[1] = (x >> 64) as u64;
        Self(limbs)
    }
}

impl<const L: usize> Ring for Int<L> {
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        let mut carry = false;
        Self(std::array::from_fn(|i| {
            let (sum, over) = self.0[i].overflowing_add(other.0[i]);
            let (sum, again) = sum.overflowing_add(u64::from(carry));
            carry = over | again;
            sum
        }))
    }

    #[inline(always)]
    fn minus(&self, other: &Self) -> Self {
        let mut borrow = false;
        Self(std::array::from_fn(|i| {
            let (difference, under) = self.0[i].overflowing_sub(other.0[i]);
            let (difference, again) = difference.overflowing_sub(u64::from(borrow));
            borrow = under | again;
            difference
        }))
    }

    /// Schoolbook, without the limbs beyond the width: modulo a power of two the signs take care of themselves.
    #[inline(always)]
    fn times(&self, other: &Self) -> Self {
        let mut limbs = [0_u64; L];
        for i in 0..L {
            let mut carry = 0;
            for j in 0..L - i {
                // (2⁶⁴ - 1)² + 2 (2⁶⁴ - 1) = 2¹²⁸ - 1
                let sum = u128::from(self.0[i]) * u128::from(other.0[j])
                    + u128::from(limbs[i + j])
                    + u128::from(carry);
                limbs[i + j] = sum as u64;
                carry = (sum >> 64) as u64;
            }
        }
        Self(limbs)
    }

    #[inline(always)]
    fn ordering(&self) -> Ordering {
        if (self.0[L - 1] as i64) < 0 {
            Ordering::Less
        } else if self.0.iter().all(|&limb| limb == 0) {
            Ordering::Equal
        } else {
            Ordering::Greater
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// a b + c d - e f, which needs three bits more than two products.
    fn mixed<T: Ring>([a, b, c, d, e, f]: [T; 6]) -> T {
        a.times(&b).plus(&c.times(&d)).minus(&e.times(&f))
    }

    #[test]
    fn agrees_with_big_integers() {
        let mut rng = ChaCha8Rng::seed_from_u64(31);
        for _ in 0..50_000 {
            let mut numbers = [0_i128; 6];
            for x in &mut numbers {
                *x = rng.random::<i128>() >> rng.random_range(2..127);
            }
            if rng.random_range(0..4) == 0 {
                numbers = [
                    numbers[0], numbers[1], 0, numbers[2], numbers[1], numbers[0],
                ];
            }
            let big = mixed(numbers.map(BigInt::from)).ordering();
            assert_eq!(mixed(numbers.map(Int::<4>::from)).ordering(), big);
            assert_eq!(mixed(numbers.map(Int::<6>::from)).ordering(), big);
            assert_eq!(mixed(numbers.map(Int::<8>::from)).ordering(), big);
            let small = numbers.map(|x| x >> 64);
            let big = mixed(small.map(BigInt::from)).ordering();
            assert_eq!(mixed(small).ordering(), big);
        }
    }

    #[test]
    fn powers_fill_the_width() {
        let x = i128::MIN;
        let square = Int::<8>::from(x).times(&Int::from(x));
        assert!(square.ordering().is_gt());
        let cube = square.times(&Int::from(x));
        assert!(cube.ordering().is_lt());
        assert_eq!(cube.minus(&cube), Int::from(0));
        assert_eq!(
            cube.plus(&square.times(&Int::from(i128::MAX)))
                .plus(&square),
            Int::from(0)
        );
    }
}
