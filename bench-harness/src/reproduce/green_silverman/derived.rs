//! What tables, figures and verdicts compute from the records, cell by cell.

use super::records::Records;
use crate::reproduce::rows::CountRow;
use crate::stats::summary::{mean, median, standard_error};
use std::collections::BTreeMap;

/// The second entry of GS, which shows the noise of a program against itself.
pub(crate) const TWIN: &str = "gs@twin";

/// A distribution and a size.
pub(crate) type Cell<'a> = (&'a str, usize);

/// The number of vertices over the replicates of a cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sizes {
    pub(crate) replicates: u64,
    pub(crate) mean: f64,
    pub(crate) deviation: f64,
}

impl Sizes {
    /// The standard error of the mean of `count` replicates.
    pub(crate) fn error(&self, count: f64) -> f64 {
        self.deviation / count.sqrt()
    }

    /// How many standard errors our mean is above `expected`.
    pub(crate) fn z(&self, expected: f64) -> f64 {
        (self.mean - expected) / self.error(self.replicates as f64)
    }
}

/// A ratio of average counts on the same sets: its logarithm, and the standard error of that.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CountRatio {
    pub(crate) log: f64,
    pub(crate) error: f64,
}

impl CountRatio {
    /// The ratio itself.
    pub(crate) fn ratio(&self) -> f64 {
        self.log.exp()
    }

    /// The logarithm with three standard errors on each side; a single set has no error to show.
    pub(crate) fn interval(&self) -> (f64, f64) {
        let error = if self.error.is_nan() { 0.0 } else { self.error };
        (self.log - 3.0 * error, self.log + 3.0 * error)
    }
}

/// The number of vertices in `cell`, if it was measured.
pub(crate) fn sizes(records: &Records, cell: Cell<'_>) -> Option<Sizes> {
    let rows = records
        .sizes
        .iter()
        .filter(|row| (row.distribution.as_str(), row.n) == cell);
    let histogram: Vec<(f64, f64)> = rows
        .map(|row| (row.vertices as f64, row.replicates as f64))
        .collect();
    let total: f64 = histogram.iter().map(|(_, count)| count).sum();
    if total < 2.0 {
        return None;
    }
    let mean = histogram
        .iter()
        .map(|(vertices, count)| vertices * count)
        .sum::<f64>()
        / total;
    let squares: f64 = histogram
        .iter()
        .map(|(vertices, count)| count * (vertices - mean).powi(2))
        .sum();
    let deviation = (squares / (total - 1.0)).sqrt();
    Some(Sizes {
        replicates: total as u64,
        mean,
        deviation,
    })
}

/// The counted runs of `method` in `cell`.
pub(crate) fn counts<'a>(
    records: &'a Records,
    cell: Cell<'a>,
    method: &'a str,
) -> impl Iterator<Item = &'a CountRow> {
    let same =
        move |row: &&CountRow| (row.distribution.as_str(), row.n) == cell && row.method == method;
    records.counts.iter().filter(same)
}

/// The mean of `quantity` a point over the counted runs of `method` in `cell`.
pub(crate) fn a_point(
    records: &Records,
    cell: Cell<'_>,
    method: &str,
    quantity: fn(&CountRow) -> u64,
) -> Option<f64> {
    let values: Vec<f64> = counts(records, cell, method)
        .map(|row| quantity(row) as f64 / row.n as f64)
        .collect();
    (!values.is_empty()).then(|| mean(&values))
}

/// The `quantity` of `method` over that of `base`, each averaged over the same sets of `cell`.
pub(crate) fn count_ratio(
    records: &Records,
    cell: Cell<'_>,
    method: &str,
    base: &str,
    quantity: fn(&CountRow) -> u64,
) -> Option<CountRatio> {
    let of = |method| -> BTreeMap<u64, f64> {
        counts(records, cell, method)
            .map(|row| (row.replicate, quantity(row) as f64))
            .collect()
    };
    let (above, below) = (of(method), of(base));
    let pairs: Vec<(f64, f64)> = above
        .iter()
        .filter_map(|(replicate, count)| Some((*count, *below.get(replicate)?)))
        .collect();
    if pairs.is_empty() {
        return None;
    }
    let average =
        |side: fn(&(f64, f64)) -> f64| mean(&pairs.iter().map(side).collect::<Vec<f64>>());
    let (above, below) = (average(|pair| pair.0), average(|pair| pair.1));
    // To first order the logarithm of the ratio moves with the difference of the relative deviations.
    let deviations: Vec<f64> = pairs.iter().map(|(a, b)| a / above - b / below).collect();
    Some(CountRatio {
        log: (above / below).ln(),
        error: standard_error(&deviations),
    })
}

/// For each realisation of each timed cell of `distribution`, n and the median time of `method`.
pub(crate) fn times_against_n(
    records: &Records,
    distribution: &str,
    method: &str,
) -> Vec<(usize, f64)> {
    let mut groups: BTreeMap<(usize, u64), Vec<f64>> = BTreeMap::new();
    for row in &records.times {
        if row.distribution == distribution && row.method == method {
            groups
                .entry((row.n, row.realisation))
                .or_default()
                .push(row.per_call());
        }
    }
    groups
        .into_iter()
        .map(|((n, _), times)| (n, median(&times)))
        .collect()
}

/// For each counted run of `method` on `distribution`, n and `quantity`.
pub(crate) fn counts_against_n(
    records: &Records,
    distribution: &str,
    method: &str,
    quantity: fn(&CountRow) -> u64,
) -> Vec<(usize, f64)> {
    let rows = records.counts.iter();
    rows.filter(|row| row.distribution == distribution && row.method == method)
        .map(|row| (row.n, quantity(row) as f64))
        .collect()
}

/// The data of the two upper decades of n: where an asymptotic statement is to be looked for.
pub(crate) fn upper_decades(data: &[(usize, f64)]) -> Vec<(f64, f64)> {
    let largest = data.iter().map(|(n, _)| *n).max().unwrap_or(0);
    data.iter()
        .filter(|(n, _)| 100 * n >= largest)
        .map(|&(n, y)| (n as f64, y))
        .collect()
}

/// "from … to …", for the sizes in `data`.
pub(crate) fn range(data: &[(f64, f64)]) -> String {
    let least = data.iter().map(|(n, _)| *n).fold(f64::INFINITY, f64::min);
    let most = data.iter().map(|(n, _)| *n).fold(0.0, f64::max);
    format!("n from {least} to {most}")
}
