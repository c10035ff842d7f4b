//! What the whole call asks, counted in runs of their own (D-7).

use super::METHOD;
use crate::reproduce::day::definition::{Cells, Definition};
use crate::reproduce::day::records::Records;
use crate::reproduce::day::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::certify::certify;
use crate::reproduce::space::count::count;
use anyhow::Result;

/// The name of this experiment in the records.
const STAGE: &str = "counts";

/// Counts every set of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let progress = Progress::start(STAGE, definition.counts.len());
    for block in &definition.counts {
        let counted = parallel::map(&block.sets(), |(distribution, n, replicate)| {
            let set = sets::generate(definition.seed, distribution, *n, *replicate)?;
            let certified = certify(STAGE, &set, &[METHOD.to_owned()])?;
            let row = match certified.hull {
                Some(_) => Some(count(STAGE, &set, METHOD)?),
                None => None,
            };
            Ok((certified, row))
        })?;
        for (certified, row) in counted {
            records.sets.push(certified.set);
            records.failures.extend(certified.failures);
            records.counts.extend(row);
        }
        let Cells { distributions, .. } = block;
        progress.finished(&format!("{distributions:?}"));
    }
    Ok(())
}
