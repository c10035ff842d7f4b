//! The row of a counted run in space, however it was made.

use crate::counting::counters;
use crate::reproduce::rows::{CountRow, Dimension};
use crate::reproduce::sets::PointSet3;
use geometry_core::{Hull3, QuestionCounts, Tally};

/// What `method` asked and did on `set`. Only certified methods are to be counted.
pub(crate) fn row(
    stage: &str,
    set: &PointSet3,
    method: &str,
    hull: &Hull3,
    asked: &QuestionCounts,
    tally: &Tally,
) -> CountRow {
    CountRow {
        stage: stage.to_owned(),
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        method: method.to_owned(),
        vertices: hull.len(),
        ..CountRow::of(Dimension::Space, &counters(asked, tally))
    }
}
