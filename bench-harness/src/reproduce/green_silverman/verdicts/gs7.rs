//! GS-7: how large the stack of labels grows.

use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::green_silverman::derived::range;
use crate::reproduce::green_silverman::published::{DISTRIBUTIONS, Published};
use crate::reproduce::green_silverman::records::{PeelRow, Records};
use crate::stats::line::fit_log_log;

pub(super) fn judge(records: &Records, _: &Published) -> Verdict {
    let parts: Vec<Part> = std::iter::once(bound(records))
        .chain(
            DISTRIBUTIONS
                .iter()
                .map(|distribution| order(records, distribution)),
        )
        .collect();
    verdict("GS-7", parts, circle(records).into_iter().collect())
}

/// The rows whose stack was watched.
fn watched(records: &Records) -> impl Iterator<Item = &PeelRow> {
    records.own.peels.iter().filter(|row| row.storage > 0)
}

fn bound(records: &Records) -> Part {
    let what = "peels plus points on the largest peel always suffice";
    let allowed = |row: &PeelRow| (row.layers + row.largest) as u64;
    let all = watched(records).count();
    let above = watched(records)
        .filter(|row| row.storage > allowed(row))
        .count();
    let fullest = watched(records)
        .map(|row| row.storage as f64 / allowed(row) as f64)
        .fold(0.0, f64::max);
    let outcome = match (all, above) {
        (0, _) => Outcome::NotTestable,
        (_, 0) => Outcome::Confirmed,
        _ => Outcome::Refuted,
    };
    Part::new(
        what,
        outcome,
        format!("exceeded in {above} of {all} peelings; at most {fullest:.3} of the bound used"),
    )
}

fn order(records: &Records, distribution: &str) -> Part {
    let what = format!("{distribution}: the stack is of smaller order than n");
    let rows = watched(records).filter(|row| row.distribution == distribution);
    let data: Vec<(f64, f64)> = rows.map(|row| (row.n as f64, row.storage as f64)).collect();
    let Some(line) = fit_log_log(&data) else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "not peeled at two sizes or more",
        );
    };
    let (low, high) = line.slope_interval(0.95);
    let outcome = match (low, high) {
        (_, high) if high < 1.0 => Outcome::Confirmed,
        (low, _) if low >= 1.0 => Outcome::Refuted,
        _ => Outcome::NotDistinguishable,
    };
    let statistic = format!(
        "m grows as n to the {:.3}, 95 % [{low:.3}, {high:.3}]; {}",
        line.slope,
        range(&data)
    );
    Part::new(what, outcome, statistic)
}

/// Why the paper says "almost always".
fn circle(records: &Records) -> Option<String> {
    let row = watched(records)
        .filter(|row| row.distribution == "circle")
        .max_by_key(|row| row.n)?;
    Some(format!(
        "on a circle the stack needs {} rows for {} points: of the order of n",
        row.storage, row.n
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(exponent: f64, spread: f64, bound: usize) -> Outcome {
        let mut records = Records::default();
        for distribution in DISTRIBUTIONS {
            for n in [100_usize, 1_000, 10_000] {
                for replicate in 0..4 {
                    let factor = 1.0 + spread * (replicate as f64 - 1.5);
                    let storage = ((n as f64).powf(exponent) * factor) as u64;
                    records.own.peels.push(PeelRow {
                        distribution: distribution.to_owned(),
                        n,
                        replicate,
                        layers: bound,
                        largest: storage as usize,
                        storage: storage + 5,
                        ..PeelRow::default()
                    });
                }
            }
        }
        judge(&records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(0.66, 0.01, 5), Outcome::Confirmed);
        assert_eq!(verdict(0.66, 0.01, 4), Outcome::Refuted);
        assert_eq!(verdict(1.2, 0.01, 5), Outcome::Refuted);
        assert_eq!(verdict(1.0, 0.6, 5), Outcome::NotDistinguishable);
    }
}
