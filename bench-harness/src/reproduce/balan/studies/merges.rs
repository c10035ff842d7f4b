//! Comparisons of candidates in the top merge of divide and conquer and in all merges (B-1).
//!
//! Where every edge at hand is looked at once a step, comparisons are the edges that a sort in linear time would handle;
//! where they are sorted, they are those of the sort.

use crate::reproduce::balan::definition::Studies;
use crate::reproduce::balan::records::{MergeRow, Records};
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::{Certified3, certify};
use anyhow::Result;
use divide_and_conquer::preparata_hong_3d::{Variant, merges};
use geometry_core::{Exact, Points};

/// The name of this study in the records.
const STAGE: &str = "merges";

/// The method that looks at every edge at hand once a step.
pub(crate) const LOOKING: &str = "preparata-hong-rescan";

/// The method that sorts them.
pub(crate) const SORTING: &str = "preparata-hong-balan";

/// Runs both methods on every set of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let progress = Progress::start(STAGE, studies.merges.len());
    for block in &studies.merges {
        let sets = block.sets();
        let merged = parallel::map(&sets, |(distribution, n, replicate)| {
            let set = PointSet3::generate(studies.seed, distribution, *n, *replicate)?;
            let methods = [LOOKING, SORTING].map(str::to_owned);
            let certified = certify(STAGE, &set, &methods)?;
            let rows: Result<Vec<MergeRow>> = certified
                .methods
                .iter()
                .map(|method| merges_of(&set, method))
                .collect();
            Ok((certified, rows?))
        })?;
        for (Certified3 { set, failures, .. }, rows) in merged {
            records.sets.push(set);
            records.failures.extend(failures);
            records.own.merges.extend(rows);
        }
        progress.finished(&format!("{:?} {:?}", block.distributions, block.n));
    }
    Ok(())
}

/// The merges of one certified method.
fn merges_of(set: &PointSet3, method: &str) -> Result<MergeRow> {
    let variant = if method == SORTING {
        Variant::Sorted
    } else {
        Variant::Rescanned
    };
    let merges = merges(Points::new(&set.points)?, variant, &Exact)?;
    let top = merges.last().copied().unwrap_or_default();
    Ok(MergeRow {
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        method: method.to_owned(),
        top_facets: u64::from(top.facets),
        top_candidates: top.candidates,
        all_candidates: merges.iter().map(|merge| merge.candidates).sum(),
    })
}
