//! What each method asks and makes, counted in runs of their own (the table of counts, B-1, B-3, B-4, B-6).

use crate::reproduce::balan::definition::Definition;
use crate::reproduce::balan::records::Records;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::certify::{Certified3, certify};
use crate::reproduce::space::count::count;
use crate::reproduce::space::rows::CountRow;
use crate::reproduce::space::sets::PointSet3;
use anyhow::Result;

/// The name of this experiment in the records.
pub(crate) const STAGE: &str = "counts";

/// Counts every cell of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let cells = definition.counted_cells();
    let progress = Progress::start(STAGE, cells.len());
    for ((distribution, n), methods) in cells {
        let replicates: Vec<u64> = (0..methods.values().copied().max().unwrap_or(0)).collect();
        let counted = parallel::map(&replicates, |&replicate| {
            let wanted: Vec<String> = methods
                .iter()
                .filter(|(_, replicates)| replicate < **replicates)
                .map(|(method, _)| method.clone())
                .collect();
            let set = PointSet3::generate(definition.seed, &distribution, n, replicate)?;
            let certified = certify(STAGE, &set, &wanted)?;
            let rows: Result<Vec<CountRow>> = certified
                .methods
                .iter()
                .map(|method| count(STAGE, &set, method))
                .collect();
            Ok((certified, rows?))
        })?;
        for (Certified3 { set, failures, .. }, rows) in counted {
            records.sets.push(set);
            records.failures.extend(failures);
            records.counts.extend(rows);
        }
        progress.finished(&format!("{distribution} {n}"));
    }
    Ok(())
}
