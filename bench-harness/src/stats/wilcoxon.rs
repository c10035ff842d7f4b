//! Whether differences have their middle at zero.
//!
//! F. Wilcoxon, *Individual comparisons by ranking methods*, Biometrics Bulletin 1 (1945): the signed-rank test.
//! Exact for up to 50 differences, also with ties; beyond, by the normal approximation.

use super::ranks;
use statrs::distribution::{ContinuousCDF, Normal};

/// Up to so many differences the distribution is counted out.
const EXACT: usize = 50;

/// The two-sided p-value of the hypothesis that `differences` are symmetric about zero; zeros are left out. 1 of none.
///
/// Time and space O(n³) up to 50 differences, O(n log n) beyond.
///
/// ```
/// use bench_harness::stats::wilcoxon::signed_rank;
/// // All five positive: 2 of the 32 assignments of signs are as extreme.
/// assert!((signed_rank(&[1.0, 2.0, 3.0, 4.0, 5.0]) - 2.0 / 32.0).abs() < 1e-12);
/// ```
pub fn signed_rank(differences: &[f64]) -> f64 {
    let kept: Vec<f64> = differences
        .iter()
        .copied()
        .filter(|difference| *difference != 0.0)
        .collect();
    let sizes: Vec<f64> = kept.iter().map(|difference| difference.abs()).collect();
    let ranks = ranks::doubled(&sizes);
    let total: u64 = ranks.iter().sum();
    let positive: u64 = ranks
        .iter()
        .zip(&kept)
        .filter(|(_, difference)| **difference > 0.0)
        .map(|(rank, _)| rank)
        .sum();
    let smaller = positive.min(total - positive);
    if kept.len() <= EXACT {
        exact(&ranks, smaller, total)
    } else {
        approximate(&ranks, smaller, total)
    }
}

/// Twice the share of the assignments of signs whose positive ranks sum to at most `smaller`.
fn exact(ranks: &[u64], smaller: u64, total: u64) -> f64 {
    // shares[s]: the share of the assignments so far whose positive ranks sum to s.
    let mut shares = vec![0.0; total as usize + 1];
    shares[0] = 1.0;
    for &rank in ranks {
        let rank = rank as usize;
        for sum in (0..shares.len()).rev() {
            let with = if sum >= rank { shares[sum - rank] } else { 0.0 };
            shares[sum] = (shares[sum] + with) / 2.0;
        }
    }
    let tail: f64 = shares[..=smaller as usize].iter().sum();
    (2.0 * tail).min(1.0)
}

fn approximate(ranks: &[u64], smaller: u64, total: u64) -> f64 {
    let squares: f64 = ranks.iter().map(|rank| (*rank as f64).powi(2)).sum();
    let deviation = squares.sqrt() / 2.0;
    // Doubled ranks move by two: half of that is the correction for continuity.
    let z = (smaller as f64 + 1.0 - total as f64 / 2.0).min(0.0) / deviation;
    Normal::standard().cdf(z) * 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    #[test]
    fn known_values() {
        // W+ = 40 of 55 with n = 10: P(W+ >= 40) = 0.11621, by the tables.
        let values = [1.0, 2.0, -3.0, 4.0, -5.0, 6.0, -7.0, 8.0, 9.0, 10.0];
        assert!((signed_rank(&values) - 2.0 * 0.116_21).abs() < 1e-4);
        assert!((signed_rank(&[]) - 1.0).abs() < 1e-15);
        assert!((signed_rank(&[0.0, 0.0]) - 1.0).abs() < 1e-15);
        // Ties: ranks 1.5, 1.5, 3; W- = 1.5 or less in 3 of 8 assignments.
        assert!((signed_rank(&[1.0, -1.0, 2.0]) - 0.75).abs() < 1e-12);
    }

    #[test]
    fn false_alarms_are_as_rare_as_they_say() {
        for n in [8, 30, 80] {
            let mut random = ChaCha8Rng::seed_from_u64(n);
            let mut alarm = || {
                let values: Vec<f64> = (0..n).map(|_| random.random::<f64>() - 0.5).collect();
                signed_rank(&values) < 0.05
            };
            let alarms = (0..1_000).filter(|_| alarm()).count();
            assert!((20..=75).contains(&alarms), "n {n}: {alarms} of 1000");
        }
    }

    #[test]
    fn the_approximation_continues_the_exact_values() {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        let values: Vec<f64> = (0..EXACT).map(|_| random.random::<f64>() - 0.4).collect();
        let sizes: Vec<f64> = values.iter().map(|value| value.abs()).collect();
        let ranks = ranks::doubled(&sizes);
        let total = ranks.iter().sum::<u64>();
        for smaller in [total / 4, total / 3, total / 2 - 20] {
            let (a, b) = (
                exact(&ranks, smaller, total),
                approximate(&ranks, smaller, total),
            );
            assert!((a - b).abs() < 0.004, "{a} {b}");
        }
    }
}
