//! Times, interleaved and warm, of certified results only (Table 2, Figure 7, GS-1, GS-4, GS-6).
//!
//! Every round takes one sample of every method on every realisation, the methods in an order shuffled anew,
//! so that what disturbs the machine disturbs all of them. GS takes part twice: its second entry shows the
//! noise of a program against itself.
//!
//! A realisation of small n is a batch of sets, called in turn: called on one small set again and again, a
//! processor learns its branches by heart, and the time is that of no set it has not seen. The batch is
//! called as often as it takes for a sample to last a millisecond.

use super::certify::certify;
use super::hull_method;
use crate::reproduce::data::product;
use crate::reproduce::green_silverman::definition::{Definition, Times};
use crate::reproduce::green_silverman::records::{Records, TimeRow};
use crate::reproduce::green_silverman::sets::PointSet;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
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

type HullFunction = fn(Points<'_, 2>, Boundary) -> Result<Hull2, HullError>;

/// A method that takes part, and how often it goes through a batch for one sample.
struct Contestant {
    name: String,
    hull: HullFunction,
    passes: u64,
}

fn cell(
    seed: u64,
    distribution: &str,
    n: usize,
    block: &Times,
    records: &mut Records,
) -> Result<()> {
    let realisations = realisations(seed, distribution, n, block, records)?;
    let views: Result<Vec<Vec<Points<'_, 2>>>, HullError> = realisations
        .iter()
        .map(|sets| sets.iter().map(|set| Points::new(set)).collect())
        .collect();
    let views = views?;
    let Some(first) = views.first() else {
        return Ok(());
    };
    let mut contestants = contestants(distribution, n, block, records, first)?;
    let mut random = ChaCha8Rng::seed_from_u64(seed ^ n as u64);
    for round in 0..block.rounds {
        for (realisation, sets) in (0..).zip(&views) {
            shuffle(&mut contestants, &mut random);
            for contestant in &contestants {
                records.times.push(TimeRow {
                    distribution: distribution.to_owned(),
                    n,
                    realisation,
                    round,
                    method: contestant.name.clone(),
                    calls: contestant.passes * sets.len() as u64,
                    nanoseconds: sample(contestant.hull, sets, contestant.passes).as_nanos() as u64,
                });
            }
        }
    }
    Ok(())
}

/// The batches of sets of a cell, every result on them certified.
fn realisations(
    seed: u64,
    distribution: &str,
    n: usize,
    block: &Times,
    records: &mut Records,
) -> Result<Vec<Vec<Vec<[f64; 2]>>>> {
    let batch = block.points_a_batch.div_ceil(n as u64);
    let replicates: Vec<u64> = (0..block.realisations * batch).collect();
    let certified = parallel::map(&replicates, |&replicate| {
        let set = PointSet::generate(seed, distribution, n, replicate)?;
        let certified = certify("times", &set, &block.methods)?;
        Ok((set.points, certified))
    })?;
    let mut realisations: Vec<Vec<Vec<[f64; 2]>>> = Vec::new();
    for (replicate, (points, certified)) in (0..).zip(certified) {
        records.sets.push(certified.set);
        records.failures.extend(certified.failures);
        if replicate % batch == 0 {
            realisations.push(Vec::new());
        }
        if let Some(sets) = realisations.last_mut() {
            sets.push(points);
        }
    }
    Ok(realisations)
}

/// The methods certified on every set of the cell, warm; GS twice.
fn contestants(
    distribution: &str,
    n: usize,
    block: &Times,
    records: &Records,
    sets: &[Points<'_, 2>],
) -> Result<Vec<Contestant>> {
    let mut contestants = Vec::new();
    for method in block
        .methods
        .iter()
        .filter(|method| !records.failed(distribution, n, method))
    {
        let hull = hull_method(method)?.exact;
        let passes = passes_for_a_sample(hull, sets);
        contestants.push(Contestant {
            name: method.clone(),
            hull,
            passes,
        });
        if method == "gs" {
            contestants.push(Contestant {
                name: TWIN.to_owned(),
                hull,
                passes,
            });
        }
    }
    Ok(contestants)
}

/// How many passes over the sets take at least [`SHORTEST`], by doubling. Also warms up.
fn passes_for_a_sample(hull: HullFunction, sets: &[Points<'_, 2>]) -> u64 {
    let mut passes = 1;
    while sample(hull, sets, passes) < SHORTEST {
        passes *= 2;
    }
    passes
}

fn sample(hull: HullFunction, sets: &[Points<'_, 2>], passes: u64) -> Duration {
    let start = Instant::now();
    for _ in 0..passes {
        for &points in sets {
            let _ = black_box(hull(black_box(points), Boundary::All));
        }
    }
    start.elapsed()
}

/// Puts the contestants in random order (Fisher and Yates).
fn shuffle(contestants: &mut [Contestant], random: &mut ChaCha8Rng) {
    for last in (1..contestants.len()).rev() {
        contestants.swap(last, random.random_range(0..=last));
    }
}
