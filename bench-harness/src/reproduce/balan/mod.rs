//! Balan, Munjal and Rao.
//!
//! A comparison that prints no times: what it says about the cost of its three programs is tested by counting, and
//! the table that it does not have is supplied. The pipeline is that of every paper:
//!
//! ```text
//! definition, claims                 data/…                   definition.rs, published.rs
//!   -> certified, counted, timed     one experiment a file    experiments/
//!   -> records                       rows of CSV              records.rs
//!   -> derived quantities            per point, exponents     derived.rs
//!   -> verdicts                      one claim a file         verdicts/
//!   -> tables, figures, report       Markdown, CSV, SVG       render/
//! ```
//!
//! Counting and timing are runs of their own, and nothing is counted or timed that is not certified. A verdict
//! sees records only, never a clock or an algorithm.

mod definition;
mod derived;
mod experiments;
mod published;
mod records;
mod render;
mod topics;
mod verdicts;

use super::paper::{Judged, Paper, Request};
use super::provenance::Provenance;
use super::render::folder::Folder;
use super::verdict::Verdict;
use anyhow::Result;
use definition::{Definition, PAPER};
use published::Published;
use records::Records;
use std::time::Instant;
use topics::{Experiment, Topic};

/// The paper, for the list of papers.
pub(super) const BALAN_MUNJAL_RAO: Paper = Paper {
    slug: PAPER,
    title: "Balan, Munjal & Rao",
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
    if needed(Experiment::Counts) {
        experiments::counts::run(definition, &mut records)?;
    }
    if needed(Experiment::Merges) {
        experiments::merges::run(definition, &mut records)?;
    }
    if needed(Experiment::Orders) {
        experiments::orders::run(definition, &mut records)?;
    }
    if needed(Experiment::Angles) {
        experiments::angles::run(definition, &mut records)?;
    }
    if needed(Experiment::Times) {
        experiments::times::run(definition, &mut records)?;
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
    let mut verdicts = Vec::new();
    for topic in topics {
        match topic {
            Topic::Counts => render::tables::write_counts(folder, records)?,
            Topic::Times => render::tables::write_times(folder, records, published)?,
            Topic::Angles => render::angles::write(folder, records)?,
            Topic::Visibility => render::figures::write_visibility(folder, records)?,
            Topic::Orders => render::figures::write_orders(folder, records)?,
            Topic::Evaluations => render::figures::write_evaluations(folder, records)?,
            Topic::Claim(id) => verdicts.extend(verdicts::judge(id, records)),
        }
    }
    let predictions = verdicts::predictions::check(records, published);
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
