//! What the experiments leave behind: plain rows, one CSV file a kind. Tables, figures and verdicts are
//! computed from these alone.

use crate::reproduce::space::rows::{CountRow, FailureRow, SetRow, TimeRow, text};
use anyhow::Result;
use serde::Serialize;

/// Everything recorded in one run.
#[derive(Clone, Debug, Default)]
pub(crate) struct Records {
    /// Every set that was counted or timed.
    pub(crate) sets: Vec<SetRow>,
    /// Questions asked and facets made.
    pub(crate) counts: Vec<CountRow>,
    /// Work of divide and conquer by merge.
    pub(crate) merges: Vec<MergeRow>,
    /// Choices by angle.
    pub(crate) angles: Vec<AngleRow>,
    /// Time samples.
    pub(crate) times: Vec<TimeRow>,
    /// Results without a certificate.
    pub(crate) failures: Vec<FailureRow>,
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

impl Records {
    /// Every file: its name, its text, its number of rows.
    pub(crate) fn files(&self) -> Result<Vec<(&'static str, String, usize)>> {
        let files = [
            ("sets.csv", text(&self.sets)?),
            ("counts.csv", text(&self.counts)?),
            ("merges.csv", text(&self.merges)?),
            ("angles.csv", text(&self.angles)?),
            ("times.csv", text(&self.times)?),
            ("failures.csv", text(&self.failures)?),
        ];
        Ok(files
            .into_iter()
            .map(|(name, (text, rows))| (name, text, rows))
            .collect())
    }
}
