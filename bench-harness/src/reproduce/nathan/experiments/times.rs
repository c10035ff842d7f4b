//! Times, interleaved and warm, of certified results only: a candidate's own corners tested or skipped (N-6), and the
//! registered methods beside each other.
//!
//! The first contestant of a cell takes part twice: its second entry shows the noise of a program against itself.

use super::own_corners::{BOTH, Trial, batches};
use crate::reproduce::data::product;
use crate::reproduce::nathan::definition::{Definition, Times};
use crate::reproduce::nathan::records::Records;
use crate::reproduce::nathan::sets;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::certify::certify;
use crate::reproduce::space::rows::TimeRow;
use crate::reproduce::space::sets::PointSet3;
use crate::reproduce::space::spatial_method;
use crate::reproduce::timing::{Contestant, Sample, interleave};
use anyhow::Result;
use geometry_core::Points;
use gift_wrap::nathan::OwnCorners;
use std::hint::black_box;

/// What the second entry of a contestant is called.
pub(crate) const TWIN: &str = "-twin";

/// A name, and what is timed under it.
type Call<T> = (String, Box<dyn Fn(&T)>);

/// Times the two ways with the own corners in every cell of the definition: the innermost loop in the paper's
/// arithmetic ("printed"), and the whole wrap with exact answers ("exact").
pub(crate) fn own_corners(definition: &Definition, records: &mut Records) -> Result<()> {
    each_cell("corners", &definition.corners, |distribution, n, block| {
        let inputs = batches(definition.seed, distribution, n, block, records)?;
        let calls: Vec<Call<Trial>> = block
            .contestants
            .iter()
            .flat_map(|kernel| BOTH.map(|own_corners| call(kernel, own_corners)))
            .collect();
        time(distribution, n, block, &inputs, &calls, records);
        Ok(())
    })
}

/// The name of a way with the own corners.
pub(crate) fn arm(kernel: &str, own_corners: OwnCorners) -> String {
    let own_corners = match own_corners {
        OwnCorners::Tested => "tested",
        OwnCorners::Skipped => "skipped",
    };
    format!("{own_corners}, {kernel}")
}

fn call(kernel: &str, own_corners: OwnCorners) -> Call<Trial> {
    let name = arm(kernel, own_corners);
    if kernel == "printed" {
        let call = move |trial: &Trial| {
            black_box(black_box(trial).accepted(own_corners));
        };
        return (name, Box::new(call));
    }
    let call = move |trial: &Trial| {
        let _ = black_box(black_box(trial).wrap_exactly(own_corners));
    };
    (name, Box::new(call))
}

/// Times registered methods in every cell of the definition.
pub(crate) fn methods(definition: &Definition, records: &mut Records) -> Result<()> {
    each_cell("times", &definition.times, |distribution, n, block| {
        let batch = block.points_a_batch.div_ceil(n as u64);
        let mut passed = block.contestants.clone();
        let mut inputs: Vec<Vec<PointSet3>> = Vec::new();
        for replicate in 0..block.realisations * batch {
            let set = sets::generate(definition.seed, distribution, n, replicate)?;
            let certified = certify("times", &set, &block.contestants)?;
            passed.retain(|method| certified.methods.contains(method));
            records.sets.push(certified.set);
            records.failures.extend(certified.failures);
            if replicate % batch == 0 {
                inputs.push(Vec::new());
            }
            if let Some(sets) = inputs.last_mut() {
                sets.push(set);
            }
        }
        let mut calls: Vec<Call<PointSet3>> = Vec::new();
        for method in passed {
            let hull = spatial_method(&method)?.exact;
            // Looking for coordinates that are not finite is a part of every method's time.
            let call = move |set: &PointSet3| {
                let _ = black_box(Points::new(black_box(&set.points)).and_then(hull));
            };
            calls.push((method, Box::new(call)));
        }
        time(distribution, n, block, &inputs, &calls, records);
        Ok(())
    })
}

fn each_cell(
    stage: &'static str,
    blocks: &[Times],
    mut work: impl FnMut(&str, usize, &Times) -> Result<()>,
) -> Result<()> {
    let cells = |block: &Times| product(&block.distributions, &block.n);
    let progress = Progress::start(stage, blocks.iter().map(|block| cells(block).len()).sum());
    for block in blocks {
        for (distribution, n) in cells(block) {
            work(&distribution, n, block)?;
            progress.finished(&format!("{distribution} {n}"));
        }
    }
    Ok(())
}

/// The samples of one cell.
fn time<T>(
    distribution: &str,
    n: usize,
    block: &Times,
    inputs: &[Vec<T>],
    calls: &[Call<T>],
    records: &mut Records,
) {
    let Some(first) = inputs.first() else { return };
    let mut contestants = Vec::new();
    for (name, call) in calls {
        let contestant = Contestant::warm(name, call, first);
        if contestants.is_empty() {
            contestants.push(contestant.twin(format!("{name}{TWIN}")));
        }
        contestants.push(contestant);
    }
    let samples = interleave(contestants, inputs, block.rounds, n as u64);
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
}
