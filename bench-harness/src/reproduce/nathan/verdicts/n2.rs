//! N-2: what the method accepts are the triangles of the hull, each once.

use super::{Outcome, Part, Verdict, always, verdict, wraps};
use crate::reproduce::nathan::records::{Records, WrapRow};

pub(super) fn judge(records: &Records) -> Verdict {
    let parts = vec![
        part(
            records,
            "the triangles are those of the hull, 2h - 4 of them, repetitions aside",
            |row| row.triangles - row.repetitions == 2 * row.h - 4,
        ),
        part(records, "no triangle is accepted twice", |row| {
            row.repetitions == 0
        }),
    ];
    let notes = [exactly(records), corrected(records)];
    verdict("N-2", parts, notes.into_iter().flatten().collect())
}

fn printed(records: &Records) -> impl Iterator<Item = &WrapRow> {
    wraps(records, "random", "printed").chain(wraps(records, "inside-out", "printed"))
}

fn part(records: &Records, what: &str, holds: fn(&WrapRow) -> bool) -> Part {
    let all = printed(records).count();
    let against = printed(records).filter(|row| !holds(row)).count();
    let outcome = match always(against, all) {
        // Exact integers of certified runs; there is no chance in them that a hundred runs would even out.
        Outcome::NotDistinguishable => Outcome::Confirmed,
        outcome => outcome,
    };
    Part::new(what, outcome, format!("not so in {against} of {all} runs"))
}

/// The share of runs as printed that accept exactly 3h - 6 triangles, h - 2 of them repeated.
pub(super) fn share_of_3h(records: &Records) -> Option<f64> {
    let all = printed(records).count();
    let exact = printed(records)
        .filter(|row| row.triangles == 3 * row.h - 6 && row.repetitions == row.h - 2)
        .count();
    (all > 0).then(|| exact as f64 / all as f64)
}

fn exactly(records: &Records) -> Option<String> {
    let share = share_of_3h(records)?;
    Some(format!(
        "one triangle for each edge of the hull: exactly 3h - 6 triangles, h - 2 of them repetitions, in {:.1} % of the \
         runs",
        100.0 * share
    ))
}

fn corrected(records: &Records) -> Option<String> {
    let rows = || wraps(records, "random", "corrected");
    let most = rows().map(|row| row.repetitions).max()?;
    Some(format!(
        "with marks on the sides of triangles in place of edges, at most {most} repetitions in {} runs",
        rows().count()
    ))
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |repetitions: fn(usize) -> usize, missing: usize| {
            let mut records = Records::default();
            made_up::wraps(&mut records, "random", "printed", |row| {
                row.repetitions = repetitions(row.h);
                row.triangles = 2 * row.h - 4 + row.repetitions - missing;
            });
            judge(&records)
        };
        assert_eq!(judged(|_| 0, 0).outcome, Outcome::Confirmed);
        let twice = judged(|h| h - 2, 0);
        assert_eq!(twice.parts[0].outcome, Outcome::Confirmed);
        assert_eq!(twice.outcome, Outcome::Refuted);
        assert!(twice.notes[0].contains("100.0 %"));
        assert_eq!(judged(|_| 0, 1).parts[0].outcome, Outcome::Refuted);
    }
}
