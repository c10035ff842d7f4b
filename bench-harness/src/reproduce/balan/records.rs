//! What the studies of this paper leave behind, beside the rows of every paper.

use crate::reproduce::rows::{Files, Tables};
use anyhow::Result;
use serde::Serialize;

/// Everything recorded of this paper.
pub(crate) type Records = crate::reproduce::rows::Records<Studied>;

/// The rows of the studies.
#[derive(Clone, Debug, Default)]
pub(crate) struct Studied {
    /// Work of divide and conquer by merge.
    pub(crate) merges: Vec<MergeRow>,
    /// Choices by angle.
    pub(crate) angles: Vec<AngleRow>,
}

impl Tables for Studied {
    fn write(&self, files: &mut Files) -> Result<()> {
        files.add("merges", &self.merges)?;
        files.add("angles", &self.angles)
    }
}

/// The merges of one run of divide and conquer.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct MergeRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// The method that merges so.
    pub(crate) method: String,
    /// Facets between the two hulls of the top merge.
    pub(crate) top_facets: u64,
    /// Comparisons of candidates in the top merge.
    pub(crate) top_candidates: u64,
    /// The same in all merges.
    pub(crate) all_candidates: u64,
}

/// One merge, its steps repeated with several rules for the angle.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct AngleRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// Facets between the two hulls: so many times a next point is chosen.
    pub(crate) steps: u64,
    /// Candidates for all of these.
    pub(crate) candidates: u64,
    /// Candidates whose direction the sign of the cosine tells right.
    pub(crate) directions_right: u64,
    /// Steps with two candidates or more at an obtuse angle.
    pub(crate) ambiguous: u64,
    /// Steps at which the printed rule chooses the right point: both normals from corners in the same order.
    pub(crate) printed: u64,
    /// The same with both normals pointing outwards.
    pub(crate) printed_outward: u64,
    /// The same with the angle in 0 to 180 as it is, the rule left out.
    pub(crate) unsigned: u64,
    /// The same with the sign of the triple product in place of that of the cosine.
    pub(crate) triple: u64,
    /// The same with exact orientations: the control.
    pub(crate) exact: u64,
}
