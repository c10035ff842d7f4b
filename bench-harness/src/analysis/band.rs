//! How much a program differs from itself.
//!
//! An engine's twin is the same program measured as if it were another. What their times differ by is no difference:
//! it is the band inside which nothing is claimed.

use super::compare::Comparison;
use crate::records::Run;
use crate::stats::summary::quantile;
use serde::Serialize;

/// The band is never narrower than this part either side of 1.
pub const NARROWEST: f64 = 0.02;

/// Of the ratios of twins, the band holds this part.
const HELD: f64 = 0.95;

/// The A/A band of one run, or of several together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Band {
    /// Half its width, as a logarithm: it reaches from e^-w to e^w.
    pub half_width: f64,
    /// How many ratios of twins it comes from, one a pair and case.
    pub twins: usize,
}

impl Band {
    /// The band of `runs`: it holds 95 % of the median ratios of twins over all cases, and at least 2 % either side.
    pub fn of(runs: &[&Run]) -> Self {
        let ratios: Vec<f64> = runs.iter().flat_map(|run| twin_logs(run)).collect();
        let sizes: Vec<f64> = ratios.iter().map(|log| log.abs()).collect();
        let narrowest = NARROWEST.ln_1p();
        let seen = quantile(&sizes, HELD);
        Self {
            half_width: if seen > narrowest { seen } else { narrowest },
            twins: ratios.len(),
        }
    }

    /// The band as a sentence.
    pub fn sentence(&self) -> String {
        let (low, high) = ((-self.half_width).exp(), self.half_width.exp());
        let source = match self.twins {
            0 => "no twin was measured: the narrowest band is assumed, and real noise may be more"
                .into(),
            twins => format!("from {twins} ratios of a program to itself"),
        };
        format!("A/A band: {low:.3} to {high:.3}, {source}. Nothing is claimed inside it.")
    }
}

/// The logarithms of the ratios of every twin to its engine, case by case.
fn twin_logs(run: &Run) -> Vec<f64> {
    let mut logs = Vec::new();
    for case in run.cases() {
        for pair in run.twins(case) {
            let compared = Comparison::of(run, case, &pair.twin, &pair.engine);
            logs.extend(compared.map(|compared| compared.log.median));
        }
    }
    logs
}
