//! What the harness knows of a paper: its name, what can be asked for, and how to reproduce it.

use super::data::Claim;
use super::verdict::Verdict;
use anyhow::Result;
use std::path::Path;

/// A paper that can be reproduced.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Paper {
    /// Its folder below `data/published`, `data/definitions` and the reports.
    pub(crate) slug: &'static str,
    /// Authors and year.
    pub(crate) title: &'static str,
    /// The names of its tables, figures and claims.
    pub(crate) ids: fn() -> Result<Vec<String>>,
    /// Runs what the request asks for and writes the report.
    pub(crate) run: fn(&Request<'_>) -> Result<Judged>,
}

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request<'a> {
    /// Names from the paper's `ids`; none stands for all.
    pub(crate) ids: &'a [String],
    /// Whether the smaller run is wanted.
    pub(crate) quick: bool,
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
    pub(crate) claims: Vec<Claim>,
    /// How many results have no certificate.
    pub(crate) uncertified: usize,
}
