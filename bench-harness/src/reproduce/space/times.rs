//! Times of registered methods in one cell, interleaved and warm, of certified results only.
//!
//! One method takes part twice: its second entry shows the noise of a program against itself. A realisation of small
//! n is a batch of different sets.

use super::certify::certify;
use super::rows::{FailureRow, SetRow, TimeRow};
use super::sets::PointSet3;
use super::spatial_method;
use crate::reproduce::parallel;
use crate::reproduce::timing::{Contestant, Sample, interleave};
use anyhow::Result;
use geometry_core::{HullError, Point3, Points};
use std::hint::black_box;

/// How a cell is timed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Race<'a> {
    /// The name of the experiment in the records.
    pub(crate) stage: &'a str,
    pub(crate) methods: &'a [String],
    /// The method that takes part twice, the second time as [`twin`] calls it.
    pub(crate) base: &'a str,
    /// Batches of sets.
    pub(crate) realisations: u64,
    /// A batch holds different sets of at least so many points in all.
    pub(crate) points_a_batch: u64,
    pub(crate) rounds: u32,
}

/// What came of it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Timed {
    pub(crate) sets: Vec<SetRow>,
    /// Methods without a certificate on some set; they are not timed.
    pub(crate) failures: Vec<FailureRow>,
    pub(crate) times: Vec<TimeRow>,
}

/// The name under which `base` takes part a second time.
pub(crate) fn twin(base: &str) -> String {
    format!("{base}-twin")
}

/// The samples of the cell (`distribution`, `n`).
pub(crate) fn race(seed: u64, distribution: &str, n: usize, race: &Race<'_>) -> Result<Timed> {
    let mut timed = Timed::default();
    let realisations = realisations(seed, distribution, n, race, &mut timed)?;
    let views: Result<Vec<Vec<Points<'_, 3>>>, HullError> = realisations
        .iter()
        .map(|sets| sets.iter().map(|set| Points::new(set)).collect())
        .collect();
    let views = views?;
    let Some(first) = views.first() else {
        return Ok(timed);
    };
    let calls = certified_calls(race.methods, &timed.failures)?;
    let mut contestants = Vec::new();
    for (name, call) in &calls {
        let contestant = Contestant::warm(name, call, first);
        contestants.extend((name == race.base).then(|| contestant.twin(twin(name))));
        contestants.push(contestant);
    }
    let row = |sample: Sample| TimeRow {
        distribution: distribution.to_owned(),
        n,
        realisation: sample.realisation,
        round: sample.round,
        method: sample.name,
        calls: sample.calls,
        nanoseconds: sample.nanoseconds,
    };
    let samples = interleave(contestants, &views, race.rounds, seed ^ n as u64);
    timed.times.extend(samples.into_iter().map(row));
    Ok(timed)
}

/// The batches of sets of a cell, every result on them certified.
fn realisations(
    seed: u64,
    distribution: &str,
    n: usize,
    race: &Race<'_>,
    timed: &mut Timed,
) -> Result<Vec<Vec<Vec<Point3>>>> {
    let batch = race.points_a_batch.div_ceil(n as u64);
    let replicates: Vec<u64> = (0..race.realisations * batch).collect();
    let certified = parallel::map(&replicates, |&replicate| {
        let set = PointSet3::generate(seed, distribution, n, replicate)?;
        let certified = certify(race.stage, &set, race.methods)?;
        Ok((set.points, certified))
    })?;
    let mut realisations: Vec<Vec<Vec<Point3>>> = Vec::new();
    for (replicate, (points, certified)) in (0..).zip(certified) {
        timed.sets.push(certified.set);
        timed.failures.extend(certified.failures);
        if replicate % batch == 0 {
            realisations.push(Vec::new());
        }
        if let Some(sets) = realisations.last_mut() {
            sets.push(points);
        }
    }
    Ok(realisations)
}

/// A call of each method that failed nowhere in the cell.
fn certified_calls(
    methods: &[String],
    failures: &[FailureRow],
) -> Result<Vec<(String, impl Fn(&Points<'_, 3>) + use<>)>> {
    let mut calls = Vec::new();
    for method in methods {
        if failures.iter().any(|failure| failure.method == *method) {
            continue;
        }
        let hull = spatial_method(method)?.exact;
        let call = move |points: &Points<'_, 3>| {
            let _ = black_box(hull(black_box(*points)));
        };
        calls.push((method.clone(), call));
    }
    Ok(calls)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn certified_methods_are_sampled_and_the_base_twice() {
        let methods = ["quickhull-3d", "pivot-wrap"].map(str::to_owned);
        let block = Race {
            stage: "test",
            methods: &methods,
            base: "pivot-wrap",
            realisations: 2,
            points_a_batch: 100,
            rounds: 3,
        };
        let timed = race(1, "ball", 40, &block).expect("methods");
        // Batches of three sets, three contestants, each once a round on each batch.
        assert_eq!((timed.sets.len(), timed.failures.len()), (6, 0));
        assert_eq!(timed.times.len(), 3 * 2 * 3);
        let of = |name: &str| timed.times.iter().filter(|row| row.method == name).count();
        assert_eq!((of("pivot-wrap"), of(&twin("pivot-wrap"))), (6, 6));
    }
}
