//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

#[cfg(test)]
mod made_up;
mod n1;
mod n2;
mod n3;
mod n4;
mod n5;
mod n6;
mod n7;
mod n8;
pub(crate) mod predictions;

pub(crate) use n6::CELL_MARGIN;

use super::records::{Records, WrapRow};
use crate::reproduce::verdict::{Outcome, Part, Verdict, all_of};

/// Every claim's id and its judge, in order.
type Judge = fn(&Records) -> Verdict;
const JUDGES: [(&str, Judge); 8] = [
    ("N-1", n1::judge),
    ("N-2", n2::judge),
    ("N-3", n3::judge),
    ("N-4", n4::judge),
    ("N-5", n5::judge),
    ("N-6", n6::judge),
    ("N-7", n7::judge),
    ("N-8", n8::judge),
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

/// The wraps of one variant of sets in one order.
fn wraps<'a>(
    records: &'a Records,
    order: &'a str,
    variant: &'a str,
) -> impl Iterator<Item = &'a WrapRow> {
    let rows = records.wraps.iter();
    rows.filter(move |row| row.order == order && row.variant == variant)
}

/// The distributions of `rows`, each once, in the order of the alphabet.
fn distributions<'a>(rows: impl Iterator<Item = &'a WrapRow>) -> Vec<&'a str> {
    let mut names: Vec<&str> = rows.map(|row| row.distribution.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// The distinct values, smallest first.
fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_unstable_by(f64::total_cmp);
    values.dedup();
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::nathan::published::Published;

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
