//! What the studies of this paper leave behind, beside the rows of every paper.

use super::definition::Arithmetic;
use crate::reproduce::rows::{Files, Tables};
use anyhow::Result;
use serde::Serialize;

/// Everything recorded of this paper.
pub(crate) type Records = crate::reproduce::rows::Records<Studied>;

/// The rows of the studies.
#[derive(Clone, Debug, Default)]
pub(crate) struct Studied {
    /// Day's cotangents, by format and eps2.
    pub(crate) precision: Vec<PrecisionRow>,
    /// The same points with exact orientations.
    pub(crate) controls: Vec<ControlRow>,
    /// Times of the formats.
    pub(crate) speed: Vec<SpeedRow>,
    /// Merges.
    pub(crate) merges: Vec<MergeRow>,
    /// The battery of degenerate sets.
    pub(crate) battery: Vec<BatteryRow>,
    /// Sizes at which the recursion could stop.
    pub(crate) bases: Vec<BaseRow>,
    /// Sets with dummy points.
    pub(crate) dummies: Vec<DummyRow>,
    /// Faces listed.
    pub(crate) listings: Vec<ListingRow>,
    /// Hulls given to the paper's own check.
    pub(crate) checks: Vec<CheckRow>,
    /// The halves conquered side by side.
    pub(crate) parallel: Vec<ParallelRow>,
}

impl Tables for Studied {
    fn write(&self, files: &mut Files) -> Result<()> {
        files.add("precision", &self.precision)?;
        files.add("controls", &self.controls)?;
        files.add("speed", &self.speed)?;
        files.add("merges", &self.merges)?;
        files.add("battery", &self.battery)?;
        files.add("bases", &self.bases)?;
        files.add("dummies", &self.dummies)?;
        files.add("listings", &self.listings)?;
        files.add("checks", &self.checks)?;
        files.add("parallel", &self.parallel)
    }
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
    /// Vertices of the hull.
    pub(crate) vertices: u64,
    /// Comparisons of two candidates in all merges.
    pub(crate) candidates: u64,
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
    /// "right", "wrong hull", "endless" or "dangling"; of exact answers, "right" if all methods give the certified hull.
    pub(crate) outcome: String,
    /// Of exact answers, once the dimension is known: questions of every kind, and orientations among them that vanish.
    pub(crate) questions: u64,
    pub(crate) vanished: u64,
}

/// Orientations it would take to stop the recursion at some size, and solve the parts in some way.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct BaseRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// Points of a part.
    pub(crate) size: usize,
    /// "none" (single points), "tetrahedron", "gift wrapping" or "every triple".
    pub(crate) way: String,
    /// Orientations for all the parts.
    pub(crate) base: u64,
    /// Comparisons of candidates, one orientation each, in the merges above.
    pub(crate) merges: u64,
}

impl BaseRow {
    /// Orientations in all.
    pub(crate) fn total(&self) -> u64 {
        self.base + self.merges
    }
}

/// How sets that need dummy points end.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct DummyRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) format: String,
    pub(crate) power: i32,
    pub(crate) sets: usize,
    pub(crate) right: usize,
    /// Over the fingerprints of the sets in order.
    pub(crate) digest: String,
}

/// The faces of one certified hull, listed by the spiral and plainly.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct ListingRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// Triangles of the hull.
    pub(crate) faces: usize,
    /// Listed by the spiral, repetitions included.
    pub(crate) listed: usize,
    /// Faces that only one of the two lists has.
    pub(crate) only_one: usize,
    /// Whether the spiral's faces are the surface of the certified hull.
    pub(crate) is_hull: bool,
    /// Pairs of faces, one listed after the other, that share an edge.
    pub(crate) neighbours: usize,
    /// Calls within each other of the paper's recursive procedure.
    pub(crate) deepest: usize,
}

/// What the paper's check says of hulls that are known to be right or wrong.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct CheckRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    /// The format in which the hulls were made.
    pub(crate) made_in: String,
    pub(crate) power: i32,
    /// A format, or "exact".
    pub(crate) checked_in: String,
    pub(crate) right_accepted: usize,
    pub(crate) right_rejected: usize,
    pub(crate) wrong_accepted: usize,
    pub(crate) wrong_rejected: usize,
    /// Right hulls with one face left out that are accepted.
    pub(crate) holed_accepted: usize,
    pub(crate) digest: String,
}

/// The same set by one processor after another and by all of them.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct ParallelRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// Whether both results are the certified hull.
    pub(crate) same_hull: bool,
    /// Questions of every kind.
    pub(crate) sequential: u64,
    pub(crate) parallel: u64,
}
