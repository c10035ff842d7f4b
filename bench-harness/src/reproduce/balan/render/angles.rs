//! The table of the rule for the direction of an angle.

use crate::reproduce::balan::records::{AngleRow, Records};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use crate::stats::wilson;
use anyhow::Result;
use std::collections::BTreeMap;

const INTRODUCTION: &str = "\
Section 3.1.2.2 of the paper chooses the next point of a merge by the largest angle between the last facet and the
facet of a candidate. The angle is the arc cosine of the normals, and if the cosine is negative it is taken from 360
degrees, \"in anticlockwise direction\". But a cosine holds no direction: with normals from corners in the same order, all
candidates lie on one side, and the rule turns the order of those at an obtuse angle round. Shares are of the steps of
right merges at which the rule goes to the right point; \"merges\" are those with every step right. Intervals are
Wilson's, 95 %; the steps of one merge are not independent, merges are.

";

/// Writes `angles.md` and `angles.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "distribution",
        "n",
        "merges",
        "steps",
        "direction right",
        "printed rule right",
        "merges right by it",
        "normals outwards",
        "no rule",
        "triple product",
        "exact",
    ]);
    let mut cells: BTreeMap<(&str, usize), Vec<&AngleRow>> = BTreeMap::new();
    for row in &records.own.angles {
        let cell = (row.distribution.as_str(), row.n);
        cells.entry(cell).or_default().push(row);
    }
    for ((distribution, n), rows) in cells {
        let sum = |of: fn(&AngleRow) -> u64| rows.iter().map(|row| of(row)).sum::<u64>();
        let steps = sum(|row| row.steps);
        let of_steps = |of: fn(&AngleRow) -> u64| share(sum(of), steps);
        sheet.push(vec![
            distribution.to_owned(),
            n.to_string(),
            rows.len().to_string(),
            steps.to_string(),
            share(sum(|row| row.directions_right), sum(|row| row.candidates)),
            of_steps(|row| row.printed),
            share(
                sum(|row| u64::from(row.printed == row.steps)),
                rows.len() as u64,
            ),
            of_steps(|row| row.printed_outward),
            of_steps(|row| row.unsigned),
            of_steps(|row| row.triple),
            of_steps(|row| row.exact),
        ]);
    }
    let body = INTRODUCTION.to_owned() + &sheet.markdown();
    folder.markdown("angles.md", "The sign of the cosine", &body)?;
    folder.csv("angles.csv", &sheet.csv())
}

/// "share [low, high]".
fn share(right: u64, all: u64) -> String {
    if all == 0 {
        return String::new();
    }
    let (low, high) = wilson::interval(right as usize, all as usize);
    format!("{:.3} [{low:.3}, {high:.3}]", right as f64 / all as f64)
}
