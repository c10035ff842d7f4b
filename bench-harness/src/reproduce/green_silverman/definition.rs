//! The definition of the experiment, read from `data/definitions/`.

use crate::reproduce::data::{in_checkout_or, product};
use anyhow::{Context, Result, ensure};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Where the paper's files lie below `data/definitions` and `data/published`.
pub(crate) const PAPER: &str = "green-silverman-1979";

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
    /// Average numbers of vertices.
    #[serde(default)]
    pub(crate) sizes: Vec<Sizes>,
    /// Questions asked.
    #[serde(default)]
    pub(crate) counts: Vec<Counts>,
    /// Times.
    #[serde(default)]
    pub(crate) times: Vec<Times>,
    /// Complete peelings.
    #[serde(default)]
    pub(crate) peels: Vec<Peels>,
    /// Table 1.
    pub(crate) tolerance: Tolerance,
}

/// A block of cells whose hulls are only measured for their number of vertices.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sizes {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) replicates: u64,
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

/// A block of cells that are peeled completely.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Peels {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) replicates: u64,
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

impl Definition {
    /// The reference run or the quick one: the checkout's file if the program runs in one, else the copy
    /// built into the program.
    pub(crate) fn load(quick: bool) -> Result<Self> {
        let (name, built_in) = if quick {
            (
                "quick.toml",
                include_str!("../../../../data/definitions/green-silverman-1979/quick.toml"),
            )
        } else {
            (
                "full.toml",
                include_str!("../../../../data/definitions/green-silverman-1979/full.toml"),
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

    /// Every cell to be counted with, for each replicate's number below the value, the methods to count.
    pub(crate) fn counted_cells(&self) -> BTreeMap<(String, usize), BTreeMap<String, u64>> {
        let mut cells: BTreeMap<(String, usize), BTreeMap<String, u64>> = BTreeMap::new();
        for block in &self.counts {
            for (distribution, n) in product(&block.distributions, &block.n) {
                let cell = cells.entry((distribution, n)).or_default();
                for method in &block.methods {
                    let replicates = cell.entry(method.clone()).or_default();
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
    use std::str::FromStr;

    #[test]
    fn both_definitions_name_known_things_only() {
        for quick in [false, true] {
            let definition = Definition::load(quick).expect("valid");
            let methods = definition.counts.iter().map(|c| &c.methods);
            for method in methods
                .chain(definition.times.iter().map(|t| &t.methods))
                .flatten()
            {
                assert!(hullkit::method(method).is_some(), "no method {method:?}");
            }
            let distributions = definition.sizes.iter().map(|b| &b.distributions);
            let distributions =
                distributions.chain(definition.counts.iter().map(|b| &b.distributions));
            let distributions =
                distributions.chain(definition.times.iter().map(|b| &b.distributions));
            for spec in distributions
                .chain(definition.peels.iter().map(|b| &b.distributions))
                .flatten()
            {
                assert!(
                    point_sets::Spec::from_str(spec).is_ok(),
                    "no distribution {spec:?}"
                );
            }
        }
    }

    #[test]
    fn a_timed_cell_is_in_one_block_only() {
        for quick in [false, true] {
            let definition = Definition::load(quick).expect("valid");
            let mut cells: Vec<_> = definition
                .times
                .iter()
                .flat_map(|t| product(&t.distributions, &t.n))
                .collect();
            let all = cells.len();
            cells.sort();
            cells.dedup();
            assert_eq!(cells.len(), all);
        }
    }

    #[test]
    fn an_unknown_key_is_an_error() {
        let text = include_str!("../../../../data/definitions/green-silverman-1979/quick.toml");
        assert!(toml::from_str::<Definition>(&format!("sedd = 3\n{text}")).is_err());
    }
}
