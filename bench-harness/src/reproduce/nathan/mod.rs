//! Nathan 2015.
//!
//! The same pipeline as for every paper:
//!
//! ```text
//! definition, claims                 data/…                   definition.rs, published.rs
//!   -> point sets                    seed and fingerprint     sets.rs
//!   -> certified, counted, timed     one experiment a file    experiments/, surface.rs
//!   -> records                       rows of CSV              records.rs
//!   -> verdicts                      one claim a file         verdicts/
//!   -> tables, figures, report       Markdown, CSV, SVG       render/
//! ```
//!
//! The paper prints a method, advice, and one picture, but no measurements. So what there is to reproduce are its
//! claims, and each is put to a test that could come out otherwise.

mod definition;
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
use std::time::Instant;
use topics::{Experiment, Topic};

/// The paper, for the list of papers.
pub(super) const NATHAN: Paper = Paper {
    slug: PAPER,
    title: "Nathan (2015)",
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

/// An experiment as a function.
type Run = fn(&Definition, &mut Records) -> Result<()>;

/// Every experiment, in the order in which they run.
const EXPERIMENTS: [(Experiment, Run); 8] = [
    (Experiment::Wraps, experiments::wraps::run),
    (Experiment::Starts, experiments::starts::run),
    (Experiment::Epsilon, experiments::epsilon::run),
    (Experiment::Lifting, experiments::lifting::run),
    (Experiment::Sweep, experiments::sweep::run),
    (Experiment::Sizes, experiments::sizes::run),
    (Experiment::Corners, experiments::times::own_corners),
    (Experiment::Methods, experiments::times::methods),
];

/// Runs what `topics` need, each experiment once.
fn experiment(definition: &Definition, topics: &[Topic]) -> Result<Records> {
    let mut records = Records::default();
    for (experiment, run) in EXPERIMENTS {
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
    for topic in topics {
        match topic {
            Topic::Wraps => render::wraps::write(folder, records)?,
            Topic::Epsilon => render::epsilon::write(folder, records)?,
            Topic::Times => render::times::write(folder, records)?,
            Topic::Figure1 => render::figure1::write(folder, definition)?,
            Topic::Lifting => render::lifting::write(folder, records)?,
            Topic::Sweep => render::sweep::write(folder, &definition.sweep, records)?,
            Topic::Sizes => render::sizes::write(folder, records)?,
            Topic::Claim(_) => {}
        }
    }
    let judge = |topic: &Topic| match topic {
        Topic::Claim(id) => verdicts::judge(id, records),
        _ => None,
    };
    let verdicts: Vec<Verdict> = topics.iter().filter_map(judge).collect();
    let predictions: Vec<Checked<'_>> = verdicts::predictions::check(records, published);
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
