//! Green and Silverman 1979.
//!
//! A pipeline of plain values, each stage computed from the one before:
//!
//! ```text
//! definition, published figures      data/…                   definition.rs, published.rs
//!   -> point sets                    seed and fingerprint     sets.rs
//!   -> certified, counted, timed     one experiment a file    experiments/
//!   -> records                       rows of CSV              records.rs
//!   -> derived quantities            means, ratios            derived.rs
//!   -> verdicts                      one claim a file         verdicts/
//!   -> tables, figures, report       Markdown, CSV, SVG       render/
//! ```
//!
//! Counting and timing are runs of their own, and nothing is counted or timed that is not certified. A verdict
//! sees records and published figures only, never a clock or an algorithm.

mod definition;
mod derived;
mod experiments;
mod published;
mod records;
mod render;
mod sets;
mod topics;
mod verdicts;

use super::paper::{Judged, Paper, Request};
use super::prediction::Checked;
use super::provenance::Provenance;
use super::render::folder::Folder;
use super::verdict::Verdict;
use anyhow::Result;
use definition::{Definition, PAPER};
use published::Published;
use records::Records;
use render::peels::Figure;
use std::time::Instant;
use topics::{Experiment, Topic};

/// The paper, for the list of papers.
pub(super) const GREEN_SILVERMAN: Paper = Paper {
    slug: PAPER,
    title: "Green & Silverman (1979)",
    ids,
    run,
};

fn ids() -> Result<Vec<String>> {
    Ok(topics::names(&Published::load()?))
}

/// Runs the experiments that the asked-for tables, figures and claims need, and writes the report.
fn run(request: &Request<'_>) -> Result<Judged> {
    let started = Instant::now();
    let published = Published::load()?;
    let topics = topics::parse(request.ids, &published)?;
    let mut definition = Definition::load(request.quick)?;
    definition.seed = request.seed.unwrap_or(definition.seed);
    let mut provenance = Provenance::collect(request.command.to_owned(), Some(definition.seed));
    let records = experiment(&definition, &topics)?;
    provenance.finish(started.elapsed().as_secs());
    let folder = Folder::open(request.folder.to_owned(), provenance)?;
    let verdicts = report(&folder, &definition, &topics, &records, &published)?;
    Ok(Judged {
        verdicts,
        uncertified: records.failures.len(),
        claims: published.claims,
    })
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
