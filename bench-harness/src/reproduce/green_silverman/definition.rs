//! What the studies of this paper run on, read from its `studies.toml`.

use crate::reproduce::data::Cells;
use serde::Deserialize;

/// What is run: which sets, which methods, how often.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Studies {
    /// The seed from which every set's seed is derived.
    pub(crate) seed: u64,
    /// What a reader should know of this choice.
    pub(crate) analysis: String,
    /// Complete peelings.
    #[serde(default)]
    pub(crate) peels: Vec<Cells>,
    /// Table 1.
    pub(crate) tolerance: Tolerance,
}

/// The sweep of the tolerance.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Tolerance {
    /// Sets of each kind.
    pub(crate) sets: u64,
    /// The sweep runs over 1e-1, 1e-2, … down to ten to the minus this.
    pub(crate) smallest_exponent: u32,
    /// Number formats by name.
    pub(crate) formats: Vec<String>,
    /// The random data of Figure 1.
    pub(crate) random: RandomData,
    /// The lattice data of Figure 2.
    pub(crate) lattice: LatticeData,
    /// An oblique lattice whose coordinates are exact in `f64`: the control.
    pub(crate) exact_lattice: RandomData,
}

/// A named distribution and a size.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RandomData {
    pub(crate) distribution: String,
    pub(crate) n: usize,
}

/// A randomly turned lattice, and the same lattice before it is turned, whose layers are the intended answer.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LatticeData {
    pub(crate) distribution: String,
    pub(crate) plain: String,
    pub(crate) n: usize,
    /// Decimals to which the coordinates are rounded in further runs.
    pub(crate) decimals: Vec<u32>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::data::{EXTENTS, studies};
    use crate::reproduce::green_silverman::SLUG;
    use std::str::FromStr;

    #[test]
    fn both_extents_name_known_sets_only() {
        for extent in EXTENTS {
            let studies: Studies = studies(SLUG, extent).expect("valid");
            for spec in studies.peels.iter().flat_map(|block| &block.distributions) {
                assert!(point_sets::Spec::from_str(spec).is_ok(), "{spec:?}");
            }
        }
    }
}
