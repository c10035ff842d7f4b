//! D-8: degenerate sets, with rounded cotangents and with a symbolic perturbation.

use super::{Outcome, Part, Verdict, always, share, verdict};
use crate::reproduce::day::derived::in_order;
use crate::reproduce::day::records::{BatteryRow, Records};
use crate::reproduce::day::studies::battery::EXACT;
use crate::stats::wilson;

pub(super) fn judge(records: &Records) -> Verdict {
    let formats = in_order(records.own.battery.iter().map(|row| &row.format));
    let rounded = formats.iter().filter(|format| **format != EXACT);
    let mut parts: Vec<Part> = rounded.map(|format| suffers(records, format)).collect();
    parts.push(solved(records));
    parts.push(costs_nothing(records));
    let names = in_order(records.own.battery.iter().map(|row| &row.what));
    let notes = names.into_iter().filter_map(|what| note(records, what));
    verdict("D-8", parts, notes.collect())
}

/// Right of all in `format`, among sets in general position or among degenerate ones.
fn right(records: &Records, format: &str, of: impl Fn(&BatteryRow) -> bool) -> (usize, usize) {
    let rows = records.own.battery.iter();
    rows.filter(|row| row.format == format && of(row))
        .fold((0, 0), |(right, all), row| {
            (right + usize::from(row.outcome == "right"), all + 1)
        })
}

/// Whether degenerate sets are right less often than sets in general position.
fn suffers(records: &Records, format: &str) -> Part {
    let general = right(records, format, |row| row.what.is_empty());
    let degenerate = right(records, format, |row| !row.what.is_empty());
    let what = format!(
        "{format}, cotangents: degenerate sets are right less often than sets in general position"
    );
    if general.1 == 0 || degenerate.1 == 0 {
        return Part::new(
            what,
            Outcome::NotTestable,
            "one of the two kinds is missing",
        );
    }
    let (low, high) = wilson::interval(general.0, general.1);
    let (from, to) = wilson::interval(degenerate.0, degenerate.1);
    let outcome = if to < low {
        Outcome::Confirmed
    } else if from > high {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    let statistic = format!(
        "degenerate {}; general {}",
        share(degenerate.0, degenerate.1),
        share(general.0, general.1)
    );
    Part::new(what, outcome, statistic)
}

/// Whether exact answers, perturbed, are right on all.
fn solved(records: &Records) -> Part {
    let (right, all) = right(records, EXACT, |row| !row.what.is_empty());
    Part::new(
        "exact orientations, perturbed: every degenerate set right, all variants and two other methods alike",
        always(all - right, all),
        share(right, all),
    )
}

/// Whether the perturbation is never called upon in general position.
fn costs_nothing(records: &Records) -> Part {
    let what = "in general position the perturbation asks nothing";
    let rows = || {
        let rows = records.own.battery.iter();
        rows.filter(|row| row.format == EXACT && row.what.is_empty())
    };
    let questions: u64 = rows().map(|row| row.questions).sum();
    let vanished: u64 = rows().map(|row| row.vanished).sum();
    Part::new(
        what,
        always(vanished as usize, questions as usize),
        format!(
            "{vanished} of {questions} answers vanish on {} sets",
            rows().count()
        ),
    )
}

/// One kind of degeneracy in every format.
fn note(records: &Records, what: &str) -> Option<String> {
    let kind = |row: &BatteryRow| row.what == what;
    let formats = in_order(records.own.battery.iter().map(|row| &row.format));
    let texts: Vec<String> = formats
        .iter()
        .map(|format| {
            let (right, all) = right(records, format, kind);
            format!("{format} {right} of {all} right")
        })
        .collect();
    let rows = || {
        let rows = records.own.battery.iter();
        rows.filter(|row| row.format == EXACT && kind(row))
    };
    let questions: u64 = rows().map(|row| row.questions).sum();
    let vanished: u64 = rows().map(|row| row.vanished).sum();
    (questions > 0).then(|| {
        format!(
            "{}: {}; {:.1} % of the exact answers vanish",
            if what.is_empty() {
                "general position"
            } else {
                what
            },
            texts.join(", "),
            100.0 * vanished as f64 / questions as f64
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(general: usize, degenerate: usize, exact: usize, vanished: u64) -> Verdict {
        let mut records = Records::default();
        for i in 0..100 {
            for (what, rounded, exact, vanished) in [
                ("", general, 100, vanished),
                ("lattice", degenerate, exact, 50),
            ] {
                let outcome = |right| if i < right { "right" } else { "endless" }.to_owned();
                let row = BatteryRow {
                    what: what.to_owned(),
                    questions: 100,
                    vanished,
                    ..BatteryRow::default()
                };
                records.own.battery.extend([
                    BatteryRow {
                        format: EXACT.to_owned(),
                        outcome: outcome(exact),
                        ..row.clone()
                    },
                    BatteryRow {
                        format: "f64".to_owned(),
                        outcome: outcome(rounded),
                        ..row
                    },
                ]);
            }
        }
        judge(&records)
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(judged(100, 20, 100, 0).outcome, Outcome::Confirmed);
        assert_eq!(judged(20, 100, 100, 0).outcome, Outcome::Refuted);
        assert_eq!(judged(60, 55, 100, 0).outcome, Outcome::NotDistinguishable);
        assert_eq!(judged(100, 20, 99, 0).parts[1].outcome, Outcome::Refuted);
        assert_eq!(judged(100, 20, 100, 1).parts[2].outcome, Outcome::Refuted);
    }
}
