//! Degenerate sets: Day's cotangents in two formats, and exact orientations with a symbolic perturbation (D-8).
//!
//! The exact method must give the certified hull, and so must the other variants and two methods of other kinds. What the
//! perturbation costs is paid where an answer vanishes, so where none does it costs nothing.

use super::{METHOD, proved_in};
use crate::reproduce::day::definition::Studies;
use crate::reproduce::day::formats::{self, word};
use crate::reproduce::day::records::{BatteryRow, Records};
use crate::reproduce::day::sets;
use crate::reproduce::day::watch::Watched;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::{FailureRow, SetRow};
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::certify;
use anyhow::Result;
use divide_and_conquer::preparata_hong_3d;
use geometry_core::dimension::AffineBasis;
use geometry_core::{Exact, Points, Silent};

/// The name of this study in the records.
const STAGE: &str = "battery";

/// What must agree on every set.
const METHODS: [&str; 6] = [
    METHOD,
    "preparata-hong-rescan",
    "preparata-hong-balan",
    "preparata-hong-parallel",
    "quickhull-3d",
    "pivot-wrap",
];

/// How exact answers are called among the formats.
pub(crate) const EXACT: &str = "exact";

/// Runs the battery of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let battery = &studies.degenerate;
    let general = battery.general.iter();
    let general = general.map(|cell| (cell.distribution.as_str(), cell.n, ""));
    let degenerate = battery.sets.iter();
    let degenerate =
        degenerate.map(|kind| (kind.distribution.as_str(), kind.n, kind.what.as_str()));
    let cells: Vec<_> = general.chain(degenerate).collect();
    let progress = Progress::start(STAGE, cells.len());
    for (distribution, n, what) in cells {
        let numbers: Vec<u64> = (0..battery.replicates).collect();
        let tried = parallel::map(&numbers, |&replicate| {
            let set = sets::generate(studies.seed, distribution, n, replicate)?;
            all_ways(studies, &set, what)
        })?;
        for (rows, set, failures) in tried {
            records.own.battery.extend(rows);
            records.sets.push(set);
            records.failures.extend(failures);
        }
        progress.finished(distribution);
    }
    Ok(())
}

type Tried = (Vec<BatteryRow>, SetRow, Vec<FailureRow>);

/// One set in every format and exactly.
fn all_ways(studies: &Studies, set: &PointSet3, what: &str) -> Result<Tried> {
    let row = BatteryRow {
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        what: what.to_owned(),
        ..BatteryRow::default()
    };
    let certified = certify(STAGE, set, &METHODS.map(str::to_owned))?;
    let all_agree = certified.methods.len() == METHODS.len();
    let points = Points::new(&set.points)?;
    let kernel = Watched::new(Exact);
    preparata_hong_3d(points, &kernel, &mut Silent)?;
    // To find the dimension, points are tried against themselves, unperturbed.
    let basis = Watched::new(Exact);
    let _ = AffineBasis::of(points, &basis);
    let mut rows = vec![BatteryRow {
        format: EXACT.to_owned(),
        outcome: if all_agree { "right" } else { "wrong hull" }.to_owned(),
        questions: kernel.questions() - basis.questions(),
        vanished: kernel.vanished() - basis.vanished(),
        ..row.clone()
    }];
    let mut failures = certified.failures;
    for format in &studies.degenerate.formats {
        let machine = formats::find(&format.name)?;
        match proved_in(STAGE, set.clone(), &machine)? {
            (rounded, Ok(hull)) => rows.push(BatteryRow {
                format: format.name.clone(),
                power: Some(format.power),
                outcome: word(machine.end(&rounded.points, &hull, format.power)).to_owned(),
                ..row.clone()
            }),
            (_, Err(more)) => failures.extend(more),
        }
    }
    Ok((rows, certified.set, failures))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::definition::Extent;
    use crate::reproduce::data::studies;
    use crate::reproduce::day::SLUG;

    #[test]
    fn nothing_vanishes_in_general_position_and_much_on_a_lattice() {
        let studies: Studies = studies(SLUG, Extent::Quick).expect("valid");
        let vanished = |distribution| {
            let set = sets::generate(1, distribution, 64, 0).expect("a set");
            let (rows, _, failures) = all_ways(&studies, &set, "").expect("hulls");
            assert!(failures.is_empty());
            assert_eq!(rows.len(), 1 + studies.degenerate.formats.len());
            assert_eq!(
                (rows[0].format.as_str(), rows[0].outcome.as_str()),
                (EXACT, "right")
            );
            rows[0].vanished
        };
        assert_eq!(vanished("cube"), 0);
        assert!(vanished("cubic-lattice") > 100);
    }
}
