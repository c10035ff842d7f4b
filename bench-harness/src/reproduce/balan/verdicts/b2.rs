//! B-2: the sign of the cosine as the direction of an angle.

use super::{Outcome, Part, Verdict, all_of};
use crate::reproduce::balan::records::{AngleRow, Records};
use crate::stats::wilson;

pub(super) fn judge(records: &Records) -> Verdict {
    let rows = &records.own.angles;
    let parts = vec![
        control(rows),
        proportion(
            rows,
            "the sign of the cosine tells the direction of every candidate",
            |row| row.directions_right,
            |row| row.candidates,
        ),
        proportion(
            rows,
            "the candidate with the largest angle is the next point at every step",
            |row| row.printed,
            |row| row.steps,
        ),
        proportion(
            rows,
            "every step of a merge goes to the right point",
            |row| u64::from(row.printed == row.steps),
            |_| 1,
        ),
    ];
    let outcome = match parts[0].outcome {
        Outcome::Confirmed => all_of(parts.iter().map(|part| part.outcome)),
        // Without the control the others say nothing.
        _ => Outcome::NotTestable,
    };
    Verdict {
        id: "B-2",
        outcome,
        parts,
        notes: notes(rows),
    }
}

/// Whether exact orientations choose right everywhere: if not, the steps are not those of a merge.
fn control(rows: &[AngleRow]) -> Part {
    let what = "control: with exact orientations the next point is right at every step";
    let (right, all) = sums(rows, |row| row.exact, |row| row.steps);
    let outcome = match all {
        0 => Outcome::NotTestable,
        _ if right == all => Outcome::Confirmed,
        _ => Outcome::Refuted,
    };
    Part::new(what, outcome, share(right, all))
}

/// Something said of all, so refuted by one, and confirmed if it never fails.
fn proportion(
    rows: &[AngleRow],
    what: &str,
    right: fn(&AngleRow) -> u64,
    all: fn(&AngleRow) -> u64,
) -> Part {
    let (right, all) = sums(rows, right, all);
    let outcome = match all {
        0 => Outcome::NotTestable,
        _ if right == all => Outcome::Confirmed,
        _ => Outcome::Refuted,
    };
    Part::new(what, outcome, share(right, all))
}

fn sums(rows: &[AngleRow], right: fn(&AngleRow) -> u64, all: fn(&AngleRow) -> u64) -> (u64, u64) {
    (rows.iter().map(right).sum(), rows.iter().map(all).sum())
}

/// "k of n, share [Wilson's interval]".
fn share(right: u64, all: u64) -> String {
    if all == 0 {
        return "no merge was repeated".to_owned();
    }
    let (low, high) = wilson::interval(right as usize, all as usize);
    format!(
        "{right} of {all}, {:.4}, 95 % [{low:.4}, {high:.4}]",
        right as f64 / all as f64
    )
}

/// What other rules, and another reading, make of the same steps.
fn notes(rows: &[AngleRow]) -> Vec<String> {
    if rows.is_empty() {
        return Vec::new();
    }
    type Rule = (&'static str, fn(&AngleRow) -> u64);
    let rules: [Rule; 4] = [
        (
            "the rule with both normals outwards instead of from corners in the same order",
            |row| row.printed_outward,
        ),
        ("the angle from 0 to 180 degrees as it is, no rule", |row| {
            row.unsigned
        }),
        (
            "the sign of the triple product instead of the cosine's, rounded",
            |row| row.triple,
        ),
        (
            "steps with two obtuse candidates or more, where the rule turns their order round",
            |row| row.ambiguous,
        ),
    ];
    rules
        .into_iter()
        .map(|(what, count)| {
            let (right, all) = sums(rows, count, |row| row.steps);
            format!("{what}: {}", share(right, all))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::balan::records::Studied;

    fn verdict(directions_right: u64, printed: u64, exact: u64) -> Outcome {
        let records = Records::from(Studied {
            angles: vec![AngleRow {
                steps: 10,
                candidates: 100,
                directions_right,
                printed,
                exact,
                ..AngleRow::default()
            }],
            ..Studied::default()
        });
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(100, 10, 10), Outcome::Confirmed);
        assert_eq!(verdict(50, 10, 10), Outcome::Refuted);
        assert_eq!(verdict(100, 9, 10), Outcome::Refuted);
        assert_eq!(verdict(100, 10, 9), Outcome::NotTestable);
    }
}
