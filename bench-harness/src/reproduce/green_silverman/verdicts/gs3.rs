//! GS-3: the time of GS is proportional to the number of points.

use super::{Outcome, Part, Verdict, all_of, with_time};
use crate::reproduce::green_silverman::derived::{
    counts_against_n, range, times_against_n, upper_decades,
};
use crate::reproduce::green_silverman::published::{DISTRIBUTIONS, Published};
use crate::reproduce::green_silverman::records::Records;
use crate::stats::interval::{Place, equivalence};
use crate::stats::line::{Line, fit_log_log, fit_on_log};
use crate::stats::summary::mean;

/// Area evaluations a point may change by this much a factor e in n and still count as constant.
const SLOPE_MARGIN: f64 = 0.01;

/// The exponent of time may differ from 1 by this much: caches and branch prediction are no part of the claim.
const TIME_MARGIN: f64 = 0.1;

/// Two one-sided tests at 5 %.
const CONFIDENCE: f64 = 0.90;

pub(super) fn judge(records: &Records, _: &Published) -> Verdict {
    let counts: Vec<Part> = DISTRIBUTIONS
        .iter()
        .map(|distribution| by_counts(records, distribution))
        .collect();
    let time: Vec<Part> = DISTRIBUTIONS
        .iter()
        .map(|distribution| by_time(records, distribution))
        .collect();
    let of = |parts: &[Part]| all_of(parts.iter().map(|part| part.outcome));
    Verdict {
        id: "GS-3",
        outcome: with_time(of(&counts), of(&time)),
        parts: counts.into_iter().chain(time).collect(),
        notes: limits(records),
    }
}

fn outcome(place: Place) -> Outcome {
    match place {
        Place::Within => Outcome::Confirmed,
        Place::Outside => Outcome::Refuted,
        Place::Across => Outcome::NotDistinguishable,
    }
}

/// n and area evaluations a point of GS, over the two upper decades.
fn evaluations(records: &Records, distribution: &str) -> Vec<(f64, f64)> {
    let data = counts_against_n(records, distribution, "gs", |row| row.orientations);
    upper_decades(&data)
        .into_iter()
        .map(|(n, count)| (n, count / n))
        .collect()
}

fn by_counts(records: &Records, distribution: &str) -> Part {
    let what = format!("counts, {distribution}: area evaluations a point do not change with n");
    let data = evaluations(records, distribution);
    let Some(line) = fit_on_log(&data) else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "not counted at two sizes or more",
        );
    };
    let (low, high) = line.slope_interval(CONFIDENCE);
    let largest = data.iter().map(|(n, _)| *n).fold(0.0, f64::max);
    let there: Vec<f64> = data
        .iter()
        .filter(|(n, _)| *n >= largest)
        .map(|(_, y)| *y)
        .collect();
    let statistic = format!(
        "slope on ln n {:+.4}, 90 % [{low:+.4}, {high:+.4}], band ±{SLOPE_MARGIN}; {}; {} sets; \
         {:.4} a point at the largest n",
        line.slope,
        range(&data),
        data.len(),
        mean(&there)
    );
    Part::new(
        what,
        outcome(equivalence((low, high), 0.0, SLOPE_MARGIN)),
        statistic,
    )
}

fn by_time(records: &Records, distribution: &str) -> Part {
    let what = format!("time, {distribution}: the exponent of n is 1");
    let data: Vec<(f64, f64)> = times_against_n(records, distribution, "gs")
        .iter()
        .map(|&(n, time)| (n as f64, time))
        .collect();
    let Some(line) = fit_log_log(&data) else {
        return Part::new(what, Outcome::NotTestable, "not timed at two sizes or more");
    };
    let (low, high) = line.slope_interval(CONFIDENCE);
    let statistic = format!(
        "exponent {:.3}, 90 % [{low:.3}, {high:.3}], band 1 ± {TIME_MARGIN}; {}",
        line.slope,
        range(&data)
    );
    Part::new(
        what,
        outcome(equivalence((low, high), 1.0, TIME_MARGIN)),
        statistic,
    )
}

/// Where linearity ends: the circle and the killer set.
fn limits(records: &Records) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(line) = circle_line(records) {
        let (low, high) = line.slope_interval(0.95);
        let bits = std::f64::consts::LN_2;
        notes.push(format!(
            "on a circle the area evaluations a point grow with n: {:.3} log2 n {:+.2}, 95 % of the slope \
             [{:.3}, {:.3}]; not linear",
            line.slope * bits,
            line.intercept,
            low * bits,
            high * bits
        ));
    }
    let killer: Vec<(f64, f64)> = counts_against_n(records, "killer", "gs", |row| row.orientations)
        .iter()
        .map(|&(n, count)| (n as f64, count))
        .collect();
    if let (Some(line), Some((n, count))) = (fit_log_log(&killer), killer.last()) {
        let (low, high) = line.slope_interval(0.95);
        notes.push(format!(
            "on the killer set the area evaluations grow as n to the {:.3}, 95 % [{low:.3}, {high:.3}], \
             {:.3} n squared at n = {n}",
            line.slope,
            count / (n * n)
        ));
    }
    notes
}

/// Area evaluations a point of GS on a circle, against ln n.
pub(super) fn circle_line(records: &Records) -> Option<Line> {
    let data: Vec<(f64, f64)> = counts_against_n(records, "circle", "gs", |row| row.orientations)
        .iter()
        .map(|&(n, count)| (n as f64, count / n as f64))
        .collect();
    fit_on_log(&data)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::rows::{CountRow, TimeRow};

    /// Counts a point `constant + slope ln n` with a fixed wobble, times as n to the `exponent`.
    fn verdict(slope: f64, wobble: f64, exponent: f64) -> Outcome {
        let mut records = Records::default();
        for distribution in DISTRIBUTIONS {
            for n in [10_000_usize, 100_000, 1_000_000] {
                for replicate in 0..8 {
                    let shift =
                        wobble * [-1.0, 1.0, -0.5, 0.5, 0.8, -0.8, 0.2, -0.2][replicate as usize];
                    let a_point = 3.0 + slope * (n as f64).ln() + shift;
                    records.counts.push(CountRow {
                        distribution: distribution.to_owned(),
                        n,
                        replicate,
                        method: "gs".to_owned(),
                        orientations: (a_point * n as f64) as u64,
                        ..CountRow::default()
                    });
                    records.times.push(TimeRow {
                        distribution: distribution.to_owned(),
                        n,
                        realisation: replicate,
                        round: 0,
                        method: "gs".to_owned(),
                        calls: 1,
                        nanoseconds: (10.0 * (n as f64).powf(exponent) * (1.0 + 0.01 * shift))
                            as u64,
                    });
                }
            }
        }
        judge(&records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(0.0, 0.01, 1.0), Outcome::Confirmed);
        assert_eq!(verdict(0.0, 0.01, 1.3), Outcome::CountsOnly);
        assert_eq!(verdict(0.5, 0.01, 1.3), Outcome::Refuted);
        assert_eq!(verdict(0.0, 1.0, 1.1), Outcome::NotDistinguishable);
    }
}
