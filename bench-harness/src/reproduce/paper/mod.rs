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

mod asked;
#[cfg(test)]
pub(crate) mod checks;
mod flow;

pub(crate) use asked::Asked;
pub(crate) use flow::{Entry, entry};

use super::data;
use super::render::folder::Folder;
use super::rows::{Records, Tables};
use super::verdict::Verdict;
use crate::definition::Extent;
use anyhow::Result;
use serde::de::DeserializeOwned;
use std::path::Path;

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
