//! What the studies of this paper leave behind, beside the rows of every paper.

use crate::reproduce::rows::{Files, Tables};
use anyhow::Result;
use serde::Serialize;

/// Everything recorded of this paper.
pub(crate) type Records = crate::reproduce::rows::Records<Studied>;

/// The rows of the studies.
#[derive(Clone, Debug, Default)]
pub(crate) struct Studied {
    /// Wraps, certified.
    pub(crate) wraps: Vec<WrapRow>,
    /// First points.
    pub(crate) starts: Vec<StartRow>,
    /// Runs with the paper's epsilon, and with exact answers.
    pub(crate) epsilon: Vec<EpsilonRow>,
    /// Triangulations by lifting.
    pub(crate) lifting: Vec<LiftRow>,
    /// Cells of grids.
    pub(crate) grids: Vec<GridRow>,
    /// The moving box.
    pub(crate) sweep: Vec<SweepRow>,
}

impl Tables for Studied {
    fn write(&self, files: &mut Files) -> Result<()> {
        files.add("wraps", &self.wraps)?;
        files.add("starts", &self.starts)?;
        files.add("epsilon", &self.epsilon)?;
        files.add("lifting", &self.lifting)?;
        files.add("grids", &self.grids)?;
        files.add("sweep", &self.sweep)
    }
}

/// What one certified wrap of one set did. Exact integers, equal on every machine.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct WrapRow {
    pub(crate) distribution: String,
    /// "random" or "inside-out".
    pub(crate) order: String,
    pub(crate) n: usize,
    pub(crate) replicate: u64,
    /// "printed", "corrected" or "pivot-wrap".
    pub(crate) variant: String,
    /// Vertices of the certified hull.
    pub(crate) h: usize,
    /// Triangles accepted, repetitions included.
    pub(crate) triangles: usize,
    /// Triangles accepted before.
    pub(crate) repetitions: usize,
    /// Edges for which candidates were tried.
    pub(crate) searches: u64,
    /// Tests of a flattened point against an edge, to find the first edge.
    pub(crate) edge_tests: u64,
    /// Tests of a point against a plane; of pivot-wrap those after the dimension of the set was known.
    pub(crate) plane_tests: u64,
    /// Edges compared to find out whether an edge was there before.
    pub(crate) mark_comparisons: u64,
}

impl WrapRow {
    /// Tests over n h.
    pub(crate) fn over_nh(&self) -> f64 {
        self.plane_tests as f64 / (self.n as f64 * self.h as f64)
    }

    /// Passes through the points a search takes.
    pub(crate) fn passes(&self) -> f64 {
        self.plane_tests as f64 / (self.n as f64 * self.searches as f64)
    }
}

/// How often a way to choose the first point chose one that is not on the hull of the flattened points.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct StartRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) offset: f64,
    /// "furthest", "nearest" or "lexicographic".
    pub(crate) start: String,
    pub(crate) sets: usize,
    pub(crate) off_hull: usize,
    /// SHA-256, shortened, over the fingerprints of all sets in order.
    pub(crate) digest: String,
}

/// How often a way to compare wraps a set right.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct EpsilonRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) offset: f64,
    /// "epsilon", as printed, or "exact".
    pub(crate) arithmetic: String,
    /// "tested" or "skipped".
    pub(crate) own_corners: String,
    pub(crate) sets: usize,
    pub(crate) wrong: usize,
    pub(crate) digest: String,
}

/// Triangulations of the sets of one cell.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct LiftRow {
    pub(crate) distribution: String,
    pub(crate) n: usize,
    pub(crate) offset: f64,
    pub(crate) sets: usize,
    /// Sets whose triangulation without computed heights is certified.
    pub(crate) exact_right: usize,
    /// Sets whose triangulation by heights computed in doubles is certified.
    pub(crate) rounded_right: usize,
    /// Pairs of neighbouring triangles of the certified triangulations.
    pub(crate) quadruples: u64,
    /// Those whose four points, lifted to computed heights, have an orientation that is not theirs.
    pub(crate) wrong_signs: u64,
    pub(crate) digest: String,
}

/// The cells of one grid.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct GridRow {
    pub(crate) spacing: f64,
    pub(crate) offset: f64,
    /// Cells whose four corners, as doubles, lie on one circle.
    pub(crate) cocircular: u64,
    /// Those whose lifts to computed heights do not lie in one plane.
    pub(crate) wrong_signs: u64,
}

/// What a check for obstacles found.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct SweepRow {
    /// "example" or "random".
    pub(crate) obstacle: String,
    /// Steps of the moving box; none for the check against the hull.
    pub(crate) steps: Option<u32>,
    /// Obstacles that the box meets on its way.
    pub(crate) obstacles: usize,
    pub(crate) missed: usize,
}
