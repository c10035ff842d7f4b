//! Times, interleaved and warm, of certified results only: the table that the paper does not print (B-7).
//!
//! `quickhull-3d` takes part twice: its second entry shows the noise of a program against itself. A realisation of
//! small n is a batch of different sets.

use crate::reproduce::balan::definition::{Definition, Times};
use crate::reproduce::balan::records::Records;
use crate::reproduce::data::product;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::certify::certify;
use crate::reproduce::space::rows::TimeRow;
use crate::reproduce::space::sets::PointSet3;
use crate::reproduce::space::spatial_method;
use crate::reproduce::timing::{Contestant, Sample, interleave};
use anyhow::Result;
use geometry_core::{HullError, Point3, Points};
use std::hint::black_box;

/// The method to which others are compared.
pub(crate) const BASE: &str = "quickhull-3d";

/// The name under which it takes part a second time.
pub(crate) const TWIN: &str = "quickhull-3d-twin";

/// The name of this experiment in the records.
pub(crate) const STAGE: &str = "times";

/// Times every cell of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let cells = |block: &Times| product(&block.distributions, &block.n);
    let all = definition
        .times
        .iter()
        .map(|block| cells(block).len())
        .sum();
    let progress = Progress::start(STAGE, all);
    for block in &definition.times {
        for (distribution, n) in cells(block) {
            cell(definition.seed, &distribution, n, block, records)?;
            progress.finished(&format!("{distribution} {n}"));
        }
    }
    Ok(())
}

fn cell(
    seed: u64,
    distribution: &str,
    n: usize,
    block: &Times,
    records: &mut Records,
) -> Result<()> {
    let realisations = realisations(seed, distribution, n, block, records)?;
    let views: Result<Vec<Vec<Points<'_, 3>>>, HullError> = realisations
        .iter()
        .map(|sets| sets.iter().map(|set| Points::new(set)).collect())
        .collect();
    let views = views?;
    let Some(first) = views.first() else {
        return Ok(());
    };
    let calls = certified_calls(distribution, n, block, records)?;
    let mut contestants = Vec::new();
    for (name, call) in &calls {
        let contestant = Contestant::warm(name, call, first);
        contestants.extend((name == BASE).then(|| contestant.twin(TWIN)));
        contestants.push(contestant);
    }
    let samples = interleave(contestants, &views, block.rounds, seed ^ n as u64);
    let row = |sample: Sample| TimeRow {
        distribution: distribution.to_owned(),
        n,
        realisation: sample.realisation,
        round: sample.round,
        method: sample.name,
        calls: sample.calls,
        nanoseconds: sample.nanoseconds,
    };
    records.times.extend(samples.into_iter().map(row));
    Ok(())
}

/// The batches of sets of a cell, every result on them certified.
fn realisations(
    seed: u64,
    distribution: &str,
    n: usize,
    block: &Times,
    records: &mut Records,
) -> Result<Vec<Vec<Vec<Point3>>>> {
    let batch = block.points_a_batch.div_ceil(n as u64);
    let replicates: Vec<u64> = (0..block.realisations * batch).collect();
    let certified = parallel::map(&replicates, |&replicate| {
        let set = PointSet3::generate(seed, distribution, n, replicate)?;
        let certified = certify(STAGE, &set, &block.methods)?;
        Ok((set.points, certified))
    })?;
    let mut realisations: Vec<Vec<Vec<Point3>>> = Vec::new();
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

/// A call of each method that is certified on every set of the cell.
fn certified_calls(
    distribution: &str,
    n: usize,
    block: &Times,
    records: &Records,
) -> Result<Vec<(String, impl Fn(&Points<'_, 3>) + use<>)>> {
    let mut calls = Vec::new();
    for method in &block.methods {
        if records.failed(distribution, n, method) {
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
