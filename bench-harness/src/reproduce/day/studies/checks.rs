//! The paper's third stage of testing, given hulls that are known to be right or wrong (D-10).
//!
//! The hulls are those that Day's cotangents give in some format at some eps2; which of them are right is known from a
//! certificate. Each is checked in that same format, as the paper does, and by exact orientations.

use super::proved_in;
use crate::reproduce::day::check::accepts_exactly;
use crate::reproduce::day::definition::{AtPower, Checks, Studies};
use crate::reproduce::day::formats::{self, Machine, is_right};
use crate::reproduce::day::records::{CheckRow, Records};
use crate::reproduce::day::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::FailureRow;
use crate::reproduce::sets::{PointSet3, digest};
use anyhow::Result;
use geometry_core::{Hull3, Points};

/// The name of this study in the records.
const STAGE: &str = "checks";

/// How exact answers are called among the formats.
pub(crate) const EXACT: &str = "exact";

/// Checks the hulls of every format of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let Checks {
        distribution,
        n,
        formats,
        sets,
    } = &studies.checks;
    let progress = Progress::start(STAGE, formats.len());
    for AtPower { name, power } in formats {
        let machine = formats::find(name)?;
        let numbers: Vec<u64> = (0..*sets).collect();
        let checked = parallel::map(&numbers, |&replicate| {
            let set = sets::generate(studies.seed, distribution, *n, replicate)?;
            let (set, hull) = proved_in(STAGE, set, &machine)?;
            let checked = hull.map(|hull| check(&set, &hull, &machine, *power));
            Ok((set.fingerprint(), checked))
        })?;
        let digest = digest(checked.iter().map(|(fingerprint, _)| fingerprint));
        for (place, checked_in) in [name, EXACT].into_iter().enumerate() {
            let mut row = CheckRow {
                distribution: distribution.clone(),
                n: *n,
                made_in: name.clone(),
                power: *power,
                checked_in: checked_in.to_owned(),
                digest: digest.clone(),
                ..CheckRow::default()
            };
            for checked in checked
                .iter()
                .filter_map(|(_, checked)| checked.as_ref().ok())
            {
                checked.iter().for_each(|hull| hull.add_to(&mut row, place));
            }
            records.own.checks.push(row);
        }
        let failures = checked.into_iter().filter_map(|(_, checked)| checked.err());
        records
            .failures
            .extend(failures.flatten().collect::<Vec<FailureRow>>());
        progress.finished(&format!("{name}, eps2 = 1e{power}"));
    }
    Ok(())
}

/// What is known and said of one hull; by place, in the format and exactly.
struct Checked {
    right: bool,
    accepted: [bool; 2],
    holed_accepted: [bool; 2],
}

impl Checked {
    fn add_to(&self, row: &mut CheckRow, place: usize) {
        let count = match (self.right, self.accepted[place]) {
            (true, true) => &mut row.right_accepted,
            (true, false) => &mut row.right_rejected,
            (false, true) => &mut row.wrong_accepted,
            (false, false) => &mut row.wrong_rejected,
        };
        *count += 1;
        row.holed_accepted += usize::from(self.right && self.holed_accepted[place]);
    }
}

/// The hull that `machine` makes, checked; `None` if it makes none, or one with a dummy for a corner.
fn check(set: &PointSet3, hull: &Hull3, machine: &Machine, power: i32) -> Option<Checked> {
    let points = Points::new(&set.points).ok()?;
    let faces = (machine.facets)(points, 10_f64.powi(power)).ok()?;
    let is_given = |id: &u32| (*id as usize) < set.points.len();
    if !faces.iter().flatten().all(is_given) {
        return None;
    }
    let accepted = |faces: &[[u32; 3]]| {
        [
            (machine.accepts)(&set.points, faces),
            accepts_exactly(&set.points, faces),
        ]
    };
    Some(Checked {
        right: is_right(points, &faces, hull),
        accepted: accepted(&faces),
        holed_accepted: accepted(faces.get(1..).unwrap_or_default()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_checks_tell_right_from_wrong() {
        let machine = formats::find("f32").expect("a format");
        let mut seen = [0, 0];
        for replicate in 0..40 {
            let set = sets::generate(1, "cube", 40, replicate).expect("a set");
            let (set, hull) = proved_in(STAGE, set, &machine).expect("a method");
            let hull = hull.expect("certified");
            for power in [1, 4] {
                let Some(checked) = check(&set, &hull, &machine, power) else {
                    continue;
                };
                assert_eq!(checked.right, checked.accepted[1]);
                seen[usize::from(checked.right)] += 1;
            }
        }
        assert!(seen.iter().all(|&count| count > 0), "{seen:?}");
    }
}
