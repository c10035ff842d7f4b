//! What a paper is to the harness, and how any paper is reproduced.
//!
//! ```text
//! asked for: tables, figures, claims      each names what it needs
//!   -> definitions, measured              data/definitions/PAPER/full/    measure, recorded
//!   -> studies, run                       data/definitions/PAPER/studies.toml
//!   -> records                            rows of CSV                     rows
//!   -> tables and figures; verdicts; predictions; the first page          render
//! ```
//!
//! A paper supplies data: its topics, its claims with their judges, its studies. Counting and timing are runs of their
//! own, and nothing is counted or timed that is not certified. A judge sees records and published figures only,
//! never a clock or an algorithm.

use super::data::{self, Published};
use super::prediction;
use super::provenance::Provenance;
use super::recorded;
use super::render::folder::Folder;
use super::render::{claims, first_page};
use super::rows::{Records, Tables};
use super::verdict::Verdict;
use crate::definition::{Definition, Extent};
use crate::{failure::Failure, measure};
use anyhow::Result;
use serde::de::DeserializeOwned;
use std::path::Path;
use std::time::Instant;

/// A paper that can be reproduced.
pub(crate) trait Paper: Sized + 'static {
    /// Its folder below `data/published`, `data/definitions` and the reports.
    const SLUG: &'static str;
    /// Authors and year.
    const TITLE: &'static str;
    /// What it is, and what is made of it here: the first words of the report.
    const ABOUT: &'static str;

    /// What its studies run on, as its `studies.toml` says it.
    type Studies: DeserializeOwned;
    /// The rows that its studies leave behind.
    type Rows: Tables;
    /// The figures it prints.
    type Figures;

    /// The tables and figures.
    const TOPICS: &'static [Topic<Self>];
    /// The claims, in the order of its `claims.toml`.
    const CLAIMS: &'static [Claim<Self>];
    /// The studies, in the order in which they run: experiments that no definition can express.
    const STUDIES: &'static [Study<Self>];

    /// The seed from which every set of the studies is derived.
    fn seed(studies: &mut Self::Studies) -> &mut u64;

    /// What a reader should know of the choice of sets and sizes.
    fn analysis(studies: &Self::Studies) -> &str;

    /// Reads the figures it prints.
    fn figures() -> Result<Self::Figures>;

    /// The value of what the prediction called `id` is about.
    fn measure(id: &str, records: &Records<Self::Rows>) -> Option<f64>;

    /// What the studies proved beyond sets and sizes, in words.
    fn certificates(_: &Records<Self::Rows>) -> Option<String> {
        None
    }
}

/// A table or a figure.
pub(crate) struct Topic<P: Paper> {
    /// The name it is asked for by.
    pub(crate) name: &'static str,
    /// The definitions and studies it is computed from.
    pub(crate) needs: &'static [&'static str],
    pub(crate) write: fn(&Folder, &Findings<P>) -> Result<()>,
    /// Its line on the first page, with links.
    pub(crate) line: &'static str,
}

/// A claim and its judge.
pub(crate) struct Claim<P: Paper> {
    pub(crate) id: &'static str,
    /// The definitions and studies it is judged by.
    pub(crate) needs: &'static [&'static str],
    pub(crate) judge: fn(&Records<P::Rows>, &P::Figures) -> Verdict,
}

impl<P: Paper> Claim<P> {
    pub(crate) const fn new(
        id: &'static str,
        needs: &'static [&'static str],
        judge: fn(&Records<P::Rows>, &P::Figures) -> Verdict,
    ) -> Self {
        Self { id, needs, judge }
    }
}

/// An experiment that no definition can express.
pub(crate) struct Study<P: Paper> {
    pub(crate) name: &'static str,
    pub(crate) run: fn(&P::Studies, &mut Records<P::Rows>) -> Result<()>,
}

impl<P: Paper> Study<P> {
    pub(crate) const fn new(
        name: &'static str,
        run: fn(&P::Studies, &mut Records<P::Rows>) -> Result<()>,
    ) -> Self {
        Self { name, run }
    }
}

/// What tables and figures are made from.
pub(crate) struct Findings<P: Paper> {
    pub(crate) studies: P::Studies,
    pub(crate) records: Records<P::Rows>,
    pub(crate) figures: P::Figures,
}

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request<'a> {
    /// Names from the paper's `ids`; none stands for all.
    pub(crate) ids: &'a [String],
    pub(crate) extent: Extent,
    /// The seed, if not the definition's.
    pub(crate) seed: Option<u64>,
    /// The folder of this paper's report.
    pub(crate) folder: &'a Path,
    /// The command that asks for it, for the head of every file.
    pub(crate) command: &'a str,
}

/// What came of it.
#[derive(Clone, Debug)]
pub(crate) struct Judged {
    /// The verdicts, in the order of the claims.
    pub(crate) verdicts: Vec<Verdict>,
    /// The paper's claims.
    pub(crate) claims: Vec<data::Claim>,
    /// How many results have no certificate.
    pub(crate) uncertified: usize,
}

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
        ids: ids::<P>,
        run: run::<P>,
    }
}

/// The name that stands for all claims.
const ALL_CLAIMS: &str = "claims";

fn ids<P: Paper>() -> Vec<&'static str> {
    let topics = P::TOPICS.iter().map(|topic| topic.name);
    let claims = P::CLAIMS.iter().map(|claim| claim.id);
    topics.chain([ALL_CLAIMS]).chain(claims).collect()
}

fn run<P: Paper>(request: &Request<'_>) -> Result<Judged> {
    let started = Instant::now();
    let published = Published::load(P::SLUG)?;
    let figures = P::figures()?;
    let mut studies: P::Studies = data::studies(P::SLUG, request.extent)?;
    let seed = P::seed(&mut studies);
    *seed = request.seed.unwrap_or(*seed);
    let mut provenance = Provenance::collect(request.command.to_owned(), Some(*seed));
    let asked = Asked::<P>::of(request.ids)?;
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

/// The topics and claims that are asked for.
pub(crate) struct Asked<P: Paper> {
    pub(crate) topics: Vec<&'static Topic<P>>,
    pub(crate) claims: Vec<&'static Claim<P>>,
}

impl<P: Paper> Asked<P> {
    /// Those called `ids`, all if there are none. Case does not matter.
    ///
    /// # Errors
    ///
    /// An id that names nothing.
    fn of(ids: &[String]) -> Result<Self> {
        if let Some(id) = ids.iter().find(|id| !knows::<P>(id)) {
            return Err(Failure::Usage(format!(
                "nothing to reproduce is called '{id}'; there are {}",
                self::ids::<P>().join(", ")
            ))
            .into());
        }
        let called = |name: &str| ids.iter().any(|id| id.eq_ignore_ascii_case(name));
        let all = ids.is_empty();
        let topics = P::TOPICS.iter().filter(|topic| all || called(topic.name));
        let all = all || called(ALL_CLAIMS);
        let claims = P::CLAIMS.iter().filter(|claim| all || called(claim.id));
        Ok(Self {
            topics: topics.collect(),
            claims: claims.collect(),
        })
    }

    /// Whether the definition or study called `name` is needed.
    fn needs(&self, name: &str) -> bool {
        let topics = self.topics.iter().map(|topic| topic.needs);
        let mut needs = topics.chain(self.claims.iter().map(|claim| claim.needs));
        needs.any(|needs| needs.contains(&name))
    }
}

fn knows<P: Paper>(id: &str) -> bool {
    ids::<P>()
        .iter()
        .any(|known| known.eq_ignore_ascii_case(id))
}

/// What must hold of every paper.
#[cfg(test)]
pub(crate) mod checks {
    use super::*;
    use crate::reproduce::data::EXTENTS;
    use crate::reproduce::verdict::Outcome;
    use std::collections::BTreeMap;

    /// All of it.
    pub(crate) fn all<P: Paper>() {
        names::<P>();
        needs::<P>();
        claims::<P>();
        let held = predictions::<P>(&Records::default());
        assert!(
            held.values().all(Option::is_none),
            "measured without records: {held:?}"
        );
    }

    /// Whether each prediction holds of `records`, by id.
    pub(crate) fn predictions<P: Paper>(
        records: &Records<P::Rows>,
    ) -> BTreeMap<String, Option<bool>> {
        let predictions = Published::load(P::SLUG).expect("valid").predictions;
        let checked = prediction::check(&predictions, |id| P::measure(id, records));
        let held = checked
            .iter()
            .map(|checked| (checked.prediction.id.clone(), checked.held()));
        held.collect()
    }

    /// Claims are those of the paper's file, and without records nothing is testable.
    fn claims<P: Paper>() {
        let published = Published::load(P::SLUG).expect("valid");
        let ids: Vec<&str> = published
            .claims
            .iter()
            .map(|claim| claim.id.as_str())
            .collect();
        let judged: Vec<&str> = P::CLAIMS.iter().map(|claim| claim.id).collect();
        assert_eq!(ids, judged);
        let (records, figures) = (Records::default(), P::figures().expect("valid"));
        for claim in P::CLAIMS {
            let verdict = (claim.judge)(&records, &figures);
            assert_eq!(
                (verdict.id, verdict.outcome),
                (claim.id, Outcome::NotTestable)
            );
        }
    }

    /// What is needed is a definition of both extents or a study, and each of these is needed.
    fn needs<P: Paper>() {
        let asked = Asked::<P>::of(&[]).expect("all");
        let topics = asked.topics.iter().flat_map(|topic| topic.needs);
        let needs = topics.chain(asked.claims.iter().flat_map(|claim| claim.needs));
        let needs: Vec<&str> = needs.copied().collect();
        for extent in EXTENTS {
            let mut studies: P::Studies = data::studies(P::SLUG, extent).expect("valid");
            let seed = *P::seed(&mut studies);
            assert!(!P::analysis(&studies).is_empty());
            let definitions = Definition::of_paper(P::SLUG, extent).expect("valid");
            let seeds = definitions.iter().map(|definition| definition.seed);
            assert!(seeds.into_iter().all(|other| other == seed));
            let mut names: Vec<&str> = P::STUDIES.iter().map(|study| study.name).collect();
            names.extend(definitions.iter().map(|definition| definition.id.as_str()));
            assert!(names.iter().all(|name| asked.needs(name)), "{names:?}");
            assert!(needs.iter().all(|need| names.contains(need)), "{needs:?}");
        }
    }

    /// Names are found whatever their case.
    fn names<P: Paper>() {
        let of = |ids: &[&str]| {
            let ids: Vec<String> = ids.iter().map(|id| (*id).to_owned()).collect();
            Asked::<P>::of(&ids).map(|asked| (asked.topics.len(), asked.claims.len()))
        };
        let topic = P::TOPICS[0].name.to_ascii_uppercase();
        let claim = P::CLAIMS[0].id.to_ascii_lowercase();
        assert_eq!(of(&[&topic, &claim]).expect("known"), (1, 1));
        assert_eq!(of(&["claims"]).expect("known"), (0, P::CLAIMS.len()));
        assert_eq!(of(&[]).expect("all"), (P::TOPICS.len(), P::CLAIMS.len()));
        assert!(of(&["table99"]).is_err());
    }
}
