//! What the studies of this paper run on, read from its `studies.toml`.

use serde::Deserialize;

/// What is run: which sets, how often.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Studies {
    /// The seed from which every set's seed is derived.
    pub(crate) seed: u64,
    /// What a reader should know of this choice.
    pub(crate) analysis: String,
    /// What wrapping asks (N-1, N-2, N-3).
    pub(crate) wraps: Vec<Wraps>,
    /// Which first points are on the hull (N-4).
    pub(crate) starts: Shifted,
    /// What the paper's epsilon does (N-5).
    pub(crate) epsilon: Shifted,
    /// The candidate's own corners, tested or skipped (N-6).
    pub(crate) corners: Vec<Corners>,
    /// Lifts, rounded and not (N-7).
    pub(crate) lifting: Vec<Shifted>,
    /// Cells of square grids, lifted (N-7).
    pub(crate) grids: Grids,
    /// The triangulation of Figure 1.
    pub(crate) figure1: Cell,
    /// The moving box (N-8).
    pub(crate) sweep: Sweep,
}

/// A block of cells that are wrapped.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Wraps {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) order: Order,
    pub(crate) variants: Vec<Variant>,
    pub(crate) replicates: u64,
}

/// The order of the points in the array.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Order {
    /// As drawn: independent points are in random order.
    Random,
    /// By distance from the origin, the nearest first: what refutes a candidate comes last.
    InsideOut,
}

impl Order {
    /// As in the records.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Order::Random => "random",
            Order::InsideOut => "inside-out",
        }
    }
}

/// A way to wrap.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Variant {
    /// The paper to the letter, but for exact answers.
    Printed,
    /// The registered method.
    Corrected,
    /// One pass a search.
    PivotWrap,
}

impl Variant {
    /// As in the records.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Variant::Printed => "printed",
            Variant::Corrected => "corrected",
            Variant::PivotWrap => "pivot-wrap",
        }
    }
}

/// Sets of one size at several distances from the origin.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Shifted {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: usize,
    /// What is added to every coordinate.
    pub(crate) offsets: Vec<f64>,
    pub(crate) sets: u64,
}

/// A block of cells that are timed. A cell is in one block only.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Corners {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    /// "printed" and "exact".
    pub(crate) contestants: Vec<String>,
    /// Batches of sets.
    pub(crate) realisations: u64,
    /// A batch holds different sets of at least so many points in all.
    pub(crate) points_a_batch: u64,
    pub(crate) rounds: u32,
}

/// Square grids, the points `offset` + `spacing` · (i, j) as doubles.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Grids {
    /// Cells along a side.
    pub(crate) side: u32,
    /// (spacing, offset) of each grid.
    pub(crate) grids: Vec<[f64; 2]>,
}

/// A named distribution and a size.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cell {
    pub(crate) distribution: String,
    pub(crate) n: usize,
}

/// A box with one corner at the origin that moves.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sweep {
    /// Its sides.
    pub(crate) sides: [f64; 3],
    /// The move.
    pub(crate) by: [f64; 3],
    /// The obstacle of the worked example.
    pub(crate) obstacle: [f64; 3],
    /// How many steps are tried.
    pub(crate) steps: Vec<u32>,
    /// Random obstacles.
    pub(crate) obstacles: usize,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::data::{EXTENTS, studies};
    use crate::reproduce::nathan::SLUG;
    use crate::reproduce::nathan::sets;

    #[test]
    fn both_extents_name_known_things_only() {
        for extent in EXTENTS {
            let studies: Studies = studies(SLUG, extent).expect("valid");
            for kernel in studies.corners.iter().flat_map(|b| &b.contestants) {
                assert!(["printed", "exact"].contains(&kernel.as_str()));
            }
            let wraps = studies.wraps.iter().flat_map(|b| &b.distributions);
            let shifted = [&studies.starts, &studies.epsilon];
            let shifted = shifted.into_iter().flat_map(|b| &b.distributions);
            for name in wraps.chain(shifted) {
                assert!(sets::generate(1, name, 27, 0).is_ok(), "no set {name:?}");
            }
            let planar = studies.lifting.iter().flat_map(|b| &b.distributions);
            for name in planar.chain([&studies.figure1.distribution]) {
                assert!(sets::generate_planar(1, name, 9, 0, 0.0).is_ok());
            }
        }
    }
}
