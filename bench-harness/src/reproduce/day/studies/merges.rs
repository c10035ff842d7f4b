//! What every merge asks and keeps, by each rule of search (D-3, D-4, D-5).

use crate::reproduce::data::product;
use crate::reproduce::day::definition::Studies;
use crate::reproduce::day::records::{MergeRow, Records};
use crate::reproduce::day::{sets, variants};
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::{Certified3, certify};
use anyhow::Result;
use divide_and_conquer::preparata_hong_3d::merges;
use geometry_core::{Exact, Points};

/// The name of this study in the records.
const STAGE: &str = "merges";

/// Merges every set of the study by every rule.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let progress = Progress::start(STAGE, studies.merges.len());
    for block in &studies.merges {
        let mut all = Vec::new();
        for (distribution, n) in product(&block.distributions, &block.n) {
            all.extend((0..block.replicates).map(|replicate| (distribution.clone(), n, replicate)));
        }
        // The longest first, so that all cores end together.
        all.sort_by_key(|(_, n, _)| std::cmp::Reverse(*n));
        let merged = parallel::map(&all, |(distribution, n, replicate)| {
            let set = sets::generate(studies.seed, distribution, *n, *replicate)?;
            let mut slugs = Vec::new();
            for name in &block.variants {
                slugs.push(variants::find(name)?.1.to_owned());
            }
            let certified = certify(STAGE, &set, &slugs)?;
            let mut rows = Vec::new();
            for (name, slug) in block.variants.iter().zip(&slugs) {
                if certified.methods.contains(slug) {
                    rows.push(row(&set, name)?);
                }
            }
            Ok((certified, rows))
        })?;
        for (Certified3 { set, failures, .. }, rows) in merged {
            records.sets.push(set);
            records.failures.extend(failures);
            records.own.merges.extend(rows);
        }
        progress.finished(&format!("{:?} {:?}", block.distributions, block.variants));
    }
    let key = |row: &MergeRow| {
        (
            row.distribution.clone(),
            row.variant.clone(),
            row.n,
            row.replicate,
        )
    };
    records.own.merges.sort_by_key(key);
    Ok(())
}

/// The merges of one certified rule.
fn row(set: &PointSet3, variant: &str) -> Result<MergeRow> {
    let merges = merges(
        Points::new(&set.points)?,
        variants::find(variant)?.0,
        &Exact,
    )?;
    let top = merges.last().copied().unwrap_or_default();
    let most = merges.iter().map(|merge| merge.edges_live).max();
    Ok(MergeRow {
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        variant: variant.to_owned(),
        top_candidates: top.candidates,
        top_facets: u64::from(top.facets),
        vertices: u64::from(top.vertices_after),
        candidates: merges.iter().map(|merge| merge.candidates).sum(),
        reexamined: merges.iter().map(|merge| merge.reexamined).sum(),
        merges: merges.len() as u64,
        edges_made: merges.iter().map(|merge| u64::from(merge.edges_made)).sum(),
        edges_most: u64::from(most.unwrap_or(0)),
        edges_last: u64::from(top.edges_live),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_add_up() {
        let set = sets::generate(1, "ball", 64, 0).expect("a set");
        let resumed = row(&set, "resumed").expect("merges");
        assert_eq!((resumed.merges, resumed.reexamined), (63, 0));
        assert_eq!(resumed.edges_last, 3 * resumed.vertices - 6);
        assert!(
            resumed.edges_most >= resumed.edges_last && resumed.edges_made > resumed.edges_most
        );
        let rescanned = row(&set, "rescanned").expect("merges");
        assert!(rescanned.candidates > resumed.candidates && rescanned.reexamined > 0);
        assert_eq!(rescanned.vertices, resumed.vertices);
    }
}
