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
    /// The merges of divide and conquer, one by one.
    pub(crate) merges: Vec<Cells>,
    /// Good and bad orders of insertion.
    pub(crate) orders: Orders,
    /// The rule for the direction of an angle.
    pub(crate) angles: Vec<Cells>,
}

/// A set whose order as given is bad, inserted in that order and in random order.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Orders {
    pub(crate) distribution: String,
    pub(crate) n: Vec<usize>,
    /// Random orders for each n.
    pub(crate) replicates: u64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::balan::SLUG;
    use crate::reproduce::data::{EXTENTS, studies};
    use std::str::FromStr;

    #[test]
    fn both_extents_name_sets_of_space_only() {
        for extent in EXTENTS {
            let studies: Studies = studies(SLUG, extent).expect("valid");
            let blocks = studies.angles.iter().chain(&studies.merges);
            let names = blocks.flat_map(|block| &block.distributions);
            for name in names.chain([&studies.orders.distribution]) {
                let spec = point_sets::Spec::from_str(name).expect("a distribution");
                assert_eq!(spec.dimension(), 3, "{name}");
            }
        }
    }
}
