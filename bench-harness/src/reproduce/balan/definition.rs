//! The definition of the experiment, read from `data/definitions/`.

use crate::reproduce::data::{in_checkout_or, product};
use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Where the paper's files lie below `data/definitions` and `data/published`.
pub(crate) const PAPER: &str = "balan-munjal-rao";

/// What is run: which sets, which methods, how often.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Definition {
    /// The paper's short name.
    pub(crate) paper: String,
    /// The seed from which every set's seed is derived.
    pub(crate) seed: u64,
    /// What a reader should know of this choice.
    pub(crate) analysis: String,
    /// Questions asked and facets made.
    pub(crate) counts: Vec<Counts>,
    /// The merges of divide and conquer, one by one.
    pub(crate) merges: Vec<Cells>,
    /// Good and bad orders of insertion.
    pub(crate) orders: Orders,
    /// The rule for the direction of an angle.
    pub(crate) angles: Vec<Cells>,
    /// Times.
    pub(crate) times: Vec<Times>,
}

/// A block of cells in which methods are counted. Blocks may overlap: a cell gets the most replicates asked for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Counts {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) methods: Vec<String>,
    pub(crate) replicates: u64,
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

/// A block of cells.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cells {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) replicates: u64,
}

/// A block of cells in which methods are timed. A cell is in one block only.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Times {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) methods: Vec<String>,
    /// Batches of sets.
    pub(crate) realisations: u64,
    /// A batch holds different sets of at least so many points in all.
    pub(crate) points_a_batch: u64,
    pub(crate) rounds: u32,
}

impl Cells {
    /// Each set of the block: distribution, size, replicate.
    pub(crate) fn sets(&self) -> impl Iterator<Item = (String, usize, u64)> {
        let replicates = self.replicates;
        let cells = product(&self.distributions, &self.n).into_iter();
        cells.flat_map(move |(distribution, n)| {
            (0..replicates).map(move |replicate| (distribution.clone(), n, replicate))
        })
    }
}

impl Definition {
    /// The reference run or the quick one: the checkout's file if the program runs in one, else the copy
    /// built into the program.
    pub(crate) fn load(quick: bool) -> Result<Self> {
        let (name, built_in) = if quick {
            (
                "quick.toml",
                include_str!("../../../../data/definitions/balan-munjal-rao/quick.toml"),
            )
        } else {
            (
                "full.toml",
                include_str!("../../../../data/definitions/balan-munjal-rao/full.toml"),
            )
        };
        let text = in_checkout_or(&format!("data/definitions/{PAPER}/{name}"), built_in)?;
        let definition: Self = toml::from_str(&text).with_context(|| format!("in {name}"))?;
        ensure!(
            definition.paper == PAPER,
            "{name} is for the paper {:?}",
            definition.paper
        );
        Ok(definition)
    }

    /// Every cell to be counted, with the number of replicates of each method.
    pub(crate) fn counted_cells(&self) -> BTreeMap<(String, usize), BTreeMap<String, u64>> {
        let mut cells: BTreeMap<(String, usize), BTreeMap<String, u64>> = BTreeMap::new();
        for block in &self.counts {
            for cell in product(&block.distributions, &block.n) {
                let methods = cells.entry(cell).or_default();
                for method in &block.methods {
                    let replicates = methods.entry(method.clone()).or_default();
                    *replicates = block.replicates.max(*replicates);
                }
            }
        }
        cells
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::space::spatial_method;
    use std::str::FromStr;

    #[test]
    fn both_definitions_name_known_things_only() {
        for quick in [false, true] {
            let definition = Definition::load(quick).expect("valid");
            let methods = definition.counts.iter().map(|block| &block.methods);
            for method in methods
                .chain(definition.times.iter().map(|block| &block.methods))
                .flatten()
            {
                assert!(spatial_method(method).is_ok(), "no method {method:?}");
            }
            let counts = definition.counts.iter().map(|block| &block.distributions);
            let times = definition.times.iter().map(|block| &block.distributions);
            let angles = definition.angles.iter().map(|block| &block.distributions);
            let merges = definition.merges.iter().map(|block| &block.distributions);
            for name in counts
                .chain(times)
                .chain(angles)
                .chain(merges)
                .flatten()
                .chain([&definition.orders.distribution])
            {
                let spec = point_sets::Spec::from_str(name).expect("a distribution");
                assert_eq!(spec.dimension(), 3, "{name}");
            }
        }
    }

    #[test]
    fn a_timed_cell_is_in_one_block_only() {
        for quick in [false, true] {
            let definition = Definition::load(quick).expect("valid");
            let blocks = definition.times.iter();
            let mut cells: Vec<_> = blocks
                .flat_map(|block| product(&block.distributions, &block.n))
                .collect();
            let all = cells.len();
            cells.sort();
            cells.dedup();
            assert_eq!(cells.len(), all);
        }
    }

    #[test]
    fn an_unknown_key_is_an_error() {
        let text = include_str!("../../../../data/definitions/balan-munjal-rao/quick.toml");
        assert!(toml::from_str::<Definition>(&format!("sedd = 3\n{text}")).is_err());
    }
}
