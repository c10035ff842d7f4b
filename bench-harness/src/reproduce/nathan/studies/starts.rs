//! Whether the first point is on the hull of the flattened points (N-4).
//!
//! Step 2 finds an edge from the first point exactly if it is: with exact answers about points in general position
//! the line to its neighbour on the outline has all points on one side, and no line through an inner point has.

use crate::reproduce::data::product;
use crate::reproduce::nathan::definition::Studies;
use crate::reproduce::nathan::records::{Records, StartRow};
use crate::reproduce::nathan::sets;
use crate::reproduce::progress::Progress;
use anyhow::Result;
use geometry_core::{Exact, Perturbed, Points, Silent};
use gift_wrap::nathan::{Ending, NathanOptions, Start, study};

/// The ways to choose, by name.
const STARTS: [(&str, Start); 3] = [
    ("furthest", Start::Furthest),
    ("nearest", Start::Nearest),
    ("lexicographic", Start::Lexicographic),
];

/// Tries every way to choose on every set of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let block = &studies.starts;
    let cells = product(&block.distributions, &[block.n]);
    let progress = Progress::start("starts", cells.len());
    for (distribution, n) in cells {
        for &offset in &block.offsets {
            let cell = (distribution.as_str(), n, block.sets);
            let (tried, digest) = sets::each_moved(studies.seed, cell, offset, |set| {
                let points = Points::new(&set.points)?;
                Ok(STARTS.map(|(_, start)| is_off_hull(points, start)))
            })?;
            for (place, (name, _)) in STARTS.iter().enumerate() {
                records.own.starts.push(StartRow {
                    distribution: distribution.clone(),
                    n,
                    offset,
                    start: (*name).to_owned(),
                    sets: tried.len(),
                    off_hull: tried.iter().filter(|off| off[place]).count(),
                    digest: digest.clone(),
                });
            }
        }
        progress.finished(&distribution);
    }
    Ok(())
}

fn is_off_hull(points: Points<'_, 3>, start: Start) -> bool {
    let options = NathanOptions {
        start,
        ..NathanOptions::CORRECTED
    };
    let run = study(points, options, &Perturbed(Exact), &mut Silent);
    run.ending == Ending::NoFirstEdge
}
