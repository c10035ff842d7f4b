//! D-4: whether what a search has passed may be set aside.

use super::{Part, Verdict, always, verdict};
use crate::reproduce::day::derived::merged;
use crate::reproduce::day::records::{MergeRow, Records};

pub(super) fn judge(records: &Records) -> Verdict {
    let resumed = || {
        records
            .own
            .merges
            .iter()
            .filter(|row| row.variant == "resumed")
    };
    let merges: u64 = resumed().map(|row| row.merges).sum();
    let against: u64 = resumed().map(|row| row.reexamined).sum();
    let candidates: u64 = resumed().map(|row| row.candidates).sum();
    let statistic = format!(
        "{against} of {candidates} candidates in {merges} merges on the way to {} certified hulls",
        resumed().count()
    );
    let part = Part::new(
        "no candidate is looked at again after a search has passed it, and every hull is right",
        always(against as usize, merges as usize),
        statistic,
    );
    verdict("D-4", vec![part], notes(records))
}

/// How much a search that starts anew looks at again.
fn notes(records: &Records) -> Vec<String> {
    let note = |distribution: &str| {
        let rows = records
            .own
            .merges
            .iter()
            .filter(|row| row.variant == "rescanned" && row.distribution == distribution);
        let largest = rows.max_by_key(|row| row.n)?;
        let MergeRow {
            n,
            candidates,
            reexamined,
            ..
        } = largest;
        Some(format!(
            "{distribution}, n = {n}: with every search anew {reexamined} of {candidates} candidates are looked at again"
        ))
    };
    merged(records, "rescanned")
        .into_iter()
        .filter_map(note)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Outcome, made_up};
    use super::*;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |reexamined, merges| {
            let mut records = Records::default();
            made_up::merges(&mut records, &["ball"], "resumed", |_| MergeRow {
                candidates: 1_000,
                reexamined,
                merges,
                ..MergeRow::default()
            });
            judge(&records).outcome
        };
        assert_eq!(judged(0, 100), Outcome::Confirmed);
        assert_eq!(judged(1, 100), Outcome::Refuted);
        assert_eq!(judged(0, 1), Outcome::NotDistinguishable);
    }
}
