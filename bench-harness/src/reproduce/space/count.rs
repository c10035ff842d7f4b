//! A registered method, run once more with every question counted.

use super::rows::CountRow;
use super::sets::PointSet3;
use super::spatial_method;
use anyhow::Result;
use geometry_core::{Counted, Exact, Hull3, Points, Tally};

/// One counted run of `method`, the whole call with its set-up. Only certified methods are to be counted.
pub(crate) fn count(stage: &str, set: &PointSet3, method: &str) -> Result<CountRow> {
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let hull = (spatial_method(method)?.tallied)(Points::new(&set.points)?, &kernel, &mut tally)?;
    Ok(row(stage, set, method, &hull, &kernel, &tally))
}

/// The row of a counted run, however it was made.
pub(crate) fn row<K>(
    stage: &str,
    set: &PointSet3,
    method: &str,
    hull: &Hull3,
    kernel: &Counted<K>,
    tally: &Tally,
) -> CountRow {
    let asked = kernel.counts();
    let beyond = |stages: geometry_core::StageCounts| stages.adaptive + stages.integer;
    CountRow {
        stage: stage.to_owned(),
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        method: method.to_owned(),
        vertices: hull.len(),
        orientations: asked.orientations_in_space.total(),
        heights: asked.heights.total(),
        shadows: asked.shadows.total(),
        lexicographic: asked.lexicographic,
        beyond_filter: beyond(asked.orientations_in_space) + beyond(asked.heights),
        visits: tally.visits,
        facets: tally.facets,
        drops: tally.drops,
        candidates: tally.candidates,
        bridges: tally.bridges,
        merges: tally.merges,
        inserts: tally.inserts,
        storage: tally.storage,
    }
}
