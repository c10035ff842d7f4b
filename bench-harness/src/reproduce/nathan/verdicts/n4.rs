//! N-4: the point with the largest or the smallest squared distance from the origin is on the hull.

use super::{Part, Verdict, always, verdict};
use crate::reproduce::nathan::records::{Records, StartRow};
use crate::stats::wilson;

pub(super) fn judge(records: &Records) -> Verdict {
    let parts = ["furthest", "nearest"].map(|start| part(records, start));
    let mut notes = Vec::new();
    for row in records
        .own
        .starts
        .iter()
        .filter(|row| row.start == "nearest" && row.off_hull > 0)
    {
        notes.push(format!(
            "nearest, {}, offset {:e}: {}",
            row.distribution,
            row.offset,
            share(row)
        ));
    }
    let control = total(records, "lexicographic");
    if control.1 > 0 {
        notes.push(format!(
            "the lexicographically smallest point, our choice, is off the hull in {} of {} sets",
            control.0, control.1
        ));
    }
    verdict("N-4", parts.to_vec(), notes)
}

/// Sets whose first point is off the hull, and sets.
fn total(records: &Records, start: &str) -> (usize, usize) {
    let rows = records.own.starts.iter().filter(|row| row.start == start);
    rows.fold((0, 0), |(off, sets), row| {
        (off + row.off_hull, sets + row.sets)
    })
}

fn part(records: &Records, start: &str) -> Part {
    let (off, sets) = total(records, start);
    Part::new(
        format!("the {start} point is on the hull of the flattened points, wherever the origin is"),
        always(off, sets),
        format!("off the hull in {off} of {sets} sets"),
    )
}

/// The share of sets whose first point is off the hull, with its interval.
pub(crate) fn share(row: &StartRow) -> String {
    let (low, high) = wilson::interval(row.off_hull, row.sets);
    format!(
        "off the hull in {} of {} sets, {:.1} % [{:.1}, {:.1}]",
        row.off_hull,
        row.sets,
        100.0 * row.off_hull as f64 / row.sets as f64,
        100.0 * low,
        100.0 * high
    )
}

#[cfg(test)]
mod tests {
    use super::super::Outcome;
    use super::*;
    use crate::reproduce::nathan::records::Studied;

    fn judged(furthest: usize, nearest: usize, sets: usize) -> Verdict {
        let row = |start: &str, off_hull| StartRow {
            start: start.to_owned(),
            sets,
            off_hull,
            ..StartRow::default()
        };
        judge(&Records::from(Studied {
            starts: vec![row("furthest", furthest), row("nearest", nearest)],
            ..Studied::default()
        }))
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(judged(0, 0, 200).outcome, Outcome::Confirmed);
        assert_eq!(judged(0, 150, 200).outcome, Outcome::Refuted);
        assert_eq!(judged(0, 150, 200).parts[0].outcome, Outcome::Confirmed);
        assert_eq!(judged(0, 0, 20).outcome, Outcome::NotDistinguishable);
    }
}
