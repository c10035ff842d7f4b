//! A candidate's own corners tested or skipped, on the clock: times interleaved and warm, of certified results only (N-6).
//!
//! The first contestant of a cell takes part twice: its second entry shows the noise of a program against itself.

use super::own_corners::{BOTH, Trial, batches};
use crate::records::rows::twin;
use crate::reproduce::data::product;
use crate::reproduce::nathan::definition::{Corners, Studies};
use crate::reproduce::nathan::records::Records;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::TimeRow;
use crate::reproduce::timing::{Contestant, Sample, interleave};
use anyhow::Result;
use gift_wrap::nathan::OwnCorners;
use std::hint::black_box;

/// A name, and what is timed under it.
type Call = (String, Box<dyn Fn(&Trial)>);

/// Times the two ways in every cell: the innermost loop in the paper's arithmetic ("printed"), and the whole wrap with
/// exact answers ("exact").
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let cells = |block: &Corners| product(&block.distributions, &block.n);
    let all = studies.corners.iter().map(|block| cells(block).len());
    let progress = Progress::start("corners", all.sum());
    for block in &studies.corners {
        for (distribution, n) in cells(block) {
            let inputs = batches(studies.seed, &distribution, n, block, records)?;
            let kernels = block.contestants.iter();
            let calls =
                kernels.flat_map(|kernel| BOTH.map(|own_corners| call(kernel, own_corners)));
            let calls: Vec<Call> = calls.collect();
            let samples = time(block, &inputs, &calls, n as u64);
            let row = |sample: Sample| TimeRow {
                distribution: distribution.clone(),
                n,
                realisation: sample.realisation,
                round: sample.round,
                method: sample.name,
                calls: sample.calls,
                nanoseconds: sample.nanoseconds,
            };
            records.times.extend(samples.into_iter().map(row));
            progress.finished(&format!("{distribution} {n}"));
        }
    }
    Ok(())
}

/// The samples of one cell.
fn time(block: &Corners, inputs: &[Vec<Trial>], calls: &[Call], seed: u64) -> Vec<Sample> {
    let Some(first) = inputs.first() else {
        return Vec::new();
    };
    let mut contestants = Vec::new();
    for (name, call) in calls {
        let contestant = Contestant::warm(name, call, first);
        if contestants.is_empty() {
            contestants.push(contestant.twin(twin(name)));
        }
        contestants.push(contestant);
    }
    interleave(contestants, inputs, block.rounds, seed)
}

/// The name of a way with the own corners.
pub(crate) fn arm(kernel: &str, own_corners: OwnCorners) -> String {
    let own_corners = match own_corners {
        OwnCorners::Tested => "tested",
        OwnCorners::Skipped => "skipped",
    };
    format!("{own_corners}, {kernel}")
}

fn call(kernel: &str, own_corners: OwnCorners) -> Call {
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
