//! Exact sums and products of `f64`s as expansions (Shewchuk 1997).
//!
//! An expansion is a sum of terms that do not overlap in their bits, in order of increasing magnitude; its sign
//! is that of its last term. Terms that are zero are dropped as they arise.
//!
//! Exact as long as no product or sum overflows and no bit falls below 2⁻¹⁰⁷⁴, which the callers check once
//! from the exponents of the coordinates.

use crate::sign::Sign;

/// `a + b` = sum + error, exactly.
#[inline]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_virtual = sum - a;
    let a_virtual = sum - b_virtual;
    (sum, (a - a_virtual) + (b - b_virtual))
}

/// [`two_sum`] for |a| ≥ |b|.
#[inline]
fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// The error of the rounded difference: `a - b` = `difference` + the result, exactly.
#[inline]
pub(super) fn difference_tail(a: f64, b: f64, difference: f64) -> f64 {
    let b_virtual = a - difference;
    let a_virtual = difference + b_virtual;
    (a - a_virtual) + (b_virtual - b)
}

/// `a` = high + low, each of at most 26 bits.
#[inline]
fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = (1_u64 << 27) as f64 + 1.0;
    let scaled = SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// `a · b` = product + error, exactly.
#[inline]
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let error = ((product - a_high * b_high) - a_low * b_high) - a_high * b_low;
    (product, a_low * b_low - error)
}

/// A sum of at most `N` terms, exact.
#[derive(Clone, Copy)]
pub(super) struct Expansion<const N: usize> {
    terms: [f64; N],
    len: usize,
}

impl<const N: usize> Expansion<N> {
    const ZERO: Self = Self {
        terms: [0.0; N],
        len: 0,
    };

    #[inline]
    fn push(&mut self, term: f64) {
        if term != 0.0 {
            self.terms[self.len] = term;
            self.len += 1;
        }
    }

    fn terms(&self) -> &[f64] {
        &self.terms[..self.len]
    }

    /// The sign of the exact value.
    pub(super) fn sign(&self) -> Sign {
        Sign::of(self.terms().last().copied().unwrap_or(0.0))
    }

    /// The value to within a few units in the last place.
    pub(super) fn estimate(&self) -> f64 {
        self.terms().iter().sum()
    }

    /// The exact sum. `S` must be at least `N + M`.
    pub(super) fn plus<const M: usize, const S: usize>(
        &self,
        other: &Expansion<M>,
    ) -> Expansion<S> {
        // Merge by magnitude; carry the running sum upwards and leave the roundoff behind.
        let (e, f) = (self.terms(), other.terms());
        let (mut i, mut j) = (0, 0);
        let mut next = || {
            let from_e = i < e.len() && (j >= f.len() || e[i].abs() < f[j].abs());
            let term = if from_e { e.get(i) } else { f.get(j) };
            i += usize::from(from_e);
            j += usize::from(!from_e);
            term.copied()
        };
        let mut result = Expansion::ZERO;
        let Some(mut sum) = next() else { return result };
        while let Some(term) = next() {
            let (total, error) = two_sum(sum, term);
            result.push(error);
            sum = total;
        }
        result.push(sum);
        result
    }

    /// The exact product with one number. `S` must be at least `2 N`.
    pub(super) fn times<const S: usize>(&self, factor: f64) -> Expansion<S> {
        let mut result = Expansion::ZERO;
        let Some((&first, rest)) = self.terms().split_first() else {
            return result;
        };
        let (mut sum, error) = two_product(first, factor);
        result.push(error);
        for &term in rest {
            let (high, low) = two_product(term, factor);
            let (middle, error) = two_sum(sum, low);
            result.push(error);
            let (total, error) = fast_two_sum(high, middle);
            result.push(error);
            sum = total;
        }
        result.push(sum);
        result
    }
}

/// `a·b - c·d`, exactly.
#[inline]
pub(super) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> Expansion<4> {
    let (left, left_error) = two_product(a, b);
    let (right, right_error) = two_product(c, d);
    let (x0, carry, rest) = two_one_diff(left, left_error, right_error);
    let (x1, x2, x3) = two_one_diff(rest, carry, right);
    let mut result = Expansion::ZERO;
    for term in [x0, x1, x2, x3] {
        result.push(term);
    }
    result
}

/// (high + low) - b as three terms, the smallest first.
#[inline]
fn two_one_diff(high: f64, low: f64, b: f64) -> (f64, f64, f64) {
    let (partial, smallest) = two_sum(low, -b);
    let (largest, middle) = two_sum(high, partial);
    (smallest, middle, largest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigInt;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// The value times 2^400, which is an integer for the numbers tested.
    fn big(terms: &[f64]) -> BigInt {
        terms
            .iter()
            .map(|&t| {
                let bits = t.to_bits();
                let magnitude = if t == 0.0 {
                    0
                } else {
                    bits & ((1 << 52) - 1) | 1 << 52
                };
                let exponent = (bits >> 52 & 0x7ff) as i32 - 1075 + 400;
                let value = BigInt::from(magnitude) << exponent.max(0);
                if t < 0.0 { -value } else { value }
            })
            .sum()
    }

    fn number(rng: &mut ChaCha8Rng) -> f64 {
        match rng.random_range(0..6) {
            0 => 0.0,
            1 => f64::from(rng.random_range(-3..4)),
            _ => (rng.random::<f64>() - 0.5) * 2_f64.powi(rng.random_range(-30..30)),
        }
    }

    fn assert_ordered<const N: usize>(e: &Expansion<N>) {
        for pair in e.terms().windows(2) {
            assert!(
                pair[0].abs() < pair[1].abs(),
                "terms out of order: {:?}",
                e.terms()
            );
        }
    }

    #[test]
    fn sums_and_products_are_exact() {
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let scale = BigInt::from(1) << 400;
        for _ in 0..200_000 {
            let [a, b, c, d, x, y] = std::array::from_fn(|_| number(&mut rng));
            let first = difference_of_products(a, b, c, d);
            assert_ordered(&first);
            let exact = (big(&[a]) * big(&[b]) - big(&[c]) * big(&[d])) / &scale;
            assert_eq!(big(first.terms()), exact, "{a:?} {b:?} {c:?} {d:?}");
            let second = difference_of_products(x, y, b, c);
            let sum: Expansion<8> = first.plus(&second);
            assert_ordered(&sum);
            assert_eq!(big(sum.terms()), big(first.terms()) + big(second.terms()));
            let product: Expansion<16> = sum.times(d);
            assert_ordered(&product);
            assert_eq!(big(product.terms()), big(sum.terms()) * big(&[d]) / &scale);
            assert_eq!(
                product.sign() == Sign::Zero,
                big(product.terms()) == BigInt::ZERO
            );
        }
    }
}
