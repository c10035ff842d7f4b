//! What became of a claim: outcomes, and how parts make a whole.

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
    pub(crate) fn new(
        what: impl Into<String>,
        outcome: Outcome,
        statistic: impl Into<String>,
    ) -> Self {
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

/// The verdict on a claim that says all of `parts`.
pub(crate) fn verdict(id: &'static str, parts: Vec<Part>, notes: Vec<String>) -> Verdict {
    Verdict {
        id,
        outcome: all_of(parts.iter().map(|part| part.outcome)),
        parts,
        notes,
    }
}

/// A claim of "always": one case against it refutes it, and it takes a hundred cases to confirm it.
pub(crate) fn always(against: usize, cases: usize) -> Outcome {
    match (against, cases) {
        (_, 0) => Outcome::NotTestable,
        (0, 100..) => Outcome::Confirmed,
        (0, _) => Outcome::NotDistinguishable,
        _ => Outcome::Refuted,
    }
}

/// The outcome of a claim that says all of its parts: as bad as the worst.
pub(crate) fn all_of(outcomes: impl IntoIterator<Item = Outcome>) -> Outcome {
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
pub(crate) fn with_time(counts: Outcome, time: Outcome) -> Outcome {
    match (counts, time) {
        (_, Outcome::Confirmed) => Outcome::Confirmed,
        (Outcome::Confirmed, _) => Outcome::CountsOnly,
        (_, time) => time,
    }
}

/// `ratio [low, high]` from logarithms.
pub(crate) fn ratio_text(log: f64, interval: (f64, f64)) -> String {
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
}
