//! Records made up for the tests of the judges.

use crate::reproduce::green_silverman::published::cells;
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::rows::{CountRow, TimeRow};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Times in the six cells of Table 2: each method takes `factor(method, distribution, n)` nanoseconds a point,
/// give or take `noise` (a share).
pub(super) fn times(
    records: &mut Records,
    methods: &[&str],
    noise: f64,
    factor: impl Fn(&str, &str, usize) -> f64,
) {
    let mut random = ChaCha8Rng::seed_from_u64(11);
    for (distribution, n) in cells() {
        for realisation in 0..5 {
            for round in 0..7_u32 {
                for method in methods {
                    let wobble = 1.0 + noise * (2.0 * random.random::<f64>() - 1.0);
                    records.times.push(TimeRow {
                        distribution: distribution.to_owned(),
                        n,
                        realisation,
                        round,
                        method: (*method).to_owned(),
                        calls: 1,
                        nanoseconds: (1_000.0 * n as f64 * factor(method, distribution, n) * wobble)
                            as u64,
                    });
                }
            }
        }
    }
}

/// Counts in the six cells of Table 2: each method asks `factor(method, distribution, n)` questions a point.
pub(super) fn counts(
    records: &mut Records,
    methods: &[&str],
    factor: impl Fn(&str, &str, usize) -> f64,
) {
    for (distribution, n) in cells() {
        for replicate in 0..4 {
            for method in methods {
                let questions =
                    n as f64 * factor(method, distribution, n) * (1.0 + 0.01 * replicate as f64);
                records.counts.push(CountRow {
                    distribution: distribution.to_owned(),
                    n,
                    replicate,
                    method: (*method).to_owned(),
                    orientations: questions as u64,
                    ..CountRow::default()
                });
            }
        }
    }
}
