//! What the studies of this paper leave behind, beside the rows of every paper.

use crate::reproduce::rows::{Files, Tables};
use anyhow::Result;
use serde::Serialize;

/// Everything recorded of this paper.
pub(crate) type Records = crate::reproduce::rows::Records<Studied>;

/// The rows of the studies.
#[derive(Clone, Debug, Default)]
pub(crate) struct Studied {
    /// Complete peelings.
    pub(crate) peels: Vec<PeelRow>,
    /// Peelings and hulls with a tolerance.
    pub(crate) tolerance: Vec<ToleranceRow>,
    /// Peelings of the exact lattices under both conventions.
    pub(crate) rings: Vec<RingRow>,
}

impl Tables for Studied {
    fn write(&self, files: &mut Files) -> Result<()> {
        files.add("peels", &self.peels)?;
        files.add("tolerance", &self.tolerance)?;
        files.add("rings", &self.rings)
    }
}

/// One complete peeling of one set by Green and Silverman's method with exact answers, certified.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct PeelRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    pub(crate) layers: usize,
    /// Points on the largest peel.
    pub(crate) largest: usize,
    /// Sum over the peels of the points left before each.
    pub(crate) remaining: u64,
    pub(crate) visits: u64,
    pub(crate) orientations: u64,
    pub(crate) questions: u64,
    /// High-water mark of the stack, the paper's m.
    pub(crate) storage: u64,
}

/// The sweep of the tolerance over one set in one format.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct ToleranceRow {
    /// "random"; "lattice", turned about the origin; "lattice-fitted", turned and fitted into the unit square;
    /// "lattice-eddy", the first hull of a turned lattice by Eddy's method.
    pub(crate) data: String,
    pub(crate) format: String,
    /// Decimals of the coordinates; empty for all that a double holds.
    pub(crate) decimals: Option<u32>,
    pub(crate) replicate: u64,
    pub(crate) fingerprint: String,
    /// One letter for each ε = 1e-1, 1e-2, …: `r` right, `w` wrong, `c` stopped by a contradiction.
    pub(crate) outcomes: String,
}

/// The rings of a lattice, peeled with exact answers.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct RingRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    /// "all" or "extreme".
    pub(crate) boundary: String,
    pub(crate) method: String,
    /// Points on the rings from the outside in, separated by spaces.
    pub(crate) rings: String,
    pub(crate) certified: bool,
}
