//! The number of vertices over many replicates of a cell (Table 2, GS-2).

use super::hull_method;
use crate::reproduce::data::product;
use crate::reproduce::green_silverman::definition::Definition;
use crate::reproduce::green_silverman::records::{FailureRow, Records, SizeRow};
use crate::reproduce::green_silverman::sets::PointSet;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use anyhow::Result;
use geometry_core::{Boundary, Points};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// Measures every cell of the definition. Each hull is certified.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let blocks = definition.sizes.iter();
    let cells: Vec<(String, usize, u64)> = blocks
        .flat_map(|block| {
            let cells = product(&block.distributions, &block.n).into_iter();
            cells.map(|(distribution, n)| (distribution, n, block.replicates))
        })
        .collect();
    let progress = Progress::start("sizes", cells.len());
    for (distribution, n, replicates) in cells {
        let (rows, failures) = cell(definition.seed, &distribution, n, replicates)?;
        records.sizes.extend(rows);
        records.failures.extend(failures);
        progress.finished(&format!("{distribution} {n}"));
    }
    Ok(())
}

fn cell(
    seed: u64,
    distribution: &str,
    n: usize,
    replicates: u64,
) -> Result<(Vec<SizeRow>, Vec<FailureRow>)> {
    let gs = hull_method("gs")?;
    let numbers: Vec<u64> = (0..replicates).collect();
    let measured = parallel::map(&numbers, |&replicate| {
        let set = PointSet::generate(seed, distribution, n, replicate)?;
        let hull = (gs.exact)(Points::new(&set.points)?, Boundary::All)?;
        let proof = hull_verify::check::hull2(&set.points, Boundary::All, &hull);
        let vertices = proof.map(|certificate| certificate.h);
        Ok((
            set.fingerprint(),
            vertices.map_err(|findings| findings.len()),
        ))
    })?;
    let mut histogram: BTreeMap<usize, u64> = BTreeMap::new();
    let mut failures = Vec::new();
    let mut digest = Sha256::new();
    for (replicate, (fingerprint, vertices)) in (0..).zip(&measured) {
        digest.update(fingerprint);
        match vertices {
            Ok(vertices) => *histogram.entry(*vertices).or_default() += 1,
            Err(findings) => failures.push(FailureRow {
                stage: "sizes".to_owned(),
                distribution: distribution.to_owned(),
                n,
                replicate,
                method: "gs".to_owned(),
                what: format!("{findings} findings"),
            }),
        }
    }
    let digest: String = digest
        .finalize()
        .iter()
        .take(8)
        .map(|byte| format!("{byte:02x}"))
        .collect();
    let row = |(vertices, replicates)| SizeRow {
        distribution: distribution.to_owned(),
        n,
        vertices,
        replicates,
        digest: digest.clone(),
    };
    Ok((histogram.into_iter().map(row).collect(), failures))
}
