//! Nathan 2015. The paper prints a method, advice, and one picture, but no measurements. So what there is to reproduce
//! are its claims, and each is put to a test that could come out otherwise.
//!
//! Its data: what is asked for and what that needs. The flow is that of every paper ([`super::paper`]).

mod definition;
mod records;
mod render;
mod sets;
mod studies;
mod verdicts;

use super::paper::{Claim, Paper, Study, Topic};
use anyhow::Result;
use definition::Studies;
use records::{Records, Studied};

/// The paper's folder.
const SLUG: &str = "nathan-2015";

/// The paper.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nathan;

impl Paper for Nathan {
    const SLUG: &'static str = SLUG;
    const TITLE: &'static str = "Nathan (2015)";
    const ABOUT: &'static str = "P. Nathan, *Obtaining the convex hull from a set of points using the gift wrapping \
         algorithm*, 2015: its claims judged, its figure drawn anew.";

    type Studies = Studies;
    type Rows = Studied;
    type Figures = ();

    const TOPICS: &'static [Topic<Self>] = TOPICS;
    const CLAIMS: &'static [Claim<Self>] = verdicts::CLAIMS;
    const STUDIES: &'static [Study<Self>] = &[
        Study::new("wraps", studies::wraps::run),
        Study::new("starts", studies::starts::run),
        Study::new("epsilon", studies::epsilon::run),
        Study::new("lifting", studies::lifting::run),
        Study::new("sweep", studies::sweep::run),
        Study::new("corners", studies::corners::run),
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
        let triangulations = records.own.lifting.iter().map(|row| row.exact_right);
        Some(format!(
            "{} wraps counted, each equal to a certified hull; {} triangulations certified",
            records.own.wraps.len(),
            triangulations.sum::<usize>()
        ))
    }
}

const TOPICS: &[Topic<Nathan>] = &[
    Topic {
        name: "wraps",
        needs: &["wraps"],
        write: |folder, found| render::wraps::write(folder, &found.records),
        line: "[What wrapping asks](wraps.md), [figures](wraps.csv)",
    },
    Topic {
        name: "epsilon",
        needs: &["epsilon", "starts"],
        write: |folder, found| render::epsilon::write(folder, &found.records),
        line: "[The epsilon, and the first points](epsilon.md), figures: [epsilon](epsilon.csv), [starts](starts.csv)",
    },
    Topic {
        name: "wrap-times",
        needs: &["nathan-times", "corners"],
        write: |folder, found| render::times::write(folder, &found.records),
        line: "[Times of wrapping](wrap-times.md), [figures](wrap-times.csv)",
    },
    Topic {
        name: "delaunay",
        needs: &[],
        write: |folder, found| render::figure1::write(folder, &found.studies),
        line: "Figure 1: [Delaunay triangulation of flattened points of the sphere](delaunay.svg), \
               [triangles](delaunay.csv)",
    },
    Topic {
        name: "lifting",
        needs: &["lifting"],
        write: |folder, found| render::lifting::write(folder, &found.records),
        line: "[Delaunay triangulations by lifting](lifting.md), figures: [offsets](lifting.csv), [grids](grids.csv)",
    },
    Topic {
        name: "sweep",
        needs: &["sweep"],
        write: |folder, found| render::sweep::write(folder, &found.studies.sweep, &found.records),
        line: "[The swept volume of a moving box](sweep.md), [figures](sweep.csv)",
    },
    Topic {
        name: "sizes-in-space",
        needs: &["nathan-sizes"],
        write: |folder, found| render::sizes::write(folder, &found.records),
        line: "[Sizes in space](sizes.md), [figures](sizes.csv)",
    },
];

#[cfg(test)]
mod tests {
    #[test]
    fn claims_predictions_and_needs_fit_the_files() {
        crate::reproduce::paper::checks::all::<super::Nathan>();
    }
}
