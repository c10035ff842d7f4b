//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

mod d1;
mod d10;
mod d11;
mod d2;
mod d3;
mod d4;
mod d5;
mod d6;
mod d7;
mod d8;
mod d9;
#[cfg(test)]
mod made_up;
pub(crate) mod predictions;

use super::records::Records;
use crate::reproduce::verdict::{Outcome, Part, Verdict, all_of};
use crate::stats::wilson;

/// Every claim's id and its judge, in order.
type Judge = fn(&Records) -> Verdict;
const JUDGES: [(&str, Judge); 11] = [
    ("D-1", d1::judge),
    ("D-2", d2::judge),
    ("D-3", d3::judge),
    ("D-4", d4::judge),
    ("D-5", d5::judge),
    ("D-6", d6::judge),
    ("D-7", d7::judge),
    ("D-8", d8::judge),
    ("D-9", d9::judge),
    ("D-10", d10::judge),
    ("D-11", d11::judge),
];

/// The verdict on the claim `id`, if there is such a claim.
pub(crate) fn judge(id: &str, records: &Records) -> Option<Verdict> {
    let (_, judge) = JUDGES.iter().find(|(known, _)| *known == id)?;
    Some(judge(records))
}

/// The verdict on a claim that says all of `parts`.
fn verdict(id: &'static str, parts: Vec<Part>, notes: Vec<String>) -> Verdict {
    Verdict {
        id,
        outcome: all_of(parts.iter().map(|part| part.outcome)),
        parts,
        notes,
    }
}

/// A claim of "always": one case against it refutes it, and it takes a hundred cases to confirm it.
fn always(against: usize, cases: usize) -> Outcome {
    match (against, cases) {
        (_, 0) => Outcome::NotTestable,
        (0, 100..) => Outcome::Confirmed,
        (0, _) => Outcome::NotDistinguishable,
        _ => Outcome::Refuted,
    }
}

/// "k of n, share [Wilson's interval]".
fn share(hits: usize, trials: usize) -> String {
    let (low, high) = wilson::interval(hits, trials);
    format!(
        "{hits} of {trials}, {:.3} [{low:.3}, {high:.3}]",
        hits as f64 / trials.max(1) as f64
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::day::published::Published;

    #[test]
    fn without_records_nothing_is_testable() {
        let published = Published::load().expect("valid");
        for (id, _) in JUDGES {
            let verdict = judge(id, &Records::default()).expect("a claim");
            assert_eq!(verdict.outcome, Outcome::NotTestable, "{id}");
            assert_eq!(verdict.id, id);
            assert!(published.claims.iter().any(|claim| claim.id == id));
        }
        assert_eq!(published.claims.len(), JUDGES.len());
    }
}
