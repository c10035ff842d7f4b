//! Day (1990). A report on making an algorithm run, without tables: what it says in words is measured, and each
//! statement judged.
//!
//! Its data: what is asked for and what that needs. The flow is that of every paper ([`super::paper`]). Beside these:
//! the number formats by name (`formats`), laws of growth (`laws`), the rules of search (`variants`), the paper's own check (`check`), a kernel
//! for several threads (`watch`).

mod check;
mod definition;
mod derived;
mod formats;
mod laws;
mod records;
mod render;
mod sets;
mod studies;
mod variants;
mod verdicts;
mod watch;

use super::paper::{Claim, Paper, Study, Topic};
use anyhow::Result;
use definition::Studies;
use records::{Records, Studied};

/// The paper's folder.
const SLUG: &str = "day-1990";

/// The paper.
#[derive(Clone, Copy, Debug)]
pub(super) struct Day;

impl Paper for Day {
    const SLUG: &'static str = SLUG;
    const TITLE: &'static str = "Day (1990)";
    const ABOUT: &'static str = "A. M. Day, *The Implementation of an Algorithm to Find the Convex Hull of a Set of \
         Three-Dimensional Points*, ACM Transactions on Graphics 9(1), 1990: Preparata and Hong's divide and conquer made \
         to run. The paper prints no table; its claims are judged here, and what it reports in words is measured.";

    type Studies = Studies;
    type Rows = Studied;
    type Figures = ();

    const TOPICS: &'static [Topic<Self>] = TOPICS;
    const CLAIMS: &'static [Claim<Self>] = verdicts::CLAIMS;
    const STUDIES: &'static [Study<Self>] = &[
        Study::new("precision", studies::precision::run),
        Study::new("speed", studies::speed::run),
        Study::new("merges", studies::merges::run),
        Study::new("bases", studies::bases::run),
        Study::new("turned", studies::turned::run),
        Study::new("battery", studies::battery::run),
        Study::new("listing", studies::listing::run),
        Study::new("checks", studies::checks::run),
        Study::new("parallel", studies::side_by_side::run),
    ];

    fn seed(studies: &mut Studies) -> &mut u64 {
        &mut studies.seed
    }

    fn analysis(studies: &Studies) -> &str {
        &studies.analysis
    }

    fn figures() -> Result<()> {
        Ok(())
    }

    fn measure(id: &str, records: &Records) -> Option<f64> {
        verdicts::predictions::measure(id, records)
    }

    fn certificates(records: &Records) -> Option<String> {
        let rounded: usize = records.own.controls.iter().map(|row| row.right).sum();
        Some(format!(
            "{rounded} hulls of rounded sets were certified for the study of precision"
        ))
    }
}

const TOPICS: &[Topic<Day>] = &[
    Topic {
        name: "precision",
        needs: &["precision", "speed"],
        write: |folder, found| render::precision::write(folder, &found.records),
        line: "[Precision and eps2](precision.md): [figure](precision.svg), data: [ends](outcomes.csv), \
               [thresholds](thresholds.csv), [times](formats.csv)",
    },
    Topic {
        name: "merge",
        needs: &["merges"],
        write: |folder, found| render::merges::write_merge(folder, &found.records),
        line: "[The merge: questions at the top](merge.md): [figure](merge.svg), data: [growth](merge-growth.csv), \
               [by size](merge-sizes.csv)",
    },
    Topic {
        name: "edges",
        needs: &["merges"],
        write: |folder, found| render::merges::write_edges(folder, &found.records),
        line: "[Edge records made, and in use](edges.md): [figure](edges.svg), [data](edge-records.csv)",
    },
    Topic {
        name: "whole",
        needs: &["day-counts", "turned", "day-times"],
        write: |folder, found| render::whole::write(folder, &found.records),
        line: "[The whole call: questions, laws, times](whole.md): [figure](whole.svg), data: [questions](whole.csv), \
               [laws](laws.csv), [times](whole-times.csv)",
    },
    Topic {
        name: "degenerate",
        needs: &["battery"],
        write: |folder, found| render::others::write_degenerate(folder, &found.records),
        line: "[Degenerate sets](degenerate.md), [data](degenerate.csv)",
    },
    Topic {
        name: "bases",
        needs: &["bases"],
        write: |folder, found| render::others::write_bases(folder, &found.records),
        line: "[Where the recursion stops, and dummy points](bases.md), [data](bases.csv)",
    },
    Topic {
        name: "spiral",
        needs: &["listing"],
        write: |folder, found| render::others::write_spiral(folder, &found.records),
        line: "[Listing the faces by a spiral](spiral.md), [data](spiral.csv)",
    },
    Topic {
        name: "checks",
        needs: &["checks"],
        write: |folder, found| render::others::write_checks(folder, &found.records),
        line: "[The paper's own check](checks.md), [data](checks.csv)",
    },
    Topic {
        name: "side-by-side",
        needs: &["parallel", "day-times"],
        write: |folder, found| render::others::write_side_by_side(folder, &found.records),
        line: "[Side by side](side-by-side.md), [data](side-by-side.csv)",
    },
];

#[cfg(test)]
mod tests {
    #[test]
    fn claims_predictions_and_needs_fit_the_files() {
        crate::reproduce::paper::checks::all::<super::Day>();
    }
}
