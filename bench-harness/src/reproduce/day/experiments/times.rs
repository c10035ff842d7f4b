//! Times of the whole call, by one processor and by all, interleaved and warm (D-7, D-11).

use super::METHOD;
use crate::reproduce::data::product;
use crate::reproduce::day::definition::{Definition, Times};
use crate::reproduce::day::records::Records;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::times::{Race, race};
use anyhow::Result;

/// The name of this experiment in the records.
const STAGE: &str = "times";

/// The same method with the halves conquered side by side.
pub(crate) const PARALLEL: &str = "preparata-hong-parallel";

/// Times every cell of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let cells = |block: &Times| product(&block.distributions, &block.n);
    let all = definition.times.iter().map(|block| cells(block).len());
    let progress = Progress::start(STAGE, all.sum());
    let methods = [METHOD, PARALLEL].map(str::to_owned);
    for block in &definition.times {
        let rules = Race {
            stage: STAGE,
            methods: &methods,
            base: METHOD,
            realisations: block.realisations,
            points_a_batch: block.points_a_batch,
            rounds: block.rounds,
        };
        for (distribution, n) in cells(block) {
            let timed = race(definition.seed, &distribution, n, &rules)?;
            records.sets.extend(timed.sets);
            records.failures.extend(timed.failures);
            records.times.extend(timed.times);
            progress.finished(&format!("{distribution} {n}"));
        }
    }
    Ok(())
}
