//! Times, interleaved and warm, of certified results only: the table that the paper does not print (B-7).

use crate::reproduce::balan::definition::{Definition, Times};
use crate::reproduce::balan::records::Records;
use crate::reproduce::data::product;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::times::{Race, race};
use anyhow::Result;

/// The method to which others are compared.
pub(crate) const BASE: &str = "quickhull-3d";

/// The name under which it takes part a second time, to show the noise of a program against itself.
pub(crate) const TWIN: &str = "quickhull-3d-twin";

/// The name of this experiment in the records.
pub(crate) const STAGE: &str = "times";

/// Times every cell of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let cells = |block: &Times| product(&block.distributions, &block.n);
    let all = definition
        .times
        .iter()
        .map(|block| cells(block).len())
        .sum();
    let progress = Progress::start(STAGE, all);
    for block in &definition.times {
        let rules = Race {
            stage: STAGE,
            methods: &block.methods,
            base: BASE,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::space::times::twin;

    #[test]
    fn the_twin_is_that_of_the_base() {
        assert_eq!(twin(BASE), TWIN);
    }
}
