//! The convex layers of a planar point set: its hull, the hull of the rest, and so on inwards.

use crate::hull2::Hull2;

/// The convex layers ("peels") of a planar point set.
///
/// Canonical, like [`Hull2`]. A layer is the hull of all points that no earlier layer removed; it removes its
/// vertices and all copies of them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layers {
    rings: Vec<Hull2>,
    stages: Vec<u32>,
}

impl Layers {
    /// The layers `rings`, outermost first, where `stages[id]` is the 1-based number of the ring that removed
    /// point `id`.
    pub fn new(rings: Vec<Hull2>, stages: Vec<u32>) -> Self {
        Self { rings, stages }
    }

    /// The layers, outermost first.
    pub fn rings(&self) -> &[Hull2] {
        &self.rings
    }

    /// The number of layers.
    pub fn len(&self) -> usize {
        self.rings.len()
    }

    /// Whether there is no layer: the layers of no points.
    pub fn is_empty(&self) -> bool {
        self.rings.is_empty()
    }

    /// The c-rank of every point: the stage at which it is peeled, 1 for the outermost layer (Barnett 1976,
    /// as Green and Silverman use it).
    pub fn c_ranks(&self) -> &[u32] {
        &self.stages
    }

    /// The rank of every point from the outside in, from 1 to n, points of one layer sharing the mean of
    /// their places: the c-ranks on the scale of univariate mid-ranks.
    pub fn mid_ranks(&self) -> Vec<f64> {
        let mut sizes = vec![0_usize; self.rings.len()];
        for &stage in &self.stages {
            sizes[stage as usize - 1] += 1;
        }
        let mut before = 0;
        let ranks: Vec<f64> = sizes
            .iter()
            .map(|&size| {
                let rank = before as f64 + (size as f64 + 1.0) / 2.0;
                before += size;
                rank
            })
            .collect();
        self.stages
            .iter()
            .map(|&stage| ranks[stage as usize - 1])
            .collect()
    }
}
