//! The bootstrap for a median of values that come in clusters.
//!
//! A cluster is one realisation of a point set, its values the repetitions on it. Realisations differ more
//! than repetitions do, so both are drawn again: first clusters, then values within each.

use super::summary::{deviation, mean, median, median_of, quantile};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// How often the data are drawn again.
const DRAWS: usize = 2_000;

/// A median with its bootstrap distribution.
#[derive(Clone, Debug)]
pub struct Bootstrapped {
    /// The median of the values as measured.
    pub median: f64,
    draws: Vec<f64>,
}

impl Bootstrapped {
    /// The central interval that holds `confidence` (0 to 1) of the bootstrap medians.
    pub fn interval(&self, confidence: f64) -> (f64, f64) {
        let tail = (1.0 - confidence) / 2.0;
        (
            quantile(&self.draws, tail),
            quantile(&self.draws, 1.0 - tail),
        )
    }

    /// The standard deviation of the bootstrap medians.
    pub fn standard_error(&self) -> f64 {
        deviation(&self.draws)
    }

    /// The two-sided p-value of the hypothesis that the true median is 0.
    pub fn p_value(&self) -> f64 {
        let count = |keep: fn(&f64) -> bool| self.draws.iter().filter(|draw| keep(draw)).count();
        let below = count(|draw| *draw <= 0.0);
        let above = count(|draw| *draw >= 0.0);
        let tail = (below.min(above) + 1) as f64 / (self.draws.len() + 1) as f64;
        (2.0 * tail).min(1.0)
    }

    /// The mean of several independent medians; `None` of none.
    pub fn mean_of(parts: &[Self]) -> Option<Self> {
        let first = parts.first()?;
        let share = 1.0 / parts.len() as f64;
        let draws = (0..first.draws.len())
            .map(|k| parts.iter().map(|part| part.draws[k]).sum::<f64>() * share)
            .collect();
        let median = parts.iter().map(|part| part.median).sum::<f64>() * share;
        Some(Self { median, draws })
    }

    /// This distribution less an independent other one.
    pub fn minus(&self, other: &Self) -> Self {
        let draws = self
            .draws
            .iter()
            .zip(&other.draws)
            .map(|(a, b)| a - b)
            .collect();
        Self {
            median: self.median - other.median,
            draws,
        }
    }
}

/// The median of all values in `clusters`, bootstrapped; `None` if there are no values.
pub fn clustered_median(clusters: &[Vec<f64>], seed: u64) -> Option<Bootstrapped> {
    let filled: Vec<&Vec<f64>> = clusters
        .iter()
        .filter(|cluster| !cluster.is_empty())
        .collect();
    if filled.is_empty() {
        return None;
    }
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut sample = Vec::new();
    let draws = (0..DRAWS)
        .map(|_| {
            sample.clear();
            for _ in 0..filled.len() {
                let cluster = filled[random.random_range(0..filled.len())];
                for _ in 0..cluster.len() {
                    sample.push(cluster[random.random_range(0..cluster.len())]);
                }
            }
            median_of(&mut sample)
        })
        .collect();
    let all: Vec<f64> = filled
        .iter()
        .flat_map(|cluster| cluster.iter().copied())
        .collect();
    Some(Bootstrapped {
        median: median(&all),
        draws,
    })
}

/// By how much the medians of the second lists exceed those of the first, in the mean over the clusters; bootstrapped.
/// `None` if no cluster has values on both sides.
///
/// A cluster holds what was measured on one realisation before and after, so that what realisations have of their own
/// cancels.
pub fn clustered_shift(clusters: &[(Vec<f64>, Vec<f64>)], seed: u64) -> Option<Bootstrapped> {
    let filled: Vec<&(Vec<f64>, Vec<f64>)> = clusters
        .iter()
        .filter(|(before, after)| !before.is_empty() && !after.is_empty())
        .collect();
    if filled.is_empty() {
        return None;
    }
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut sample = Vec::new();
    let mut drawn_median = |values: &[f64], random: &mut ChaCha8Rng| {
        sample.clear();
        sample.extend((0..values.len()).map(|_| values[random.random_range(0..values.len())]));
        median_of(&mut sample)
    };
    let draws = (0..DRAWS)
        .map(|_| {
            let sum: f64 = (0..filled.len())
                .map(|_| {
                    let (before, after) = filled[random.random_range(0..filled.len())];
                    drawn_median(after, &mut random) - drawn_median(before, &mut random)
                })
                .sum();
            sum / filled.len() as f64
        })
        .collect();
    let shifts: Vec<f64> = filled
        .iter()
        .map(|(before, after)| median(after) - median(before))
        .collect();
    Some(Bootstrapped {
        median: mean(&shifts),
        draws,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sum of twelve uniform draws, less its mean: variance 1.
    fn nearly_normal(random: &mut ChaCha8Rng) -> f64 {
        (0..12).map(|_| random.random::<f64>() - 0.5).sum()
    }

    #[test]
    fn the_interval_covers_as_often_as_it_says() {
        let mut random = ChaCha8Rng::seed_from_u64(7);
        let covered = (0..200)
            .filter(|round| {
                let clusters: Vec<Vec<f64>> = (0..12)
                    .map(|_| {
                        let shift = nearly_normal(&mut random);
                        (0..3)
                            .map(|_| shift + 0.1 * nearly_normal(&mut random))
                            .collect()
                    })
                    .collect();
                let median = clustered_median(&clusters, *round).expect("values");
                let (low, high) = median.interval(0.95);
                low <= 0.0 && 0.0 <= high
            })
            .count();
        assert!(
            (174..=200).contains(&covered),
            "{covered} of 200 intervals hold the true median"
        );
    }

    #[test]
    fn the_same_seed_gives_the_same_interval() {
        let clusters = vec![vec![1.0, 2.0, 3.0], vec![2.0, 4.0]];
        let of = |seed| {
            clustered_median(&clusters, seed)
                .expect("values")
                .interval(0.9)
        };
        assert_eq!(of(3), of(3));
        assert!(clustered_median(&[], 1).is_none());
        assert!(clustered_median(&[vec![]], 1).is_none());
    }

    #[test]
    fn a_shift_is_found_beneath_realisations_that_differ_much_more() {
        let mut random = ChaCha8Rng::seed_from_u64(11);
        let clusters: Vec<(Vec<f64>, Vec<f64>)> = (0..6)
            .map(|_| {
                let own = 10.0 * nearly_normal(&mut random);
                let mut side = |shift: f64| -> Vec<f64> {
                    let value = |_| own + shift + 0.1 * nearly_normal(&mut random);
                    (0..9).map(value).collect()
                };
                (side(0.0), side(0.3))
            })
            .collect();
        let shift = clustered_shift(&clusters, 1).expect("values");
        let (low, high) = shift.interval(0.95);
        assert!(
            low > 0.1 && high < 0.5 && low < 0.3 && high > 0.3,
            "{low} {high}"
        );
        assert!(shift.standard_error() < 0.1);
        let same: Vec<_> = clusters
            .iter()
            .map(|(a, _)| (a.clone(), a.clone()))
            .collect();
        assert!(clustered_shift(&same, 1).expect("values").median.abs() < 1e-15);
        assert!(clustered_shift(&[(vec![], vec![1.0])], 1).is_none());
    }

    #[test]
    fn p_values_separate_far_from_near() {
        let far = clustered_median(&vec![vec![1.0, 1.1, 0.9]; 5], 1).expect("values");
        let near = clustered_median(&vec![vec![-0.1, 0.0, 0.1]; 5], 1).expect("values");
        assert!(far.p_value() < 0.002 && near.p_value() > 0.5);
        assert!((far.minus(&near).median - 1.0).abs() < 1e-12);
    }
}
