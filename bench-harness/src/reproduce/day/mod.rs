//! Day (1990).
//!
//! A report on making an algorithm run, without tables: what it says in words is measured, and each statement judged. The
//! pipeline is that of every paper:
//!
//! ```text
//! definition, claims                 data/…                   definition.rs, published.rs
//!   -> certified, counted, timed     one experiment a file    experiments/
//!   -> records                       rows of CSV              records.rs
//!   -> derived quantities            thresholds, exponents    derived.rs
//!   -> verdicts                      one claim a file         verdicts/
//!   -> tables, figures, report       Markdown, CSV, SVG       render/
//! ```
//!
//! Beside these: the number formats by name (`formats`), the rules of search (`variants`), the paper's own check (`check`),
//! a kernel for several threads (`watch`). Nothing is counted or timed that is not certified. A verdict sees records only,
//! never a clock or an algorithm.

mod check;
mod definition;
mod derived;
mod experiments;
mod formats;
mod published;
mod records;
mod render;
mod sets;
mod topics;
mod variants;
mod verdicts;
mod watch;

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
pub(super) const DAY: Paper = Paper {
    slug: PAPER,
    title: "Day (1990)",
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
    type Run = fn(&Definition, &mut Records) -> Result<()>;
    let all: [(Experiment, Run); 10] = [
        (Experiment::Precision, experiments::precision::run),
        (Experiment::Speed, experiments::speed::run),
        (Experiment::Merges, experiments::merges::run),
        (Experiment::Bases, experiments::bases::run),
        (Experiment::Counts, experiments::counts::run),
        (Experiment::Battery, experiments::battery::run),
        (Experiment::Listing, experiments::listing::run),
        (Experiment::Checks, experiments::checks::run),
        (Experiment::Parallel, experiments::side_by_side::run),
        (Experiment::Times, experiments::times::run),
    ];
    let mut records = Records::default();
    for (experiment, run) in all {
        let needs = |topic: &Topic| topics::experiments(topic).contains(&experiment);
        if topics.iter().any(needs) {
            run(definition, &mut records)?;
        }
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
            Topic::Precision => render::precision::write(folder, records)?,
            Topic::Merge => render::merges::write_merge(folder, records)?,
            Topic::Edges => render::merges::write_edges(folder, records)?,
            Topic::Whole => render::whole::write(folder, records)?,
            Topic::Degenerate => render::others::write_degenerate(folder, records)?,
            Topic::Bases => render::others::write_bases(folder, records)?,
            Topic::Listing => render::others::write_spiral(folder, records)?,
            Topic::Checks => render::others::write_checks(folder, records)?,
            Topic::Parallel => render::others::write_side_by_side(folder, records)?,
            Topic::Claim(id) => verdicts.extend(verdicts::judge(id, records)),
        }
    }
    let predictions = verdicts::predictions::check(records, published);
    if !verdicts.is_empty() {
        render::index::write_claims(folder, &verdicts, &predictions, published)?;
    }
    for (name, text, rows) in records.files()? {
        if rows > 0 {
            folder.csv(&format!("records-{name}"), &text)?;
        }
    }
    render::index::write(
        folder,
        &definition.analysis,
        topics,
        records,
        &verdicts,
        &predictions,
        published,
    )?;
    Ok(verdicts)
}
