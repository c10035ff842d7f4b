//! How the vertices of an answer differ from the extreme points, and how the difference is told.

use crate::engine::answer::Answer;

/// How the vertices of an answer differ from the extreme points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Difference {
    /// Extreme points that are no vertices of the answer, ascending.
    pub(super) misses: Vec<u32>,
    /// Vertices of the answer that are no extreme points, ascending.
    pub(super) extra: Vec<u32>,
}

/// How far outside an answer the furthest of the points that it misses lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Far {
    /// So far.
    Exactly(f64),
    /// So far is the furthest of those that were looked at; there were too many for all.
    AtLeast(f64),
}

impl Difference {
    pub(super) fn of(extreme: &[u32], answer: &Answer) -> Self {
        let mut extreme = extreme.to_vec();
        extreme.sort_unstable();
        let said = answer.vertices();
        let missing = |all: &[u32], from: &[u32]| {
            let missing = all.iter().filter(|id| from.binary_search(id).is_err());
            missing.copied().collect()
        };
        Self {
            misses: missing(&extreme, &said),
            extra: missing(&said, &extreme),
        }
    }

    pub(super) fn is_none(&self) -> bool {
        self.misses.is_empty() && self.extra.is_empty()
    }

    /// In words, for coordinates up to `largest`.
    pub(super) fn said(&self, far: Far, largest: f64) -> String {
        let mut parts = Vec::new();
        if !self.misses.is_empty() {
            let (least, far) = match far {
                Far::Exactly(far) => ("", far),
                Far::AtLeast(far) => ("at least ", far),
            };
            let units = far / unit(largest);
            parts.push(format!(
                "misses {} extreme points, the furthest {least}{far:.3e} outside, {units:.3e} units in the last place of {largest:.3e}",
                self.misses.len()
            ));
        }
        if !self.extra.is_empty() {
            parts.push(format!(
                "{} vertices are no extreme points",
                self.extra.len()
            ));
        }
        if parts.is_empty() {
            parts.push("the right vertices in a wrong order".to_owned());
        }
        parts.join("; ")
    }
}

/// The largest size of a coordinate.
pub(super) fn largest(coordinates: &[f64]) -> f64 {
    coordinates.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// The unit in the last place of `x`.
fn unit(x: f64) -> f64 {
    f64::from_bits(x.to_bits() + 1) - x
}
