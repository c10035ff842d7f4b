//! Records made up for the tests of the judges.

use crate::reproduce::balan::records::Records;
use crate::reproduce::rows::{CountRow, TimeRow};

/// Sizes of the made-up sets.
pub(super) const SIZES: [usize; 3] = [100, 1_000, 10_000];

/// Three counted runs a cell; `fill` makes a row of n, the rest is filled in and varied by `spread` (a share).
pub(super) fn counts(
    records: &mut Records,
    distributions: &[&str],
    method: &str,
    fill: impl Fn(&str, f64) -> CountRow,
) {
    for distribution in distributions {
        for n in SIZES {
            for replicate in 0..3 {
                records.counts.push(CountRow {
                    stage: "counts".to_owned(),
                    distribution: (*distribution).to_owned(),
                    n,
                    replicate,
                    method: method.to_owned(),
                    ..fill(distribution, n as f64 * (1.0 + 0.001 * replicate as f64))
                });
            }
        }
    }
}

/// Times of `methods` in one cell, each `factor(method)` microseconds.
pub(super) fn times(records: &mut Records, methods: &[&str], factor: impl Fn(&str) -> f64) {
    for realisation in 0..3 {
        for round in 0..5_u32 {
            for method in methods {
                let wobble = 1.0 + 0.01 * f64::from((round * 7 + method.len() as u32) % 3);
                records.times.push(TimeRow {
                    distribution: "ball".to_owned(),
                    n: 1_000,
                    realisation,
                    round,
                    method: (*method).to_owned(),
                    calls: 1,
                    nanoseconds: (1_000.0 * factor(method) * wobble) as u64,
                });
            }
        }
    }
}
