//! N-8: one check against the hull of start and end misses no obstacle; small steps may.

use super::{Outcome, Part, Verdict, always, verdict};
use crate::reproduce::nathan::records::{Records, SweepRow};

pub(super) fn judge(records: &Records) -> Verdict {
    let hull = rows(records).filter(|row| row.steps.is_none());
    let steps: Vec<&SweepRow> = rows(records).filter(|row| row.steps.is_some()).collect();
    verdict("N-8", vec![by_hull(hull), by_steps(&steps)], Vec::new())
}

fn rows(records: &Records) -> impl Iterator<Item = &SweepRow> {
    records
        .own
        .sweep
        .iter()
        .filter(|row| row.obstacle == "random")
}

fn by_hull<'a>(rows: impl Iterator<Item = &'a SweepRow>) -> Part {
    let (missed, all) = rows.fold((0, 0), |(missed, all), row| {
        (missed + row.missed, all + row.obstacles)
    });
    Part::new(
        "the check against the hull misses no obstacle that the box meets",
        always(missed, all),
        format!("missed {missed} of {all}"),
    )
}

fn by_steps(rows: &[&SweepRow]) -> Part {
    let obstacles: usize = rows.iter().map(|row| row.obstacles).sum();
    let missed: usize = rows.iter().map(|row| row.missed).sum();
    let outcome = match (missed, obstacles) {
        (_, 0) => Outcome::NotTestable,
        // A risk too small for this many obstacles is not shown to be none.
        (0, _) => Outcome::NotDistinguishable,
        _ => Outcome::Confirmed,
    };
    let each = |row: &&SweepRow| format!("{} by {} steps", row.missed, row.steps.unwrap_or(0));
    let each: Vec<String> = rows.iter().map(each).collect();
    let all = rows.first().map_or(0, |row| row.obstacles);
    Part::new(
        "small steps miss obstacles that the box meets",
        outcome,
        format!("of {all} missed {}", each.join(", ")),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::nathan::records::Studied;

    fn outcome(hull: usize, steps: usize, obstacles: usize) -> Outcome {
        let row = |steps, missed| SweepRow {
            obstacle: "random".to_owned(),
            steps,
            obstacles,
            missed,
        };
        judge(&Records::from(Studied {
            sweep: vec![row(None, hull), row(Some(10), steps)],
            ..Studied::default()
        }))
        .outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(outcome(0, 30, 1_000), Outcome::Confirmed);
        assert_eq!(outcome(1, 30, 1_000), Outcome::Refuted);
        assert_eq!(outcome(0, 0, 1_000), Outcome::NotDistinguishable);
    }
}
