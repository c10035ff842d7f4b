//! Which law the data stand for, or that they do not say.

use super::Observation;
use super::fit::{Fit, fit, fit_with};
use super::law::{Law, Lower};
use crate::stats::runs_test::too_few_runs;
use crate::stats::summary::mean;
use std::fmt;

/// With fewer sizes nothing can be foretold.
pub const FEWEST_SIZES: usize = 5;

/// AICc must prefer a law by more than this.
pub const PREFERRED_BY: f64 = 10.0;

/// The part of the sizes, from below, that foretells the rest.
const LOWER_PART: f64 = 0.7;

/// A law whose own term surely is less than this part of its cost at the largest size is a correction of another.
const CORRECTION: f64 = 0.05;

/// A pattern in what is left over matters if it is more than this part of the cost, by its root mean square.
const PATTERN: f64 = 0.005;

/// A law in h that a law in n follows this closely on these sets, by the root mean square, is the same there.
const SAME_LAW: f64 = 0.01;

/// h must vary by more than this factor for laws in h to be laws of their own.
const H_VARIES: f64 = 1.05;

/// What the data say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// They grow by this law.
    Law {
        /// The law.
        law: Law,
        /// Laws in h that are the same on these sets, whose h is a power of n.
        same_here: Vec<Law>,
    },
    /// They do not say.
    NotDistinguishable(Reason),
}

/// Why no law is declared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// There are too few sizes.
    TooFewSizes,
    /// No law fits at all.
    NoFit,
    /// These fit about as well as each other.
    Close(Vec<Law>),
    /// The first fits best, but the second foretells the large sizes better.
    Foretold(Law, Law),
    /// This one fits best, but what is left over has a pattern: it is not the law.
    Pattern(Law),
}

/// A law, how it fits and what it foretells.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// Fitted to everything.
    pub fit: Fit,
    /// By how much its AICc is worse than the best one's among the laws in play.
    pub behind: f64,
    /// The root mean square of ln (measured / foretold) at the upper sizes, when fitted to the lower ones; `None` if it
    /// cannot be fitted to them.
    pub foretold: Option<f64>,
    /// Which part of its cost at the largest size is its own term.
    pub share: f64,
    /// Whether its own term is a mere correction there, so that it is none of its name.
    pub is_correction: bool,
    /// The probability of residuals in as few runs.
    pub runs_p: f64,
}

/// All candidates and the verdict.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Every law that could be fitted, the best first.
    pub candidates: Vec<Candidate>,
    /// What the data say.
    pub verdict: Verdict,
    /// The different sizes, from below.
    pub sizes: Vec<f64>,
}

/// Fits every law to `data`, lets the lower sizes foretell the upper ones, and judges.
///
/// Time O(laws · data).
pub fn choose(data: &[Observation]) -> Choice {
    let mut data = data.to_vec();
    data.sort_unstable_by(|a, b| a.n.total_cmp(&b.n));
    let sizes: Vec<f64> = by_size(&data).map(|group| group[0].n).collect();
    let mut candidates = candidates(&data, &sizes);
    let best = candidates
        .iter()
        .filter(|candidate| !candidate.is_correction)
        .map(|candidate| candidate.fit.aicc)
        .fold(f64::INFINITY, f64::min);
    for candidate in &mut candidates {
        candidate.behind = candidate.fit.aicc - best;
    }
    candidates.sort_by(|a, b| a.fit.aicc.total_cmp(&b.fit.aicc));
    let verdict = judge(&candidates, &data, sizes.len());
    Choice {
        candidates,
        verdict,
        sizes,
    }
}

fn candidates(data: &[Observation], sizes: &[f64]) -> Vec<Candidate> {
    let Some(largest) = data.last() else {
        return Vec::new();
    };
    let lower_count = (LOWER_PART * sizes.len() as f64).ceil() as usize;
    let border = sizes.get(lower_count).copied().unwrap_or(f64::INFINITY);
    let (lower, upper) = data.split_at(data.partition_point(|place| place.n < border));
    let with_h = h_varies(data);
    let laws = Law::ALL.into_iter().filter(|law| with_h || !law.is_in_h());
    let candidate = |law: Law| {
        let whole = fit(law, data)?;
        let (share, error) = whole.share(largest)?;
        let foretold = fit(law, lower)
            .filter(|_| !upper.is_empty())
            .map(|part| root_mean_square(&residuals_by_size(&part, upper)));
        Some(Candidate {
            fit: whole,
            behind: 0.0,
            foretold,
            share,
            is_correction: share.abs() + 2.0 * error < CORRECTION,
            runs_p: too_few_runs(&residuals_by_size(&whole, data)),
        })
    };
    laws.filter_map(candidate).collect()
}

fn judge(candidates: &[Candidate], data: &[Observation], sizes: usize) -> Verdict {
    if sizes < FEWEST_SIZES {
        return Verdict::NotDistinguishable(Reason::TooFewSizes);
    }
    let in_play: Vec<&Candidate> = candidates.iter().filter(|c| !c.is_correction).collect();
    let Some((best, others)) = in_play.split_first() else {
        return Verdict::NotDistinguishable(Reason::NoFit);
    };
    let law = best.fit.law;
    let is_alias = |other: &&&Candidate| are_same_here(other.fit.law, law, data);
    let close = others.iter().filter(|other| other.behind <= PREFERRED_BY);
    let (aliases, rivals): (Vec<&&Candidate>, Vec<&&Candidate>) = close.partition(is_alias);
    if !rivals.is_empty() {
        let mut laws: Vec<Law> = rivals.iter().map(|rival| rival.fit.law).collect();
        laws.push(law);
        laws.sort_unstable();
        return Verdict::NotDistinguishable(Reason::Close(laws));
    }
    let error = |candidate: &&&Candidate| candidate.foretold.unwrap_or(f64::INFINITY);
    if let Some(seer) = in_play.iter().min_by(|a, b| error(a).total_cmp(&error(b)))
        && seer.fit.law != law
        && !is_alias(&seer)
    {
        return Verdict::NotDistinguishable(Reason::Foretold(law, seer.fit.law));
    }
    let left_over = root_mean_square(&residuals_by_size(&best.fit, data));
    if best.runs_p <= 0.05 && left_over > PATTERN {
        return Verdict::NotDistinguishable(Reason::Pattern(law));
    }
    // Of one curve with two names, the law in n is declared.
    let mut names: Vec<Law> = aliases.iter().map(|alias| alias.fit.law).collect();
    names.push(law);
    names.sort_unstable_by_key(|name| (name.is_in_h(), *name));
    Verdict::Law {
        law: names[0],
        same_here: names.split_off(1),
    }
}

/// The observations of each size; `data` is sorted by size.
fn by_size(data: &[Observation]) -> impl Iterator<Item = &[Observation]> {
    data.chunk_by(|a, b| a.n.total_cmp(&b.n).is_eq())
}

/// The mean residual at each size.
fn residuals_by_size(fit: &Fit, data: &[Observation]) -> Vec<f64> {
    let residual = |group: &[Observation]| {
        let values: Vec<f64> = group.iter().map(|place| fit.residual(place)).collect();
        mean(&values)
    };
    by_size(data).map(residual).collect()
}

fn root_mean_square(values: &[f64]) -> f64 {
    let squares: f64 = values.iter().map(|value| value * value).sum();
    (squares / values.len() as f64).sqrt()
}

/// Whether one of the two is in h and the other, with a term of lower order, follows it at every size: on a set whose h
/// is c n^p, n log h is n log n with a term in n.
fn are_same_here(one: Law, other: Law, data: &[Observation]) -> bool {
    let (in_h, in_n) = match (one.is_in_h(), other.is_in_h()) {
        (true, false) => (one, other),
        (false, true) => (other, one),
        _ => return false,
    };
    let as_cost = |place: &Observation| {
        let cost = in_h.at(place)?;
        Some(Observation { cost, ..*place })
    };
    let Some(values) = data.iter().map(as_cost).collect::<Option<Vec<_>>>() else {
        return false;
    };
    let follows = |lower: &Lower| {
        let found = fit_with(in_n, *lower, &values);
        found.is_some_and(|fit| root_mean_square(&residuals_by_size(&fit, &values)) < SAME_LAW)
    };
    in_n.lower_terms().iter().any(follows)
}

fn h_varies(data: &[Observation]) -> bool {
    let logs: Option<Vec<f64>> = data.iter().map(|place| place.h.map(f64::ln)).collect();
    let Some(logs) = logs else { return false };
    let least = logs.iter().copied().fold(f64::INFINITY, f64::min);
    let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most - least > H_VARIES.ln()
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Verdict::Law { law, same_here } if same_here.is_empty() => write!(f, "{law}"),
            Verdict::Law { law, same_here } => {
                write!(f, "{law} (on these sets the same as {})", list(same_here))
            }
            Verdict::NotDistinguishable(reason) => {
                write!(f, "not distinguishable on this range: {reason}")
            }
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::TooFewSizes => write!(f, "fewer than {FEWEST_SIZES} sizes"),
            Reason::NoFit => f.write_str("no law fits"),
            Reason::Close(laws) => write!(f, "{} fit alike", list(laws)),
            Reason::Foretold(fits, seer) => write!(
                f,
                "{fits} fits best, but {seer} foretells the large sizes from the small ones best"
            ),
            Reason::Pattern(law) => {
                write!(f, "{law} fits best, but what it leaves over has a pattern")
            }
        }
    }
}

fn list(laws: &[Law]) -> String {
    let names: Vec<String> = laws.iter().map(Law::to_string).collect();
    names.join(", ")
}
