//! Green and Silverman 1979: finding the hull of points in the plane, and its layers.
//!
//! Its data: what is asked for and what that needs. The flow is that of every paper ([`super::paper`]).

mod definition;
mod derived;
mod published;
mod records;
mod render;
mod studies;
mod verdicts;

use super::paper::{Claim, Findings, Paper, Study, Topic};
use super::render::folder::Folder;
use anyhow::Result;
use definition::Studies;
use published::Published;
use records::{Records, Studied};
use render::peels::Figure;

/// The paper's folder.
const SLUG: &str = "green-silverman-1979";

/// The paper.
#[derive(Clone, Copy, Debug)]
pub(super) struct GreenSilverman;

impl Paper for GreenSilverman {
    const SLUG: &'static str = SLUG;
    const TITLE: &'static str = "Green & Silverman (1979)";
    const ABOUT: &'static str = "P. J. Green and B. W. Silverman, *Constructing the convex hull of a set of points in the \
         plane*, The Computer Journal 22(3), 262–266, 1979: its tables and figures regenerated, its claims judged.";

    type Studies = Studies;
    type Rows = Studied;
    type Figures = Published;

    const TOPICS: &'static [Topic<Self>] = TOPICS;
    const CLAIMS: &'static [Claim<Self>] = verdicts::CLAIMS;
    const STUDIES: &'static [Study<Self>] = &[
        Study::new("peels", studies::peels::run),
        Study::new("lattices", studies::peels::lattices),
        Study::new("tolerance", studies::tolerance::run),
    ];

    fn seed(studies: &mut Studies) -> &mut u64 {
        &mut studies.seed
    }

    fn analysis(studies: &Studies) -> &str {
        &studies.analysis
    }

    fn figures() -> Result<Published> {
        Published::load()
    }

    fn measure(id: &str, records: &Records) -> Option<f64> {
        verdicts::predictions::measure(id, records)
    }
}

const TOPICS: &[Topic<GreenSilverman>] = &[
    Topic {
        name: "table1",
        needs: &["tolerance", "lattices"],
        write: |folder, found| render::table1::write(folder, &found.records, &found.figures),
        line: "[Table 1: the tolerance](table1.md), [figures](table1.csv)",
    },
    Topic {
        name: "table2",
        needs: &["gs-sizes", "gs-counts", "gs-times"],
        write: |folder, found| render::table2::write(folder, &found.records, &found.figures),
        line: "[Table 2: seven methods](table2.md), [figures](table2.csv), [vertices](vertices.csv)",
    },
    Topic {
        name: "figure1",
        needs: &[],
        write: figure1,
        line: "Figure 1: [peels of 100 random points](figure1.svg), [points](figure1.csv)",
    },
    Topic {
        name: "figure2",
        needs: &[],
        write: figure2,
        line: "Figure 2: [peels of an oblique lattice](figure2.svg), [points](figure2.csv)",
    },
    Topic {
        name: "figure7",
        needs: &["gs-counts", "gs-times"],
        write: |folder, found| render::growth::write(folder, &found.records),
        line: "[Figure 7: growth of GS and E](figure7.md), [figures](figure7.csv)",
    },
    Topic {
        name: "storage",
        needs: &["peels"],
        write: |folder, found| render::peeling::write_storage(folder, &found.records),
        line: "[Storage: the stack of method GS](storage.md), [figures](storage.csv)",
    },
    Topic {
        name: "peeling",
        needs: &["peels"],
        write: |folder, found| render::peeling::write_peeling(folder, &found.records),
        line: "[Peeling: what all layers cost](peeling.md), [figures](peeling.csv)",
    },
];

fn figure1(folder: &Folder, found: &Findings<GreenSilverman>) -> Result<()> {
    let figure = Figure {
        name: "figure1",
        title: "100 random points of the unit square",
        data: &found.studies.tolerance.random,
    };
    render::peels::write(folder, found.studies.seed, figure)
}

fn figure2(folder: &Folder, found: &Findings<GreenSilverman>) -> Result<()> {
    let figure = Figure {
        name: "figure2",
        title: "An oblique lattice of 100 points",
        data: &found.studies.tolerance.exact_lattice,
    };
    render::peels::write(folder, found.studies.seed, figure)
}

#[cfg(test)]
mod tests {
    #[test]
    fn claims_predictions_and_needs_fit_the_files() {
        crate::reproduce::paper::checks::all::<super::GreenSilverman>();
    }
}
