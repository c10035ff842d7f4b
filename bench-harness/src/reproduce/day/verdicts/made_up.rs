//! Records made up for the tests of the judges.

use crate::reproduce::day::records::{ControlRow, MergeRow, PrecisionRow, Records};
use crate::reproduce::day::studies::METHOD;
use crate::reproduce::day::studies::PARALLEL;
use crate::reproduce::rows::{CountRow, TimeRow};

/// Sizes of the made-up sets.
const SIZES: [usize; 8] = [66, 130, 258, 514, 1_026, 2_050, 4_098, 8_194];

/// A row of merges for each distribution and size; `fill` makes a row of n.
pub(super) fn merges(
    records: &mut Records,
    distributions: &[&str],
    variant: &str,
    fill: impl Fn(f64) -> MergeRow,
) {
    for distribution in distributions {
        for n in SIZES {
            records.own.merges.push(MergeRow {
                distribution: (*distribution).to_owned(),
                n,
                variant: variant.to_owned(),
                ..fill(n as f64)
            });
        }
    }
}

/// Three counted runs a cell, `cost(n)` orientations each, give or take a little.
pub(super) fn counts(records: &mut Records, distributions: &[&str], cost: impl Fn(f64) -> f64) {
    for distribution in distributions {
        for n in SIZES {
            for replicate in 0..3 {
                let wobble = 1.0 + 1e-4 * (replicate as f64 - 1.0);
                records.counts.push(CountRow {
                    distribution: (*distribution).to_owned(),
                    n,
                    replicate,
                    method: METHOD.to_owned(),
                    orientations: (cost(n as f64) * wobble) as u64,
                    ..CountRow::default()
                });
            }
        }
    }
}

/// Times of one processor, `cost(n)` nanoseconds give or take a little, and of all, `factor` times that.
pub(super) fn times(
    records: &mut Records,
    distributions: &[&str],
    cost: impl Fn(f64) -> f64,
    factor: f64,
) {
    for distribution in distributions {
        for n in SIZES {
            for (realisation, round) in (0..3).flat_map(|i| (0..4).map(move |j| (i, j))) {
                for (method, factor) in [(METHOD, 1.0), (PARALLEL, factor)] {
                    let wobble = 1.0 + 1e-4 * f64::from((round * 7 + method.len() as u32) % 3);
                    records.times.push(TimeRow {
                        distribution: (*distribution).to_owned(),
                        n,
                        realisation,
                        round,
                        method: method.to_owned(),
                        calls: 1,
                        nanoseconds: (100.0 * cost(n as f64) * factor * wobble) as u64,
                    });
                }
            }
        }
    }
}

/// A hundred sets in single, double and extended: right up to the format's power in `halves`, then a mixture of failures.
/// Of the sets, `control` are right exactly.
pub(super) fn precision(records: &mut Records, halves: [f64; 3], control: usize) {
    let formats = [("f32", 24), ("f64", 53), ("extended", 64)];
    for ((format, bits), half) in formats.into_iter().zip(halves) {
        for power in 0..=20 {
            let x = f64::from(power);
            // Too small is no good either.
            let share = 1.0 / (1.0 + (4.0 * (x - half)).exp()) / (1.0 + (4.0 * (2.0 - x)).exp());
            let right = (100.0 * share).round() as usize;
            let rest = 100 - right;
            records.own.precision.push(PrecisionRow {
                distribution: "cube".to_owned(),
                n: 100,
                range: 1.0,
                format: format.to_owned(),
                bits,
                power,
                sets: 100,
                right,
                wrong: rest - 2 * (rest / 3),
                endless: rest / 3,
                dangling: rest / 3,
                ..PrecisionRow::default()
            });
        }
        records.own.controls.push(ControlRow {
            distribution: "cube".to_owned(),
            n: 100,
            range: 1.0,
            format: format.to_owned(),
            sets: 100,
            right: control,
            ..ControlRow::default()
        });
    }
}
