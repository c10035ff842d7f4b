//! What tables, figures and verdicts compute from the records, cell by cell.

use super::records::Records;
use crate::reproduce::rows::{CountRow, SetRow};
use crate::stats::summary::mean;

/// The method to which others are compared.
pub(crate) const BASE: &str = "quickhull-3d";

/// Its second entry, which shows the noise of a program against itself.
pub(crate) const TWIN: &str = "quickhull-3d@twin";

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

/// The mean numbers of vertices and facets of the certified hulls in `cell`.
pub(crate) fn hull_sizes(records: &Records, stage: &str, cell: Cell<'_>) -> Option<(f64, f64)> {
    let rows: Vec<_> = records
        .sets
        .iter()
        .filter(|row| row.stage == stage && (row.distribution.as_str(), row.n) == cell)
        .collect();
    let of = |value: fn(&SetRow) -> usize| {
        mean(&rows.iter().map(|row| value(row) as f64).collect::<Vec<_>>())
    };
    let facets = |row: &SetRow| row.facets.unwrap_or(0);
    (!rows.is_empty()).then(|| (of(|row| row.vertices), of(facets)))
}
