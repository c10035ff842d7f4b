//! The questions asked by each method, counted in runs of their own (Table 2, GS-1, GS-3, GS-4).

use super::certify::{Certified, certify};
use super::hull_method;
use crate::reproduce::green_silverman::definition::Definition;
use crate::reproduce::green_silverman::records::{CountRow, Records};
use crate::reproduce::green_silverman::sets::PointSet;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use anyhow::Result;
use geometry_core::{Boundary, Counted, Exact, Points, Tally};

/// Counts every cell of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let cells = definition.counted_cells();
    let progress = Progress::start("counts", cells.len());
    for ((distribution, n), methods) in cells {
        let replicates: Vec<u64> = (0..methods.values().copied().max().unwrap_or(0)).collect();
        let counted = parallel::map(&replicates, |&replicate| {
            let wanted: Vec<String> = methods
                .iter()
                .filter(|(_, replicates)| replicate < **replicates)
                .map(|(method, _)| method.clone())
                .collect();
            let set = PointSet::generate(definition.seed, &distribution, n, replicate)?;
            let certified = certify("counts", &set, &wanted)?;
            let rows: Result<Vec<CountRow>> = certified
                .methods
                .iter()
                .map(|method| count(&set, method))
                .collect();
            Ok((certified, rows?))
        })?;
        for (Certified { set, failures, .. }, rows) in counted {
            records.sets.push(set);
            records.failures.extend(failures);
            records.counts.extend(rows);
        }
        progress.finished(&format!("{distribution} {n}"));
    }
    Ok(())
}

/// One counted run of one method.
fn count(set: &PointSet, method: &str) -> Result<CountRow> {
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    (hull_method(method)?.tallied)(
        Points::new(&set.points)?,
        Boundary::All,
        &kernel,
        &mut tally,
    )?;
    let asked = kernel.counts();
    let beyond = |stages: geometry_core::StageCounts| stages.adaptive + stages.integer;
    Ok(CountRow {
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        method: method.to_owned(),
        orientations: asked.orientations.total(),
        distances: asked.distances.total(),
        along: asked.along,
        lexicographic: asked.lexicographic,
        angles: asked.angles,
        beyond_filter: beyond(asked.orientations) + beyond(asked.distances),
        visits: tally.visits,
        storage: tally.storage,
    })
}
