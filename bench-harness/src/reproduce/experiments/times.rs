//! Times, interleaved and warm, of certified results only (Table 2, Figure 7, GS-1, GS-4, GS-6).
//!
//! Every round takes one sample of every method on every realisation, the methods in an order shuffled anew,
//! so that what disturbs the machine disturbs all of them. Short calls are repeated until a sample lasts a
//! millisecond. GS takes part twice: its second entry shows the noise of a program against itself.

use super::certify::certify;
use super::hull_method;
use crate::reproduce::definition::{Definition, Times, product};
use crate::reproduce::progress::Progress;
use crate::reproduce::records::{Records, TimeRow};
use crate::reproduce::sets::PointSet;
use anyhow::Result;
use geometry_core::{Boundary, Hull2, HullError, Points};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The name under which GS takes part a second time.
pub(crate) const TWIN: &str = "gs-twin";

/// A sample lasts at least this long.
const SHORTEST: Duration = Duration::from_millis(1);

/// Times every cell of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let cells = |block: &Times| product(&block.distributions, &block.n);
    let progress = Progress::start(
        "times",
        definition
            .times
            .iter()
            .map(|block| cells(block).len())
            .sum(),
    );
    for block in &definition.times {
        for (distribution, n) in cells(block) {
            cell(definition.seed, &distribution, n, block, records)?;
            progress.finished(&format!("{distribution} {n}"));
        }
    }
    Ok(())
}

/// A method that takes part, and how often it is called for one sample.
struct Contestant {
    name: String,
    hull: fn(Points<'_, 2>, Boundary) -> Result<Hull2, HullError>,
    calls: u64,
}

fn cell(
    seed: u64,
    distribution: &str,
    n: usize,
    block: &Times,
    records: &mut Records,
) -> Result<()> {
    let mut sets = Vec::new();
    for realisation in 0..block.realisations {
        let set = PointSet::generate(seed, distribution, n, realisation)?;
        let certified = certify("times", &set, &block.methods)?;
        records.sets.push(certified.set);
        records.failures.extend(certified.failures);
        sets.push(set);
    }
    let Some(first) = sets.first() else {
        return Ok(());
    };
    let sound = |method: &&String| !records.failed(distribution, n, method);
    let mut contestants = Vec::new();
    for method in block.methods.iter().filter(sound) {
        let hull = hull_method(method)?.exact;
        let calls = calls_for_a_sample(hull, Points::new(&first.points)?);
        contestants.push(Contestant {
            name: method.clone(),
            hull,
            calls,
        });
        if method == "gs" {
            contestants.push(Contestant {
                name: TWIN.to_owned(),
                hull,
                calls,
            });
        }
    }
    let mut random = ChaCha8Rng::seed_from_u64(first.seed);
    for round in 0..block.rounds {
        for set in &sets {
            let points = Points::new(&set.points)?;
            shuffle(&mut contestants, &mut random);
            for contestant in &contestants {
                records.times.push(TimeRow {
                    distribution: distribution.to_owned(),
                    n,
                    realisation: set.replicate,
                    round,
                    method: contestant.name.clone(),
                    calls: contestant.calls,
                    nanoseconds: sample(contestant.hull, points, contestant.calls).as_nanos()
                        as u64,
                });
            }
        }
    }
    Ok(())
}

/// How many calls take at least [`SHORTEST`], by doubling. Also warms up.
fn calls_for_a_sample(
    hull: fn(Points<'_, 2>, Boundary) -> Result<Hull2, HullError>,
    points: Points<'_, 2>,
) -> u64 {
    let mut calls = 1;
    while sample(hull, points, calls) < SHORTEST {
        calls *= 2;
    }
    calls
}

fn sample(
    hull: fn(Points<'_, 2>, Boundary) -> Result<Hull2, HullError>,
    points: Points<'_, 2>,
    calls: u64,
) -> Duration {
    let start = Instant::now();
    for _ in 0..calls {
        let _ = black_box(hull(black_box(points), Boundary::All));
    }
    start.elapsed()
}

/// Puts the contestants in random order (Fisher and Yates).
fn shuffle(contestants: &mut [Contestant], random: &mut ChaCha8Rng) {
    for last in (1..contestants.len()).rev() {
        contestants.swap(last, random.random_range(0..=last));
    }
}
