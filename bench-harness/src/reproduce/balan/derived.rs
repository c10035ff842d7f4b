//! What tables, figures and verdicts compute from the records, cell by cell.

use super::experiments::times::TWIN;
use super::records::Records;
use crate::reproduce::space::rows::CountRow;
use crate::stats::line::{Line, fit_log_log};
use crate::stats::summary::mean;
use std::collections::BTreeMap;

/// A distribution and a size.
pub(crate) type Cell<'a> = (&'a str, usize);

/// The triangles of the surface at the end, coplanar ones apart.
pub(crate) fn triangles(row: &CountRow) -> u64 {
    row.facets - row.drops
}

/// Orientations asked to tell on which side of a facet's plane a point lies.
///
/// Merging coplanar triangles asks three for each triangle. The two insertions ask one for their first
/// tetrahedron, if the first four points of the order span space; the few that the quickhulls ask for theirs are
/// left in.
pub(crate) fn plane_tests(row: &CountRow) -> f64 {
    let start = u64::from(row.method.starts_with("incremental"));
    row.orientations as f64 - (start + 3 * triangles(row)) as f64
}

/// All questions of every kind.
pub(crate) fn questions(row: &CountRow) -> f64 {
    (row.orientations + row.heights + row.shadows + row.lexicographic) as f64
}

/// The counted runs of `method` on `distribution`.
pub(crate) fn runs<'a>(
    records: &'a Records,
    distribution: &'a str,
    method: &'a str,
) -> impl Iterator<Item = &'a CountRow> {
    records
        .counts
        .iter()
        .filter(move |row| row.distribution == distribution && row.method == method)
}

/// n and `quantity` of each run.
pub(crate) fn against_n<'a>(
    runs: impl Iterator<Item = &'a CountRow>,
    quantity: impl Fn(&CountRow) -> f64,
) -> Vec<(f64, f64)> {
    runs.map(|row| (row.n as f64, quantity(row))).collect()
}

/// The values of each n, by n.
pub(crate) fn groups(data: &[(f64, f64)]) -> Vec<(f64, Vec<f64>)> {
    let mut groups: BTreeMap<u64, Vec<f64>> = BTreeMap::new();
    for &(n, value) in data {
        groups.entry(n as u64).or_default().push(value);
    }
    groups
        .into_iter()
        .map(|(n, values)| (n as f64, values))
        .collect()
}

/// The mean of the values of each n.
pub(crate) fn means(data: &[(f64, f64)]) -> Vec<(f64, f64)> {
    groups(data)
        .into_iter()
        .map(|(n, values)| (n, mean(&values)))
        .collect()
}

/// The mean at the largest n.
pub(crate) fn at_largest(data: &[(f64, f64)]) -> Option<(f64, f64)> {
    means(data).last().copied()
}

/// The data of the two upper decades of n: where an asymptotic statement is to be looked for.
pub(crate) fn upper_decades(data: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let largest = data.iter().map(|(n, _)| *n).fold(0.0, f64::max);
    data.iter()
        .copied()
        .filter(|(n, _)| 100.5 * n >= largest)
        .collect()
}

/// "n from … to …", for the sizes in `data`.
pub(crate) fn range(data: &[(f64, f64)]) -> String {
    let least = data.iter().map(|(n, _)| *n).fold(f64::INFINITY, f64::min);
    let most = data.iter().map(|(n, _)| *n).fold(0.0, f64::max);
    format!("n from {least} to {most}")
}

/// The exponent of growth over the two upper decades, with its interval at 90 %.
#[derive(Clone, Debug)]
pub(crate) struct Exponent {
    pub(crate) value: f64,
    pub(crate) interval: (f64, f64),
    /// The sizes it was fitted on.
    pub(crate) range: String,
}

impl std::fmt::Display for Exponent {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (low, high) = self.interval;
        write!(
            f,
            "{:.3}, 90 % [{low:.3}, {high:.3}], {}",
            self.value, self.range
        )
    }
}

/// The exponent of `data` in n; `None` for less than two sizes or three runs.
pub(crate) fn exponent(data: &[(f64, f64)]) -> Option<Exponent> {
    let data = upper_decades(data);
    let line: Line = fit_log_log(&data)?;
    Some(Exponent {
        value: line.slope,
        interval: line.slope_interval(0.90),
        range: range(&data),
    })
}

/// The cells that were timed, in the order of the records.
pub(crate) fn timed_cells(records: &Records) -> Vec<(String, usize)> {
    let mut cells: Vec<(String, usize)> = Vec::new();
    for row in &records.times {
        let cell = (row.distribution.clone(), row.n);
        if !cells.contains(&cell) {
            cells.push(cell);
        }
    }
    cells
}

/// The methods timed in `cell`, the second entry of the base left out.
pub(crate) fn timed_methods(records: &Records, cell: Cell<'_>) -> Vec<String> {
    let rows = records
        .times
        .iter()
        .filter(|row| (row.distribution.as_str(), row.n) == cell);
    let mut methods: Vec<String> = rows.map(|row| row.method.clone()).collect();
    methods.sort();
    methods.dedup();
    methods.retain(|method| method != TWIN);
    methods
}

/// The mean numbers of vertices and facets of the certified hulls in `cell`.
pub(crate) fn hull_sizes(records: &Records, stage: &str, cell: Cell<'_>) -> Option<(f64, f64)> {
    let rows: Vec<_> = records
        .sets
        .iter()
        .filter(|row| row.stage == stage && (row.distribution.as_str(), row.n) == cell)
        .collect();
    let of = |value: fn(&crate::reproduce::space::rows::SetRow) -> usize| {
        mean(&rows.iter().map(|row| value(row) as f64).collect::<Vec<_>>())
    };
    (!rows.is_empty()).then(|| (of(|row| row.vertices), of(|row| row.facets)))
}
