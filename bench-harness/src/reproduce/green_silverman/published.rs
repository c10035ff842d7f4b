//! The figures of the paper, read from `data/published/`.

use super::SLUG;
use crate::reproduce::data::rows;
use anyhow::Result;
use serde::Deserialize;
use std::collections::BTreeMap;

/// The figures that the paper prints.
#[derive(Clone, Debug)]
pub(crate) struct Published {
    /// The rows of Table 1.
    pub(crate) table1: Vec<Threshold>,
    /// Table 2: (distribution, n, quantity) to value, where a quantity is a method's slug (milliseconds a
    /// call) or one of "average vertices", "realisations", "repetitions".
    table2: BTreeMap<(String, usize, String), f64>,
}

/// A row of Table 1.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Threshold {
    /// "random" or "lattice".
    pub(crate) data: String,
    /// The machine.
    pub(crate) machine: String,
    /// Our number format that emulates the machine's single precision.
    pub(crate) format: String,
    /// "at or above" or "at or below".
    pub(crate) fails: String,
    /// The power of ten at which peeling starts to go wrong.
    pub(crate) exponent: i32,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table2Row {
    distribution: String,
    n: usize,
    quantity: String,
    value: f64,
}

impl Published {
    /// Reads the tables.
    pub(crate) fn load() -> Result<Self> {
        let cells: Vec<Table2Row> = rows(SLUG, "table2.csv")?;
        let figure = |row: Table2Row| ((row.distribution, row.n, row.quantity), row.value);
        Ok(Self {
            table1: rows(SLUG, "table1.csv")?,
            table2: cells.into_iter().map(figure).collect(),
        })
    }

    /// A figure of Table 2.
    pub(crate) fn table2(&self, distribution: &str, n: usize, quantity: &str) -> Option<f64> {
        self.table2
            .get(&(distribution.to_owned(), n, quantity.to_owned()))
            .copied()
    }

    /// The milliseconds of `method` over those of GS, as published.
    pub(crate) fn ratio_to_gs(&self, distribution: &str, n: usize, method: &str) -> Option<f64> {
        Some(self.table2(distribution, n, method)? / self.table2(distribution, n, "gs")?)
    }
}

/// The distributions of Table 2, in its order.
pub(crate) const DISTRIBUTIONS: [&str; 3] = ["disc", "normal", "cauchy"];

/// The sizes of Table 2.
pub(crate) const SIZES: [usize; 2] = [100, 1_000];

/// The seven methods of Table 2, in its order: our slug, the paper's letter.
pub(crate) const METHODS: [(&str, &str); 7] = [
    ("gs", "GS"),
    ("eddy", "E"),
    ("graham", "G"),
    ("jarvis-j1", "J1"),
    ("jarvis-j2", "J2"),
    ("jarvis-j3", "J3"),
    ("incremental-r", "R"),
];

/// Methods that the paper names or that are of its time, timed beside its own.
pub(crate) const KIN: [(&str, &str); 2] =
    [("monotone-chain", "chain"), ("preparata-hong-2d", "PH")];

/// The six cells of Table 2, in its order.
pub(crate) fn cells() -> impl Iterator<Item = (&'static str, usize)> {
    DISTRIBUTIONS
        .into_iter()
        .flat_map(|distribution| SIZES.map(|n| (distribution, n)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_figures_give_the_ratios_that_the_text_states() {
        let published = Published::load().expect("valid");
        let rounded =
            |d, n, m| (published.ratio_to_gs(d, n, m).expect("printed") * 100.0).round() / 100.0;
        assert!((rounded("disc", 100, "eddy") - 1.29).abs() < 1e-9);
        assert!((rounded("normal", 1_000, "graham") - 4.13).abs() < 1e-9);
        assert!(
            (published
                .ratio_to_gs("disc", 1_000, "jarvis-j1")
                .expect("printed")
                - 49.98)
                .abs()
                < 0.01
        );
        for (distribution, n) in cells() {
            for (method, _) in METHODS {
                assert!(published.table2(distribution, n, method).is_some());
            }
        }
        assert_eq!(published.table1.len(), 4);
    }

    #[test]
    fn the_cost_of_j1_is_in_proportion_to_n_and_vertices() {
        let published = Published::load().expect("valid");
        for (distribution, n) in cells() {
            let vertices = published
                .table2(distribution, n, "average vertices")
                .expect("printed");
            let time = published
                .table2(distribution, n, "jarvis-j1")
                .expect("printed");
            let microseconds = 1_000.0 * time / (n as f64 * vertices);
            assert!(
                (20.8..21.4).contains(&microseconds),
                "{distribution} {n}: {microseconds}"
            );
        }
    }
}
