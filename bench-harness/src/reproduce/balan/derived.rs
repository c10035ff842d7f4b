//! What tables, figures and verdicts compute from the records, cell by cell.

use super::experiments::times::TWIN;
use super::records::Records;
use crate::reproduce::space::rows::CountRow;
use crate::stats::summary::mean;

/// A distribution and a size.
pub(crate) type Cell<'a> = (&'a str, usize);

/// The triangles of the surface at the end, coplanar ones apart.
pub(crate) fn triangles(row: &CountRow) -> u64 {
    row.facets - row.drops
}

/// Orientations asked to tell on which side of a facet's plane a point lies.
///
/// Merging coplanar triangles asks one for each edge, three for two triangles. The two insertions ask one for their first
/// tetrahedron, if the first four points of the order span space; the few that the quickhulls ask for theirs are
/// left in.
pub(crate) fn plane_tests(row: &CountRow) -> f64 {
    let start = u64::from(row.method.starts_with("incremental"));
    row.orientations as f64 - (start + 3 * triangles(row) / 2) as f64
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
