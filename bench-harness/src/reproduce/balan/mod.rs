//! Balan, Munjal and Rao: a comparison that prints no times. What it says about the cost of its three programs is
//! tested by counting, and the table that it does not have is supplied.
//!
//! Its data: what is asked for and what that needs. The flow is that of every paper ([`super::paper`]).

mod definition;
mod derived;
mod published;
mod records;
mod render;
mod studies;
mod verdicts;

use super::data;
use super::paper::{Claim, Paper, Study, Topic};
use anyhow::Result;
use definition::Studies;
use published::Comparison;
use records::{Records, Studied};

/// The paper's folder.
const SLUG: &str = "balan-munjal-rao";

/// The paper.
#[derive(Clone, Copy, Debug)]
pub(super) struct Balan;

impl Paper for Balan {
    const SLUG: &'static str = SLUG;
    const TITLE: &'static str = "Balan, Munjal & Rao";
    const ABOUT: &'static str = "A. Balan, G. Munjal and T. R. Rao, *Implementation of Convex Hull Algorithms in 3D \
         space*: three programs described, their costs stated, no times printed. Here the costs are counted, the claims \
         judged, and the table that is missing is supplied.";

    type Studies = Studies;
    type Rows = Studied;
    type Figures = Vec<Comparison>;

    const TOPICS: &'static [Topic<Self>] = TOPICS;
    const CLAIMS: &'static [Claim<Self>] = verdicts::CLAIMS;
    const STUDIES: &'static [Study<Self>] = &[
        Study::new("merges", studies::merges::run),
        Study::new("orders", studies::orders::run),
        Study::new("angles", studies::angles::run),
    ];

    fn seed(studies: &mut Studies) -> &mut u64 {
        &mut studies.seed
    }

    fn analysis(studies: &Studies) -> &str {
        &studies.analysis
    }

    /// The paper prints none; these are comparisons by others.
    fn figures() -> Result<Vec<Comparison>> {
        data::rows(SLUG, "comparisons.csv")
    }

    fn measure(id: &str, records: &Records) -> Option<f64> {
        verdicts::predictions::measure(id, records)
    }
}

const TOPICS: &[Topic<Balan>] = &[
    Topic {
        name: "balan-counts",
        needs: &["balan-counts"],
        write: |folder, found| render::tables::write_counts(folder, &found.records),
        line: "[Counts: questions asked and facets made](counts.md), [figures](counts.csv)",
    },
    Topic {
        name: "balan-times",
        needs: &["balan-times"],
        write: |folder, found| render::tables::write_times(folder, &found.records, &found.figures),
        line: "[Times: the table the paper does not print](times.md), [figures](times.csv)",
    },
    Topic {
        name: "balan-angles",
        needs: &["angles"],
        write: |folder, found| render::angles::write(folder, &found.records),
        line: "[Angles: the sign of the cosine](angles.md), [figures](angles.csv)",
    },
    Topic {
        name: "visibility",
        needs: &["balan-counts"],
        write: |folder, found| render::figures::write_visibility(folder, &found.records),
        line: "[Visibility tests without a conflict graph, against n](visibility.svg), [figures](visibility.csv)",
    },
    Topic {
        name: "insertion-orders",
        needs: &["orders"],
        write: |folder, found| render::figures::write_orders(folder, &found.records),
        line: "[Facets made in the worst order and in random order, against n](orders.svg), [figures](orders.csv)",
    },
    Topic {
        name: "evaluations",
        needs: &["balan-counts"],
        write: |folder, found| render::figures::write_evaluations(folder, &found.records),
        line: "[Plane evaluations of quickhull a point, against n](evaluations.svg), [figures](evaluations.csv)",
    },
];

#[cfg(test)]
mod tests {
    #[test]
    fn claims_predictions_and_needs_fit_the_files() {
        crate::reproduce::paper::checks::all::<super::Balan>();
    }
}
