//! `hullbench claims`: the verdicts on the papers' claims, from the reports that were written.

use crate::commands::recorded::deliver;
use crate::failure::Failure;
use crate::output::page::{Page, Section};
use crate::output::sheet::Sheet;
use crate::output::target::OutputArgs;
use crate::report::papers::{self, Paper};
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Every claim with its verdict; as CSV or JSON, every part of every claim with the statistic that decides. Nothing is run:
`hullbench reproduce` writes the reports.

Examples:
  hullbench claims
  hullbench claims reports/quick --format csv

Exit codes:
  0 done   2 usage   3 no reports of papers   4 a file could not be read or written";

/// The arguments of `hullbench claims`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder that `hullbench reproduce` wrote
    #[arg(value_name = "FOLDER", default_value = "reports", value_hint = ValueHint::DirPath)]
    folder: PathBuf,

    #[command(flatten)]
    output: OutputArgs,
}

/// Reads and writes.
///
/// # Errors
///
/// [`Failure::Data`] if the folder has no reports; [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    deliver(&page(&papers::read(&args.folder)?), &args.output)
}

fn page(papers: &[Paper]) -> Page {
    let mut long = Sheet::new(&["claim", "verdict", "part", "outcome", "statistic"]);
    let mut sections = Vec::new();
    for paper in papers {
        for row in paper.parts.sheet().rows() {
            long.push(row.clone());
        }
        sections.extend(paper.verdicts.iter().map(|table| Section {
            heading: paper.title.clone(),
            sheet: table.sheet(),
            notes: Vec::new(),
        }));
    }
    let claims: usize = sections
        .iter()
        .map(|section| section.sheet.rows().len())
        .sum();
    let columns = long.columns();
    let value = long.rows().iter().map(|row| {
        let fields = columns
            .iter()
            .cloned()
            .zip(row.iter().map(|text| text.clone().into()));
        serde_json::Value::Object(fields.collect())
    });
    Page {
        title: "Verdicts on the papers' claims".to_owned(),
        preface: Vec::new(),
        headline: format!("{claims} claims of {} papers", papers.len()),
        value: value.collect(),
        sections,
        long,
    }
}
