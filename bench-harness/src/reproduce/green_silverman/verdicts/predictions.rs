//! What we predicted before the run, beside what came out.

use super::gs3::circle_line;
use super::gs9::layers_constant;
use crate::reproduce::green_silverman::derived::{a_point, count_ratio, counts_against_n};
use crate::reproduce::green_silverman::records::{PeelRow, Records};
use crate::reproduce::ratio::median_time;
use crate::reproduce::rows::CountRow;
use crate::stats::summary::mean;

/// The value of what the prediction called `id` is about.
pub(crate) fn measure(id: &str, records: &Records) -> Option<f64> {
    match id {
        "jarvis-disc" => {
            Some(count_ratio(records, ("disc", 1_000), "jarvis-j1", "gs", areas)?.ratio())
        }
        "jarvis-beats-graham" => Some(
            count_ratio(
                records,
                ("cauchy", 1_000),
                "jarvis-j1",
                "graham",
                CountRow::questions,
            )?
            .ratio(),
        ),
        "disc-constant" => evaluations_at_largest(records, "disc"),
        "normal-constant" => evaluations_at_largest(records, "normal"),
        "circle-slope" => Some(circle_line(records)?.slope * std::f64::consts::LN_2),
        "killer-constant" => {
            let n = largest(records, "killer")?;
            Some(evaluations_at_largest(records, "killer")? / n as f64)
        }
        "layers-constant" => {
            let disc = || {
                records
                    .own
                    .peels
                    .iter()
                    .filter(|row| row.distribution == "disc")
            };
            let n = disc().map(|row| row.n).max()?;
            let rows: Vec<&PeelRow> = disc().filter(|row| row.n == n).collect();
            Some(mean(
                &rows.into_iter().map(layers_constant).collect::<Vec<f64>>(),
            ))
        }
        "circle-order" => {
            let circle = records
                .times
                .iter()
                .filter(|row| row.distribution == "circle");
            let cell = ("circle", circle.map(|row| row.n).max()?);
            Some(
                median_time(&records.times, cell, "monotone-chain")?
                    / median_time(&records.times, cell, "gs")?,
            )
        }
        _ => None,
    }
}

fn areas(row: &CountRow) -> u64 {
    row.orientations
}

/// The largest n at which GS was counted.
fn largest(records: &Records, distribution: &str) -> Option<usize> {
    counts_against_n(records, distribution, "gs", |row| row.orientations)
        .iter()
        .map(|(n, _)| *n)
        .max()
}

fn evaluations_at_largest(records: &Records, distribution: &str) -> Option<f64> {
    a_point(
        records,
        (distribution, largest(records, distribution)?),
        "gs",
        |row| row.orientations,
    )
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;
    use crate::reproduce::green_silverman::GreenSilverman;
    use crate::reproduce::paper::checks;

    #[test]
    fn a_prediction_can_hold_and_can_fail() {
        let check_with = |jarvis: f64| {
            let mut records = Records::default();
            let factor =
                |method: &str, _: &str, _: usize| if method == "jarvis-j1" { jarvis } else { 1.0 };
            made_up::counts(&mut records, &["gs", "jarvis-j1"], factor);
            checks::predictions::<GreenSilverman>(&records)["jarvis-disc"]
        };
        assert_eq!(check_with(9.0), Some(true));
        assert_eq!(check_with(50.0), Some(false));
    }

    #[test]
    fn every_prediction_has_a_measure() {
        let known = [
            "jarvis-disc",
            "jarvis-beats-graham",
            "disc-constant",
            "normal-constant",
            "circle-slope",
            "killer-constant",
            "layers-constant",
            "circle-order",
        ];
        for id in checks::predictions::<GreenSilverman>(&Records::default()).keys() {
            assert!(known.contains(&id.as_str()), "{id}");
        }
    }
}
