//! What the whole call asks on sets that are in no catalogue (D-7). Those of the catalogue are `day-counts`.

use super::METHOD;
use crate::reproduce::day::definition::Studies;
use crate::reproduce::day::records::Records;
use crate::reproduce::day::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::certify::certify;
use crate::reproduce::space::count::row;
use crate::reproduce::space::spatial_method;
use anyhow::Result;
use geometry_core::{Counted, Exact, Points, Tally};

/// The name of this study in the records: these rows stand beside the others.
const STAGE: &str = "counts";

/// Counts every set.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let progress = Progress::start("turned", studies.turned.len());
    for block in &studies.turned {
        let counted = parallel::map(&block.sets(), |(distribution, n, replicate)| {
            let set = sets::generate(studies.seed, distribution, *n, *replicate)?;
            let certified = certify(STAGE, &set, &[METHOD.to_owned()])?;
            let (kernel, mut tally) = (Counted::new(Exact), Tally::default());
            let points = Points::new(&set.points)?;
            let hull = (spatial_method(METHOD)?.tallied)(points, &kernel, &mut tally)?;
            let row = row(STAGE, &set, METHOD, &hull, &kernel.counts(), &tally);
            Ok((certified, row))
        })?;
        for (certified, row) in counted {
            records.sets.push(certified.set);
            records.counts.extend(certified.hull.map(|_| row));
            records.failures.extend(certified.failures);
        }
        progress.finished(&format!("{:?}", block.distributions));
    }
    Ok(())
}
