//! What the experiments leave behind: plain rows, one CSV file a kind. Tables, figures and verdicts are
//! computed from these alone.

use super::definition::Arithmetic;
use crate::reproduce::space::rows::{CountRow, FailureRow, SetRow, TimeRow, text};
use serde::Serialize;

/// Everything recorded in one run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    /// Every set that was counted, timed or tried in the battery. Sets of the precision study are in its rows, by
    /// digest.
    pub(crate) sets: Vec<SetRow>,
    /// Day's cotangents, by format and eps2.
    pub(crate) precision: Vec<PrecisionRow>,
    /// The same points with exact orientations.
    pub(crate) controls: Vec<ControlRow>,
    /// Times of the formats.
    pub(crate) speed: Vec<SpeedRow>,
    /// Merges.
    pub(crate) merges: Vec<MergeRow>,
    /// Questions of the whole call.
    pub(crate) counts: Vec<CountRow>,
    /// Time samples of the whole call.
    pub(crate) times: Vec<TimeRow>,
    /// The battery of degenerate sets.
    pub(crate) battery: Vec<BatteryRow>,
    /// Results without a certificate.
    pub(crate) failures: Vec<FailureRow>,
}

/// How the sets of a cell end in one format at one eps2.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct PrecisionRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) range: f64,
    pub(crate) offset: f64,
    pub(crate) format: String,
    pub(crate) bits: u32,
    /// The power of ten of eps2.
    pub(crate) power: i32,
    pub(crate) sets: usize,
    pub(crate) right: usize,
    pub(crate) wrong: usize,
    pub(crate) endless: usize,
    pub(crate) dangling: usize,
    /// Over the fingerprints of the sets in order.
    pub(crate) digest: String,
}

/// The sets of a cell, rounded to one format, with exact orientations.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct ControlRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) range: f64,
    pub(crate) offset: f64,
    /// The format to which the coordinates were rounded.
    pub(crate) format: String,
    pub(crate) sets: usize,
    /// Sets whose hull is certified.
    pub(crate) right: usize,
    /// Sets that span space and have triangles only, as Day asks.
    pub(crate) general: usize,
}

/// One time sample of one format.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct SpeedRow {
    pub(crate) format: String,
    pub(crate) arithmetic: Arithmetic,
    pub(crate) n: usize,
    pub(crate) realisation: u64,
    pub(crate) round: u32,
    pub(crate) calls: u64,
    pub(crate) nanoseconds: u64,
}

/// All merges on the way to one certified hull, by one rule of search.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct MergeRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) variant: String,
    /// Comparisons of two candidates at the top merge.
    pub(crate) top_candidates: u64,
    /// Facets of the top merge's wrap.
    pub(crate) top_facets: u64,
    /// Vertices of the two hulls that the top merge joins.
    pub(crate) top_vertices: u64,
    /// Vertices of the hull.
    pub(crate) vertices: u64,
    /// Comparisons of two candidates in all merges.
    pub(crate) candidates: u64,
    /// Of these, in merges of at most 4, 8, 16 and 32 points.
    pub(crate) candidates_to_4: u64,
    pub(crate) candidates_to_8: u64,
    pub(crate) candidates_to_16: u64,
    pub(crate) candidates_to_32: u64,
    /// Candidates looked at again after a search had passed them.
    pub(crate) reexamined: u64,
    pub(crate) merges: u64,
    /// Edge records made, those in freed places too.
    pub(crate) edges_made: u64,
    /// The most in use after any merge.
    pub(crate) edges_most: u64,
    /// In use after the last merge: the edges of the hull, triangulated.
    pub(crate) edges_last: u64,
}

/// How one degenerate set ends.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct BatteryRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// What is degenerate; empty for sets in general position.
    pub(crate) what: String,
    /// A number format, or "exact".
    pub(crate) format: String,
    /// The power of ten of eps2; none for exact answers.
    pub(crate) power: Option<i32>,
    /// "right", "wrong", "endless" or "dangling"; of exact answers, "right" if certified.
    pub(crate) outcome: String,
    /// Of exact answers: orientations that the method asked for, as perturbed.
    pub(crate) asked: u64,
    /// Of exact answers: orientations and shadows that answering them took.
    pub(crate) answered: u64,
}

impl Records {
    /// Every file of records: its name, its text without the head, and how many rows it has.
    pub(crate) fn files(&self) -> Result<Vec<(&'static str, (String, usize))>, csv::Error> {
        Ok(vec![
            ("sets.csv", text(&self.sets)?),
            ("precision.csv", text(&self.precision)?),
            ("controls.csv", text(&self.controls)?),
            ("speed.csv", text(&self.speed)?),
            ("merges.csv", text(&self.merges)?),
            ("counts.csv", text(&self.counts)?),
            ("times.csv", text(&self.times)?),
            ("battery.csv", text(&self.battery)?),
            ("failures.csv", text(&self.failures)?),
        ])
    }
}
