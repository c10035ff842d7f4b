//! The halves conquered on all processors, against one after the other: hulls and questions (D-11).

use super::{METHOD, PARALLEL};
use crate::reproduce::day::definition::Studies;
use crate::reproduce::day::records::{ParallelRow, Records};
use crate::reproduce::day::sets;
use crate::reproduce::day::watch::Watched;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::certify::certify;
use anyhow::Result;
use divide_and_conquer::{preparata_hong_3d, preparata_hong_parallel};
use geometry_core::{Exact, Points, Silent};

/// The name of this study in the records.
const STAGE: &str = "side by side";

/// Runs every set of the study both ways.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let progress = Progress::start(STAGE, studies.parallel.len());
    for block in &studies.parallel {
        for (distribution, n, replicate) in block.sets() {
            let set = sets::generate(studies.seed, &distribution, n, replicate)?;
            let certified = certify(STAGE, &set, &[METHOD, PARALLEL].map(str::to_owned))?;
            let points = Points::new(&set.points)?;
            let (one, all) = (Watched::new(Exact), Watched::new(Exact));
            let sequential = preparata_hong_3d(points, &one, &mut Silent)?;
            let parallel = preparata_hong_parallel(points, &all)?;
            let proved = certified.hull.as_ref();
            records.own.parallel.push(ParallelRow {
                distribution,
                n,
                replicate,
                same_hull: proved == Some(&sequential) && proved == Some(&parallel),
                sequential: one.questions(),
                parallel: all.questions(),
            });
            records.sets.push(certified.set);
            records.failures.extend(certified.failures);
        }
        progress.finished(&format!("{:?} {:?}", block.distributions, block.n));
    }
    Ok(())
}
