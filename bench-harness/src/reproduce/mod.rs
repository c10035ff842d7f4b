//! The papers, regenerated and judged.
//!
//! A pipeline of plain values, each stage computed from the one before:
//!
//! ```text
//! definition, published figures      data/…                   definition.rs, published.rs
//!   -> point sets                    seed and fingerprint     sets.rs
//!   -> certified, counted, timed     one experiment a file    experiments/
//!   -> records                       rows of CSV              records.rs
//!   -> derived quantities            means, ratios            derived.rs, stats/, theory/
//!   -> verdicts                      one claim a file         verdicts/
//!   -> tables, figures, report       Markdown, CSV, SVG       render/
//! ```
//!
//! Counting and timing are runs of their own, and nothing is counted or timed that is not certified. A verdict
//! sees records and published figures only, never a clock or an algorithm.

mod definition;
mod derived;
mod experiments;
mod parallel;
mod progress;
mod provenance;
mod published;
mod records;
mod render;
mod sets;
mod stats;
mod theory;
mod topics;
mod verdicts;

use crate::failure::Failure;
use crate::output::target::to_stdout;
use anyhow::Result;
use definition::{Definition, PAPER};
use provenance::Provenance;
use published::Published;
use records::Records;
use render::folder::Folder;
use render::peels::Figure;
use std::path::PathBuf;
use std::time::Instant;
use topics::{Experiment, Topic};
use verdicts::Verdict;
use verdicts::predictions::Checked;

/// The options of `hullbench reproduce`.
#[derive(clap::Args, Clone, Debug)]
pub struct Args {
    /// What to reproduce of Green & Silverman (1979): table1, table2, figure1, figure2, figure7, storage,
    /// peeling, claims, or a claim GS-1 to GS-9 [default: all]
    #[arg(value_name = "ID")]
    ids: Vec<String>,

    /// A smaller run, under a minute
    #[arg(long)]
    quick: bool,

    /// The folder of the report [default: reports/green-silverman-1979, with --quick
    /// reports/quick/green-silverman-1979]
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,

    /// The seed from which every point set's seed is derived [default: the definition's]
    #[arg(long)]
    seed: Option<u64>,
}

/// Runs the experiments that the asked-for tables, figures and claims need, and writes the report.
///
/// A refuted claim is a result, not an error.
///
/// # Errors
///
/// An unknown ID; a file that cannot be read or written; at the end, results that could not be certified.
pub fn run(args: &Args) -> Result<()> {
    let started = Instant::now();
    let published = Published::load()?;
    let topics = topics::parse(&args.ids, &published)?;
    let mut definition = Definition::load(args.quick)?;
    definition.seed = args.seed.unwrap_or(definition.seed);
    let mut provenance = Provenance::collect(command(args), definition.seed);
    let records = experiment(&definition, &topics)?;
    provenance.finish(started.elapsed().as_secs());
    let folder = Folder::open(folder(args), provenance)?;
    let verdicts = report(&folder, &definition, &topics, &records, &published)?;
    to_stdout(|out| {
        for verdict in &verdicts {
            writeln!(out, "{}: {}", verdict.id, verdict.outcome)?;
        }
        writeln!(out, "{}", folder.path().join("REPORT.md").display())
    })?;
    match records.failures.len() {
        0 => Ok(()),
        count => Err(Failure::Verification(format!(
            "{count} results could not be certified; see the report"
        ))
        .into()),
    }
}

/// The command line, as it would be typed again.
fn command(args: &Args) -> String {
    let mut words = vec!["hullbench reproduce".to_owned()];
    words.extend(args.ids.iter().cloned());
    words.extend(args.quick.then(|| "--quick".to_owned()));
    words.extend(args.seed.map(|seed| format!("--seed {seed}")));
    words.join(" ")
}

fn folder(args: &Args) -> PathBuf {
    let default = if args.quick {
        "reports/quick"
    } else {
        "reports"
    };
    args.out
        .clone()
        .unwrap_or_else(|| PathBuf::from(default).join(PAPER))
}

/// Runs what `topics` need, each experiment once.
fn experiment(definition: &Definition, topics: &[Topic]) -> Result<Records> {
    let needed = |experiment| {
        topics
            .iter()
            .any(|topic| topics::experiments(topic).contains(&experiment))
    };
    let mut records = Records::default();
    if needed(Experiment::Sizes) {
        experiments::sizes::run(definition, &mut records)?;
    }
    if needed(Experiment::Counts) {
        experiments::counts::run(definition, &mut records)?;
    }
    if needed(Experiment::Times) {
        experiments::times::run(definition, &mut records)?;
    }
    if needed(Experiment::Peels) {
        experiments::peels::run(definition, &mut records)?;
    }
    if needed(Experiment::Lattices) {
        experiments::peels::lattices(definition, &mut records)?;
    }
    if needed(Experiment::Tolerance) {
        experiments::tolerance::run(definition, &mut records)?;
    }
    Ok(records)
}

/// Writes everything that `topics` ask for, and the records. Returns the verdicts.
fn report(
    folder: &Folder,
    definition: &Definition,
    topics: &[Topic],
    records: &Records,
    published: &Published,
) -> Result<Vec<Verdict>> {
    for topic in topics {
        match topic {
            Topic::Table1 => render::table1::write(folder, records, published)?,
            Topic::Table2 => render::table2::write(folder, records, published)?,
            Topic::Figure1 => {
                let data = &definition.tolerance.random;
                let title = "100 random points of the unit square";
                render::peels::write(
                    folder,
                    definition.seed,
                    Figure {
                        name: "figure1",
                        title,
                        data,
                    },
                )?;
            }
            Topic::Figure2 => {
                let data = &definition.tolerance.exact_lattice;
                let title = "An oblique lattice of 100 points";
                render::peels::write(
                    folder,
                    definition.seed,
                    Figure {
                        name: "figure2",
                        title,
                        data,
                    },
                )?;
            }
            Topic::Figure7 => render::growth::write(folder, records)?,
            Topic::Storage => render::peeling::write_storage(folder, records)?,
            Topic::Peeling => render::peeling::write_peeling(folder, records)?,
            Topic::Claim(_) => {}
        }
    }
    let (verdicts, predictions) = judge(topics, records, published);
    if !verdicts.is_empty() {
        render::claims::write(folder, &verdicts, &predictions, published)?;
    }
    for (name, text, rows) in records.files()? {
        if rows > 0 {
            folder.csv(&format!("records-{name}"), &text)?;
        }
    }
    render::index::write(
        folder,
        definition,
        topics,
        records,
        &verdicts,
        &predictions,
        published,
    )?;
    Ok(verdicts)
}

/// The verdicts on the claims among `topics`, and the predictions if there are any.
fn judge<'a>(
    topics: &[Topic],
    records: &Records,
    published: &'a Published,
) -> (Vec<Verdict>, Vec<Checked<'a>>) {
    let verdicts = topics
        .iter()
        .filter_map(|topic| match topic {
            Topic::Claim(id) => verdicts::judge(id, records, published),
            _ => None,
        })
        .collect();
    (verdicts, verdicts::predictions::check(records, published))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_of_a_report_says_where_it_comes_from() {
        let folder = tempfile::tempdir().expect("a folder");
        let args = Args {
            ids: ["figure1", "figure2", "gs-8"].map(str::to_owned).to_vec(),
            quick: true,
            out: Some(folder.path().to_owned()),
            seed: Some(3),
        };
        run(&args).expect("a report");
        let mut names = Vec::new();
        for entry in std::fs::read_dir(folder.path()).expect("a folder") {
            let path = entry.expect("a file").path();
            let text = std::fs::read_to_string(&path).expect("text");
            let head: String = text.lines().take(20).collect();
            for needed in [
                "command: hullbench reproduce figure1",
                "seed: 3",
                "commit: ",
                "machine: ",
                "date: ",
            ] {
                assert!(head.contains(needed), "{}: {needed}", path.display());
            }
            names.extend(
                path.file_name()
                    .map(|name| name.to_string_lossy().into_owned()),
            );
        }
        names.sort();
        let expected = [
            "REPORT.md",
            "claims.csv",
            "claims.md",
            "figure1.csv",
            "figure1.svg",
            "figure2.csv",
            "figure2.svg",
            "records-rings.csv",
        ];
        assert_eq!(names, expected);
        let report = std::fs::read_to_string(folder.path().join("REPORT.md")).expect("text");
        assert!(report.contains("**CONFIRMED**"));
    }
}
