//! How any paper is reproduced.

use super::asked::{self, Asked};
use super::{Findings, Judged, Paper, Request};
use crate::definition::Definition;
use crate::measure;
use crate::provenance::Provenance;
use crate::reproduce::data::{self, Published};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::{claims, first_page};
use crate::reproduce::rows::Records;
use crate::reproduce::verdict::Verdict;
use crate::reproduce::{prediction, recorded};
use anyhow::Result;
use std::time::Instant;

/// A paper behind functions, whatever its types: for the list of papers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry {
    pub(crate) slug: &'static str,
    pub(crate) title: &'static str,
    /// The names of its tables, figures and claims.
    pub(crate) ids: fn() -> Vec<&'static str>,
    /// Runs what the request asks for and writes the report.
    pub(crate) run: fn(&Request<'_>) -> Result<Judged>,
}

/// The entry of the paper `P`.
pub(crate) const fn entry<P: Paper>() -> Entry {
    Entry {
        slug: P::SLUG,
        title: P::TITLE,
        ids: asked::ids::<P>,
        run: run::<P>,
    }
}

fn run<P: Paper>(request: &Request<'_>) -> Result<Judged> {
    let started = Instant::now();
    let published = Published::load(P::SLUG)?;
    let figures = P::figures()?;
    let mut studies: P::Studies = data::studies(P::SLUG, request.extent)?;
    let seed = P::seed(&mut studies);
    *seed = request.seed.unwrap_or(*seed);
    let mut provenance = Provenance::collect(request.command.to_owned(), Some(*seed));
    let asked = Asked::<P>::of(request.ids);
    let mut records = Records::default();
    measured(&asked, request, &mut records)?;
    for study in P::STUDIES.iter().filter(|study| asked.needs(study.name)) {
        (study.run)(&studies, &mut records)?;
    }
    provenance.finish(started.elapsed().as_secs());
    let folder = Folder::open(request.folder.to_owned(), provenance)?;
    let findings = Findings {
        studies,
        records,
        figures,
    };
    let verdicts = report(&folder, &asked, &findings, &published)?;
    Ok(Judged {
        verdicts,
        claims: published.claims,
        uncertified: findings.records.failures.len(),
    })
}

/// Measures the definitions that are needed.
fn measured<P: Paper>(
    asked: &Asked<P>,
    request: &Request<'_>,
    records: &mut Records<P::Rows>,
) -> Result<()> {
    let mut definitions = Definition::of_paper(P::SLUG, request.extent)?;
    definitions.retain(|definition| asked.needs(&definition.id));
    if definitions.is_empty() {
        return Ok(());
    }
    for definition in &mut definitions {
        definition.seed = request.seed.unwrap_or(definition.seed);
    }
    let folder = tempfile::tempdir()?;
    let run = measure::run_into(folder.path(), &definitions, request.command)?;
    recorded::add(&run, &definitions, records);
    Ok(())
}

/// Writes everything that is asked for, and the records. Returns the verdicts.
fn report<P: Paper>(
    folder: &Folder,
    asked: &Asked<P>,
    findings: &Findings<P>,
    published: &Published,
) -> Result<Vec<Verdict>> {
    for topic in &asked.topics {
        (topic.write)(folder, findings)?;
    }
    let Findings {
        records, figures, ..
    } = findings;
    let claims = asked.claims.iter();
    let verdicts: Vec<Verdict> = claims
        .map(|claim| (claim.judge)(records, figures))
        .collect();
    let predictions = prediction::check(&published.predictions, |id| P::measure(id, records));
    if !verdicts.is_empty() {
        claims::write(folder, P::TITLE, &verdicts, &predictions, published)?;
    }
    for (name, text) in records.files()? {
        folder.csv(&format!("records-{name}.csv"), &text)?;
    }
    first_page::write(folder, asked, findings, &verdicts, &predictions, published)?;
    Ok(verdicts)
}
