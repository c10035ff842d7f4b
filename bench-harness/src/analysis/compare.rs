//! Two engines on one case, round by round.
//!
//! In a round both were sampled within a moment, so what disturbed the machine disturbed both: the statistic is the
//! median of the logarithms of their ratio in each round, and its interval draws realisations again, and rounds
//! within each.

use super::seed_of;
use crate::records::{Case, Run};
use crate::stats::bootstrap::{Bootstrapped, clustered_median};
use crate::stats::freedom;
use crate::stats::interval::p_beyond;
use crate::stats::spearman::{self, Correlation};
use crate::stats::wilcoxon::signed_rank;
use std::collections::BTreeMap;

/// The times of one engine over those of another.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The logarithm of the ratio.
    pub log: Bootstrapped,
    /// Rounds in which both were sampled, on all realisations together.
    pub pairs: usize,
    /// Realisations on which both were sampled.
    pub realisations: usize,
    /// The degrees of freedom of the scatter: few if the realisations differ and there are few of them.
    pub freedom: f64,
    /// The two-sided p-value of no difference, by Wilcoxon's signed ranks.
    pub wilcoxon: f64,
    /// How the ratio moves with the rounds; `None` if there are too few.
    pub drift: Option<Correlation>,
}

impl Comparison {
    /// `engine` over `baseline` on `case`; `None` if they share no round.
    pub fn of(run: &Run, case: &Case, engine: &str, baseline: &str) -> Option<Self> {
        let clusters = log_ratios(run, case, engine, baseline);
        let values = |cluster: &Vec<(u32, f64)>| cluster.iter().map(|(_, log)| *log).collect();
        let logs: Vec<Vec<f64>> = clusters.iter().map(values).collect();
        let seed = seed_of(&[&case.to_string(), engine, baseline]);
        let flat: Vec<f64> = logs.iter().flatten().copied().collect();
        let in_order = clusters.iter().flatten();
        let by_round: Vec<(f64, f64)> = in_order
            .map(|(round, log)| (f64::from(*round), *log))
            .collect();
        Some(Self {
            log: clustered_median(&logs, seed)?,
            pairs: flat.len(),
            realisations: logs.len(),
            freedom: freedom::of_clusters(&logs),
            wilcoxon: signed_rank(&flat),
            drift: spearman::correlation(&by_round),
        })
    }

    /// The p-value of a true ratio within the band of `half_width` (a logarithm).
    pub fn p_beyond(&self, half_width: f64) -> f64 {
        let error = self.log.standard_error();
        p_beyond(self.log.median, error, self.freedom, half_width)
    }
}

/// The logarithm of the ratio in every round that both were sampled in, a list a realisation.
fn log_ratios(run: &Run, case: &Case, engine: &str, baseline: &str) -> Vec<Vec<(u32, f64)>> {
    let others = run.times(case, baseline).iter();
    let by_seed: BTreeMap<u64, BTreeMap<u32, f64>> = others
        .map(|realisation| {
            (
                realisation.seed,
                realisation.rounds.iter().copied().collect(),
            )
        })
        .collect();
    let shared = run.times(case, engine).iter().filter_map(|realisation| {
        let others = by_seed.get(&realisation.seed)?;
        let ratio = |(round, time): &(u32, f64)| Some((*round, (time / others.get(round)?).ln()));
        let ratios: Vec<_> = realisation.rounds.iter().filter_map(ratio).collect();
        (!ratios.is_empty()).then_some(ratios)
    });
    shared.collect()
}
