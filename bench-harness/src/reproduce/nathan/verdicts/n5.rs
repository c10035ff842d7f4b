//! N-5: an epsilon scaled to the geometry takes care of rounding.

use super::{Outcome, Part, Verdict, always, distinct, verdict};
use crate::reproduce::nathan::records::{EpsilonRow, Records};
use crate::stats::wilson;

const SCALED: &str =
    "the epsilon is scaled to the geometry: failures do not depend on where the origin is";

pub(super) fn judge(records: &Records) -> Verdict {
    let wrong_by_exact: usize = of(records, "exact", "tested").map(|row| row.wrong).sum();
    if wrong_by_exact > 0 {
        let statistic = format!("the exact control is wrong on {wrong_by_exact} sets");
        let part = Part::new("the control", Outcome::NotTestable, statistic);
        return verdict("N-5", vec![part], Vec::new());
    }
    let mut parts: Vec<Part> = names(records)
        .iter()
        .map(|name| every_set(records, name))
        .collect();
    parts.push(scaled(records));
    let exact: usize = of(records, "exact", "tested").map(|row| row.sets).sum();
    let mut notes = Vec::new();
    if exact > 0 {
        notes.push(format!(
            "with exact answers and no epsilon: 0 of {exact} sets wrong"
        ));
    }
    for name in names(records) {
        let (wrong, sets) =
            total(of(records, "epsilon", "skipped").filter(|row| row.distribution == name));
        notes.push(format!(
            "{name}: with the same epsilon, but without testing a triangle's own corners, {wrong} of {sets} sets wrong"
        ));
    }
    verdict("N-5", parts, notes)
}

fn of<'a>(
    records: &'a Records,
    arithmetic: &'a str,
    own_corners: &'a str,
) -> impl Iterator<Item = &'a EpsilonRow> {
    let rows = records.own.epsilon.iter();
    rows.filter(move |row| row.arithmetic == arithmetic && row.own_corners == own_corners)
}

fn names(records: &Records) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for row in &records.own.epsilon {
        if !names.contains(&row.distribution) {
            names.push(row.distribution.clone());
        }
    }
    names
}

fn total<'a>(rows: impl Iterator<Item = &'a EpsilonRow>) -> (usize, usize) {
    rows.fold((0, 0), |(wrong, sets), row| {
        (wrong + row.wrong, sets + row.sets)
    })
}

fn every_set(records: &Records, name: &str) -> Part {
    let rows = of(records, "epsilon", "tested").filter(|row| row.distribution == name);
    let (wrong, sets) = total(rows);
    let (low, high) = wilson::interval(wrong, sets);
    Part::new(
        format!("{name}: with the epsilon every set is wrapped right"),
        always(wrong, sets),
        format!(
            "wrong {wrong} of {sets} over all offsets, {:.1} % [{:.1}, {:.1}]",
            100.0 * wrong as f64 / sets.max(1) as f64,
            100.0 * low,
            100.0 * high
        ),
    )
}

/// Whether, for one distribution, the intervals of two offsets do not meet.
fn scaled(records: &Records) -> Part {
    let mut apart = Vec::new();
    let mut compared = 0;
    for name in names(records) {
        let rows: Vec<&EpsilonRow> = of(records, "epsilon", "tested")
            .filter(|row| row.distribution == name)
            .collect();
        if distinct(rows.iter().map(|row| row.offset)).len() < 2 {
            continue;
        }
        compared += 1;
        let interval = |row: &&EpsilonRow| wilson::interval(row.wrong, row.sets);
        let highest_low = rows.iter().map(interval).map(|i| i.0).fold(0.0, f64::max);
        let lowest_high = rows.iter().map(interval).map(|i| i.1).fold(1.0, f64::min);
        if highest_low > lowest_high {
            apart.push(format!(
                "{name} from below {:.1} % to above {:.1} %",
                100.0 * lowest_high,
                100.0 * highest_low
            ));
        }
    }
    match (compared, apart.is_empty()) {
        (0, _) => Part::new(SCALED, Outcome::NotTestable, "no two offsets"),
        (_, true) => Part::new(
            SCALED,
            Outcome::Confirmed,
            "the 95 % intervals of all offsets meet",
        ),
        (_, false) => Part::new(SCALED, Outcome::Refuted, apart.join("; ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::nathan::records::Studied;

    fn judged(near: usize, far: usize, exact: usize, sets: usize) -> Verdict {
        let row = |arithmetic: &str, offset, wrong| EpsilonRow {
            distribution: "ball".to_owned(),
            offset,
            arithmetic: arithmetic.to_owned(),
            own_corners: "tested".to_owned(),
            sets,
            wrong,
            ..EpsilonRow::default()
        };
        judge(&Records::from(Studied {
            epsilon: vec![
                row("epsilon", 0.0, near),
                row("epsilon", 1e8, far),
                row("exact", 0.0, exact),
            ],
            ..Studied::default()
        }))
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(judged(0, 0, 0, 100).outcome, Outcome::Confirmed);
        assert_eq!(judged(0, 0, 0, 10).outcome, Outcome::NotDistinguishable);
        let same = judged(10, 11, 0, 100);
        assert_eq!(same.outcome, Outcome::Refuted);
        assert_eq!(same.parts[1].outcome, Outcome::Confirmed);
        assert_eq!(judged(0, 60, 0, 100).parts[1].outcome, Outcome::Refuted);
        assert_eq!(judged(0, 0, 1, 100).outcome, Outcome::NotTestable);
    }
}
