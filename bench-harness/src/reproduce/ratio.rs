//! What was timed, and times of one contestant over another's, from the samples.

use super::rows::TimeRow;
use crate::records::rows::twin_of;
use crate::stats::bootstrap::{Bootstrapped, clustered_median};
use crate::stats::summary::median;
use std::collections::BTreeMap;

/// The median nanoseconds a call of `method` in the cell (distribution, n).
pub(crate) fn median_time(rows: &[TimeRow], cell: (&str, usize), method: &str) -> Option<f64> {
    let values: Vec<f64> = of(rows, cell, method).map(TimeRow::per_call).collect();
    (!values.is_empty()).then(|| median(&values))
}

/// The logarithm of the time of `method` over that of `base` in the cell: median of the rounds' log ratios,
/// bootstrapped over realisations.
pub(crate) fn time_ratio(
    rows: &[TimeRow],
    cell: (&str, usize),
    method: &str,
    base: &str,
) -> Option<Bootstrapped> {
    let by_round = |method| -> BTreeMap<(u64, u32), f64> {
        of(rows, cell, method)
            .map(|row| ((row.realisation, row.round), row.per_call()))
            .collect()
    };
    let below = by_round(base);
    let mut clusters: BTreeMap<u64, Vec<f64>> = BTreeMap::new();
    for (key, time) in by_round(method) {
        if let Some(base) = below.get(&key) {
            clusters.entry(key.0).or_default().push((time / base).ln());
        }
    }
    let clusters: Vec<Vec<f64>> = clusters.into_values().collect();
    clustered_median(&clusters, cell.1 as u64)
}

/// The cells that were timed, in the order of the records.
pub(crate) fn timed_cells(rows: &[TimeRow]) -> Vec<(String, usize)> {
    let mut cells: Vec<(String, usize)> = Vec::new();
    for row in rows {
        let is_same = |cell: &(String, usize)| cell.0 == row.distribution && cell.1 == row.n;
        if !cells.iter().any(is_same) {
            cells.push((row.distribution.clone(), row.n));
        }
    }
    cells
}

/// The methods timed in `cell`, in the order of the alphabet, twins left out.
pub(crate) fn timed_methods(rows: &[TimeRow], cell: (&str, usize)) -> Vec<String> {
    let here = rows
        .iter()
        .filter(|row| (row.distribution.as_str(), row.n) == cell);
    let mut methods: Vec<String> = here.map(|row| row.method.clone()).collect();
    methods.sort();
    methods.dedup();
    methods.retain(|method| twin_of(method).is_none());
    methods
}

fn of<'a>(
    rows: &'a [TimeRow],
    cell: (&'a str, usize),
    method: &'a str,
) -> impl Iterator<Item = &'a TimeRow> {
    rows.iter()
        .filter(move |row| (row.distribution.as_str(), row.n) == cell && row.method == method)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_are_taken_round_by_round() {
        let row = |method: &str, realisation, nanoseconds| TimeRow {
            distribution: "ball".into(),
            n: 10,
            realisation,
            round: 0,
            method: method.into(),
            calls: 2,
            nanoseconds,
        };
        let rows = [
            row("a", 0, 20),
            row("b", 0, 10),
            row("a", 1, 400),
            row("b", 1, 200),
        ];
        let ratio = time_ratio(&rows, ("ball", 10), "a", "b").expect("samples");
        assert!((ratio.median.exp() - 2.0).abs() < 1e-12);
        assert_eq!(median_time(&rows, ("ball", 10), "b"), Some(52.5));
        assert!(time_ratio(&rows, ("ball", 11), "a", "b").is_none());
    }
}
