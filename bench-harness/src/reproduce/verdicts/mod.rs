//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

mod gs1;
mod gs2;
mod gs3;
mod gs4;
mod gs5;
mod gs6;
mod gs7;
mod gs8;
mod gs9;
#[cfg(test)]
mod made_up;
pub(crate) mod predictions;

pub(crate) use gs5::{limit_from_above, limit_from_below};

use super::published::Published;
use super::records::Records;
use std::fmt;

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    Confirmed,
    CountsOnly,
    Refuted,
    NotDistinguishable,
    NotTestable,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Outcome::Confirmed => "CONFIRMED",
            Outcome::CountsOnly => "CONFIRMED IN COUNTS, NOT IN TIME",
            Outcome::Refuted => "REFUTED",
            Outcome::NotDistinguishable => "NOT DISTINGUISHABLE ON THIS RANGE",
            Outcome::NotTestable => "NOT TESTABLE",
        })
    }
}

/// One thing that a claim says, and what became of it.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    /// What is tested.
    pub(crate) what: String,
    pub(crate) outcome: Outcome,
    /// The numbers.
    pub(crate) statistic: String,
}

impl Part {
    fn new(what: impl Into<String>, outcome: Outcome, statistic: impl Into<String>) -> Self {
        Self {
            what: what.into(),
            outcome,
            statistic: statistic.into(),
        }
    }
}

/// The judgement of a claim.
#[derive(Clone, Debug)]
pub(crate) struct Verdict {
    /// The claim's id.
    pub(crate) id: &'static str,
    pub(crate) outcome: Outcome,
    pub(crate) parts: Vec<Part>,
    /// What else the experiment shows.
    pub(crate) notes: Vec<String>,
}

/// Every claim's id and its judge, in order.
type Judge = fn(&Records, &Published) -> Verdict;
const JUDGES: [(&str, Judge); 9] = [
    ("GS-1", gs1::judge),
    ("GS-2", gs2::judge),
    ("GS-3", gs3::judge),
    ("GS-4", gs4::judge),
    ("GS-5", gs5::judge),
    ("GS-6", gs6::judge),
    ("GS-7", gs7::judge),
    ("GS-8", gs8::judge),
    ("GS-9", gs9::judge),
];

/// The verdict on the claim `id`, if there is such a claim.
pub(crate) fn judge(id: &str, records: &Records, published: &Published) -> Option<Verdict> {
    let (_, judge) = JUDGES.iter().find(|(known, _)| *known == id)?;
    Some(judge(records, published))
}

/// The outcome of a claim that says all of its parts: as bad as the worst.
fn all_of(outcomes: impl IntoIterator<Item = Outcome>) -> Outcome {
    let outcomes: Vec<Outcome> = outcomes.into_iter().collect();
    let worst_first = [
        Outcome::Refuted,
        Outcome::NotDistinguishable,
        Outcome::NotTestable,
        Outcome::CountsOnly,
        Outcome::Confirmed,
    ];
    let found = worst_first
        .into_iter()
        .find(|outcome| outcomes.contains(outcome));
    found.unwrap_or(Outcome::NotTestable)
}

/// The outcome of a claim about time, tested on counts too. Time decides if it can; a claim that time does
/// not bear out but counts do is confirmed in counts only.
fn with_time(counts: Outcome, time: Outcome) -> Outcome {
    match (counts, time) {
        (_, Outcome::Confirmed) => Outcome::Confirmed,
        (Outcome::Confirmed, _) => Outcome::CountsOnly,
        (_, time) => time,
    }
}

/// `ratio [low, high]` from logarithms.
fn ratio_text(log: f64, interval: (f64, f64)) -> String {
    format!(
        "{:.3} [{:.3}, {:.3}]",
        log.exp(),
        interval.0.exp(),
        interval.1.exp()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_part_decides() {
        use Outcome::{Confirmed, CountsOnly, NotDistinguishable, NotTestable, Refuted};
        assert_eq!(all_of([Confirmed, Confirmed]), Confirmed);
        assert_eq!(all_of([Confirmed, CountsOnly]), CountsOnly);
        assert_eq!(all_of([Confirmed, NotDistinguishable, Refuted]), Refuted);
        assert_eq!(all_of([]), NotTestable);
        assert_eq!(with_time(Confirmed, Refuted), CountsOnly);
        assert_eq!(with_time(Refuted, Confirmed), Confirmed);
        assert_eq!(with_time(Refuted, NotDistinguishable), NotDistinguishable);
    }

    #[test]
    fn without_records_nothing_is_testable() {
        let published = Published::load().expect("valid");
        for (id, _) in JUDGES {
            let verdict = judge(id, &Records::default(), &published).expect("a claim");
            assert_eq!(verdict.outcome, Outcome::NotTestable, "{id}");
            assert_eq!(verdict.id, id);
            assert!(published.claim(id).is_some());
        }
    }
}
