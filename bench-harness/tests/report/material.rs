//! A made-up run with a failure, a warning, memory, a question and a paper.

use crate::made_up::MadeUp;
use bench_harness::records::{Count, Manifest, Outcome, Run, Warning};
use bench_harness::report::asked::Asked;
use bench_harness::report::papers::{self, Paper};
use bench_harness::report::{Material, document, html};
use std::fs;

/// A finding that would be markup if it were not escaped.
pub(crate) const FINDING: &str = "misses <b>2</b> extreme points & more";

pub(crate) fn run() -> Run {
    let plan = MadeUp {
        sizes: vec![100, 300, 1_000, 3_000, 10_000],
        ..MadeUp::new(5)
    };
    let run = plan.run();
    let mut cells = run.cells.clone();
    let mut failed = cells[0].clone();
    failed.subject.engine = "crooked".into();
    failed.outcome = Outcome::Wrong;
    failed.finding = FINDING.into();
    let warning = Warning {
        subject: failed.subject.clone(),
        warning: "noisy: 1.2 times itself".into(),
        remedy: "more rounds".into(),
    };
    cells.push(failed);
    let mut counts = run.counts.clone();
    counts.push(Count {
        subject: cells[0].subject.clone(),
        counter: "peak_bytes".into(),
        value: 12_288,
    });
    let manifest = Manifest {
        command: "hullbench measure made-up".into(),
        ..run.manifest.clone()
    };
    Run::from_rows(manifest, cells, (run.samples, counts, vec![warning]))
}

/// The report on that run.
pub(crate) fn page() -> String {
    let asked = [Asked {
        id: "made-up".into(),
        question: "Which of these is fastest?".into(),
        left_out: [("jarvis-j1".to_owned(), "hours".to_owned())].into(),
    }];
    let material = Material {
        run: &run(),
        asked: &asked,
        targets: &[],
        figures: &[],
        papers: &papers(),
        counters: &["orient".to_owned()],
        baseline: None,
    };
    html::html(&document(&material).expect("a document")).expect("HTML")
}

fn papers() -> Vec<Paper> {
    let folder = tempfile::tempdir().expect("a folder");
    let paper = folder.path().join("someone-1979");
    fs::create_dir(&paper).expect("made");
    let files = [
        (
            "claims.csv",
            "# seed: 1\nclaim,verdict,part,outcome,statistic\nS-1,REFUTED,time,REFUTED,\"1,2\"\n",
        ),
        (
            "REPORT.md",
            "# Someone (1979), reproduced\n\n## Verdicts\n\n| claim | verdict |\n| - | - |\n| S-1 | **REFUTED** |\n",
        ),
        (
            "table1.md",
            "# Table 1: times\n\n## disc\n\n| n | printed | ours |\n| - | - | - |\n| 10 | 1.5 | 1.6 |\n",
        ),
    ];
    for (name, text) in files {
        fs::write(paper.join(name), text).expect("written");
    }
    papers::read(folder.path()).expect("a paper")
}
