//! GS-6: being able to peel further costs a negligible amount.

use super::{Outcome, Part, Verdict, all_of, ratio_text, with_time};
use crate::reproduce::green_silverman::derived::TWIN;
use crate::reproduce::green_silverman::derived::count_ratio;
use crate::reproduce::green_silverman::published::{Published, cells};
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::ratio::time_ratio;
use crate::reproduce::rows::CountRow;
use crate::stats::interval::{Place, equivalence};

/// A negligible share of the time.
const MARGIN: f64 = 0.02;

pub(super) fn judge(records: &Records, _: &Published) -> Verdict {
    let time: Vec<Part> = cells().map(|cell| by_time(records, cell)).collect();
    let counts = by_counts(records);
    let outcome = with_time(counts.outcome, all_of(time.iter().map(|part| part.outcome)));
    let notes = cells()
        .filter_map(|cell| {
            let twin = time_ratio(&records.times, cell, TWIN, "gs")?;
            let text = ratio_text(twin.median, twin.interval(0.90));
            Some(format!(
                "{} {}: GS against itself {text}: what this machine can resolve",
                cell.0, cell.1
            ))
        })
        .collect();
    Verdict {
        id: "GS-6",
        outcome,
        parts: std::iter::once(counts).chain(time).collect(),
        notes,
    }
}

fn by_time(records: &Records, cell: (&str, usize)) -> Part {
    let what = format!(
        "time, {} {}: with over without, within 2 % of 1",
        cell.0, cell.1
    );
    let Some(ratio) = time_ratio(&records.times, cell, "gs", "gs-bare") else {
        return Part::new(what, Outcome::NotTestable, "not timed");
    };
    let interval = ratio.interval(0.90);
    let outcome = match equivalence(interval, 0.0, MARGIN.ln_1p()) {
        Place::Within => Outcome::Confirmed,
        Place::Outside if interval.0 > 0.0 => Outcome::Refuted,
        // Cheaper with the bookkeeping than without is not a cost.
        Place::Outside => Outcome::Confirmed,
        Place::Across if interval.1 <= MARGIN.ln_1p() => Outcome::Confirmed,
        Place::Across => Outcome::NotDistinguishable,
    };
    Part::new(
        what,
        outcome,
        format!("{}, 90 %", ratio_text(ratio.median, interval)),
    )
}

fn by_counts(records: &Records) -> Part {
    let what = "counts: the bookkeeping asks no question";
    let ratios: Option<Vec<_>> = cells()
        .map(|cell| count_ratio(records, cell, "gs", "gs-bare", CountRow::questions))
        .collect();
    let Some(ratios) = ratios else {
        return Part::new(what, Outcome::NotTestable, "not counted in every cell");
    };
    let largest = ratios
        .iter()
        .map(|ratio| ratio.log)
        .fold(f64::NEG_INFINITY, f64::max);
    let outcome = if largest <= MARGIN.ln_1p() {
        Outcome::Confirmed
    } else {
        Outcome::Refuted
    };
    Part::new(
        what,
        outcome,
        format!("largest ratio of six cells {:.4}", largest.exp()),
    )
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    fn verdict(time: f64, noise: f64, counts: f64) -> Outcome {
        let mut records = Records::default();
        let with = |factor: f64| {
            move |method: &str, _: &str, _: usize| if method == "gs" { factor } else { 1.0 }
        };
        made_up::times(&mut records, &["gs", "gs-bare"], noise, with(time));
        made_up::counts(&mut records, &["gs", "gs-bare"], with(counts));
        judge(&records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(1.0, 0.001, 1.0), Outcome::Confirmed);
        assert_eq!(verdict(1.3, 0.001, 1.0), Outcome::CountsOnly);
        assert_eq!(verdict(1.3, 0.001, 1.3), Outcome::Refuted);
        assert_eq!(verdict(1.02, 0.3, 1.3), Outcome::NotDistinguishable);
    }
}
