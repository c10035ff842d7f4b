//! Which engine is fastest over all cases: the geometric mean of its ratios to the fastest engine of each case, and how
//! often it is that one.
//!
//! Yardsticks compute no hull and are not ranked.
//!
//! An engine that was not measured on every case is compared on those it was measured on, which may be the easy ones:
//! its row says how many.

use super::band::Band;
use super::compare::Comparison;
use super::{ratio_text, text, typical_time};
use crate::engine::yardstick::Yardstick;
use crate::output::page::{Page, Section, json};
use crate::output::sheet::Sheet;
use crate::records::{Case, Run};
use crate::stats::bootstrap::Bootstrapped;
use serde::Serialize;
use std::collections::BTreeSet;

/// One engine over all cases.
#[derive(Clone, Debug, Serialize)]
pub struct Ranked {
    /// The engine.
    pub engine: String,
    /// The geometric mean of its ratios to the fastest engine of each case.
    pub mean_ratio: f64,
    /// The lower end of its 95 % interval, over realisations and rounds; the cases are taken as they are.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// The cases on which it was the fastest.
    pub wins: usize,
    /// The other cases on which it was within the A/A band of the fastest.
    pub ties: usize,
    /// The cases on which it was measured.
    pub cases: usize,
}

/// The answer.
#[derive(Clone, Debug, Serialize)]
pub struct Rank {
    /// Inside it two engines tie.
    pub band: Band,
    /// Every engine, the best first; those measured on every case before the others.
    pub ranked: Vec<Ranked>,
    /// How many cases there are.
    pub cases: usize,
}

/// Ranks the engines of a run.
pub fn rank(run: &Run) -> Rank {
    let band = Band::of(&[run]);
    let timed = |case: &&Case| runners(run, case).next().is_some();
    let cases: Vec<&Case> = run.cases().into_iter().filter(timed).collect();
    let engines: BTreeSet<&str> = cases.iter().flat_map(|case| runners(run, case)).collect();
    let mut ranked: Vec<Ranked> = engines
        .iter()
        .filter_map(|engine| rank_engine(run, &cases, engine, band))
        .collect();
    ranked.sort_by(|a, b| {
        let complete = |row: &Ranked| row.cases < cases.len();
        let by_mean = a.mean_ratio.total_cmp(&b.mean_ratio);
        complete(a).cmp(&complete(b)).then(by_mean)
    });
    Rank {
        band,
        ranked,
        cases: cases.len(),
    }
}

fn rank_engine(run: &Run, cases: &[&Case], engine: &str, band: Band) -> Option<Ranked> {
    let mut parts = Vec::new();
    let (mut wins, mut ties) = (0, 0);
    for case in cases {
        let Some(fastest) = fastest(run, case) else {
            continue;
        };
        // An engine compared with itself has ratio 1 in every round: it counts, with no doubt about it.
        let Some(compared) = Comparison::of(run, case, engine, fastest) else {
            continue;
        };
        if engine == fastest {
            wins += 1;
        } else if compared.log.median <= band.half_width {
            ties += 1;
        }
        parts.push(compared.log);
    }
    let mean = Bootstrapped::mean_of(&parts)?;
    let (low, high) = mean.interval(0.95);
    Some(Ranked {
        engine: engine.to_owned(),
        mean_ratio: mean.median.exp(),
        low: low.exp(),
        high: high.exp(),
        wins,
        ties,
        cases: parts.len(),
    })
}

/// The engine with the shortest typical time.
fn fastest<'a>(run: &'a Run, case: &Case) -> Option<&'a str> {
    let time = |engine: &str| typical_time(run, case, engine).unwrap_or(f64::INFINITY);
    runners(run, case).min_by(|a, b| time(a).total_cmp(&time(b)))
}

/// The engines that were timed on `case`, without yardsticks.
fn runners<'a>(run: &'a Run, case: &Case) -> impl Iterator<Item = &'a str> {
    let is_engine = |name: &&str| Yardstick::find(name).is_none();
    run.timed(case).into_iter().filter(is_engine)
}

impl Rank {
    /// The answer for readers and programs.
    pub fn page(&self) -> Page {
        let mut sheet = Sheet::new(&["engine", "geometric mean", "wins", "ties", "cases"]);
        let mut long = Sheet::new(&[
            "engine",
            "mean_ratio",
            "low",
            "high",
            "wins",
            "ties",
            "cases",
        ]);
        for row in &self.ranked {
            let interval = (row.low.ln(), row.high.ln());
            let cases = if row.cases < self.cases {
                format!("only {} of {}", row.cases, self.cases)
            } else {
                row.cases.to_string()
            };
            sheet.push(vec![
                row.engine.clone(),
                ratio_text(row.mean_ratio.ln(), interval),
                row.wins.to_string(),
                row.ties.to_string(),
                cases,
            ]);
            long.push(vec![
                row.engine.clone(),
                row.mean_ratio.to_string(),
                row.low.to_string(),
                row.high.to_string(),
                row.wins.to_string(),
                row.ties.to_string(),
                row.cases.to_string(),
            ]);
        }
        let first = self.ranked.first().map(|row| row.engine.as_str());
        Page {
            title: "Engines over all cases".into(),
            preface: vec![
                self.band.sentence(),
                "Geometric mean of the ratios of an engine's time to that of the fastest engine of each case, 95 % \
                 interval; 1 would be the fastest of every case. A tie is a ratio inside the band."
                    .into(),
            ],
            sections: vec![Section {
                heading: format!("{} cases", self.cases),
                sheet,
                notes: Vec::new(),
            }],
            long,
            value: json(self),
            headline: format!("{} engines; first {}", self.ranked.len(), text(first)),
        }
    }
}
