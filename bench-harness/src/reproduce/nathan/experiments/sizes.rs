//! The number of vertices over many replicates of a cell. Each hull is certified.

use crate::reproduce::nathan::definition::Definition;
use crate::reproduce::nathan::records::{Records, SizeRow};
use crate::reproduce::nathan::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::sets::digest;
use anyhow::Result;
use std::collections::BTreeMap;

/// Measures every cell of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let cells = definition
        .sizes
        .iter()
        .map(|block| block.distributions.len())
        .sum();
    let progress = Progress::start("sizes", cells);
    for block in &definition.sizes {
        for distribution in &block.distributions {
            let replicates: Vec<u64> = (0..block.replicates).collect();
            let measured = parallel::map(&replicates, |&replicate| {
                let set = sets::generate(definition.seed, distribution, block.n, replicate)?;
                Ok((set.fingerprint(), super::proved("sizes", &set)?))
            })?;
            let digest = digest(measured.iter().map(|(fingerprint, _)| fingerprint));
            let mut histogram: BTreeMap<usize, u64> = BTreeMap::new();
            for (_, hull) in measured {
                match hull {
                    Ok(hull) => *histogram.entry(hull.len()).or_default() += 1,
                    Err(failures) => records.failures.extend(failures),
                }
            }
            let row = |(vertices, replicates)| SizeRow {
                distribution: distribution.clone(),
                n: block.n,
                vertices,
                replicates,
                digest: digest.clone(),
            };
            records.sizes.extend(histogram.into_iter().map(row));
            progress.finished(&format!("{distribution} {}", block.n));
        }
    }
    Ok(())
}
