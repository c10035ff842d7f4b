//! GS-9: what a complete peeling costs.

use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::green_silverman::derived::{range, upper_decades};
use crate::reproduce::green_silverman::published::Published;
use crate::reproduce::green_silverman::records::{PeelRow, Records};
use crate::stats::interval::{Place, equivalence};
use crate::stats::line::fit_log_log;
use crate::stats::summary::mean;

/// An exponent may differ from its limit by this much at finite n.
const MARGIN: f64 = 0.02;

pub(super) fn judge(records: &Records, _: &Published) -> Verdict {
    let parts = vec![
        exponent(
            records,
            "points left, summed over the peels",
            5.0 / 3.0,
            |row| row.remaining,
        ),
        exponent(records, "area evaluations", 5.0 / 3.0, |row| {
            row.orientations
        }),
        exponent(records, "layers", 2.0 / 3.0, |row| row.layers as u64),
    ];
    verdict("GS-9", parts, constants(records).into_iter().collect())
}

fn exponent(records: &Records, what: &str, target: f64, quantity: fn(&PeelRow) -> u64) -> Part {
    let what = format!("disc: {what} grow as n to the {target:.3}");
    let rows = records
        .own
        .peels
        .iter()
        .filter(|row| row.distribution == "disc");
    let all: Vec<(usize, f64)> = rows.map(|row| (row.n, quantity(row) as f64)).collect();
    let data = upper_decades(&all);
    let Some(line) = fit_log_log(&data) else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "not peeled at two sizes or more",
        );
    };
    let (low, high) = line.slope_interval(0.90);
    let outcome = match equivalence((low, high), target, MARGIN) {
        Place::Within => Outcome::Confirmed,
        Place::Outside => Outcome::Refuted,
        Place::Across => Outcome::NotDistinguishable,
    };
    let statistic = format!(
        "exponent {:.4}, 90 % [{low:.4}, {high:.4}], band {target:.4} ± {MARGIN}; {}",
        line.slope,
        range(&data)
    );
    Part::new(what, outcome, statistic)
}

/// The constants at the largest n, beside their known limits.
fn constants(records: &Records) -> Option<String> {
    let disc = || {
        records
            .own
            .peels
            .iter()
            .filter(|row| row.distribution == "disc")
    };
    let n = disc().map(|row| row.n).max()?;
    let largest: Vec<&PeelRow> = disc().filter(|row| row.n == n).collect();
    let of = |value: fn(&PeelRow) -> f64| {
        mean(&largest.iter().map(|row| value(row)).collect::<Vec<f64>>())
    };
    let share = of(|row| row.remaining as f64 / (row.n as f64 * row.layers as f64));
    let layers = of(layers_constant);
    let evaluations = of(|row| row.orientations as f64 / row.remaining as f64);
    Some(format!(
        "disc {n}: {layers:.4} n^(2/3) layers; points left summed over the peels {share:.4} n times layers (limit \
         2/5); {evaluations:.3} area evaluations for each"
    ))
}

/// Layers over n to the 2/3.
pub(super) fn layers_constant(row: &PeelRow) -> f64 {
    row.layers as f64 / (row.n as f64).powf(2.0 / 3.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(visits: f64, layers: f64, spread: f64) -> Outcome {
        let mut records = Records::default();
        for n in [1_000_usize, 10_000, 100_000] {
            for replicate in 0..4 {
                let factor = 1.0 + spread * (replicate as f64 - 1.5);
                let power = |exponent: f64| (10.0 * (n as f64).powf(exponent) * factor) as u64;
                records.own.peels.push(PeelRow {
                    distribution: "disc".to_owned(),
                    n,
                    replicate,
                    layers: power(layers) as usize,
                    remaining: power(visits),
                    orientations: power(visits),
                    ..PeelRow::default()
                });
            }
        }
        judge(&records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(5.0 / 3.0, 2.0 / 3.0, 0.001), Outcome::Confirmed);
        assert_eq!(verdict(2.0, 2.0 / 3.0, 0.001), Outcome::Refuted);
        assert_eq!(verdict(5.0 / 3.0, 0.5, 0.001), Outcome::Refuted);
        assert_eq!(
            verdict(5.0 / 3.0, 2.0 / 3.0, 0.5),
            Outcome::NotDistinguishable
        );
    }
}
