//! D-10: whether the paper's third stage of testing tells right hulls from wrong ones.

use super::{Part, Verdict, always, verdict};
use crate::reproduce::day::derived::in_order;
use crate::reproduce::day::records::{CheckRow, Records};
use crate::reproduce::day::studies::checks::EXACT;

pub(super) fn judge(records: &Records) -> Verdict {
    let formats = in_order(records.own.checks.iter().map(|row| &row.checked_in));
    let parts: Vec<Part> = formats
        .iter()
        .flat_map(|format| agrees(records, format))
        .collect();
    verdict("D-10", parts, notes(records))
}

fn sum(records: &Records, format: &str, of: fn(&CheckRow) -> usize) -> usize {
    let rows = records.own.checks.iter();
    rows.filter(|row| row.checked_in == format).map(of).sum()
}

/// Whether the check agrees with the certificate, on hulls closed as surfaces.
fn agrees(records: &Records, format: &str) -> [Part; 2] {
    let of = |quantity| sum(records, format, quantity);
    let [right, rejected] = [of(|row| row.right_accepted), of(|row| row.right_rejected)];
    let [missed, wrong] = [of(|row| row.wrong_accepted), of(|row| row.wrong_rejected)];
    let how = if format == EXACT {
        "F(x) by exact orientations".to_owned()
    } else {
        format!("F(x) in {format}")
    };
    [
        Part::new(
            format!("{how} accepts right hulls"),
            always(rejected, right + rejected),
            format!("rejects {rejected} of {}", right + rejected),
        ),
        Part::new(
            format!("{how} rejects wrong hulls"),
            always(missed, missed + wrong),
            format!("accepts {missed} of {}", missed + wrong),
        ),
    ]
}

/// What the check cannot see.
fn notes(records: &Records) -> Vec<String> {
    let right = sum(records, EXACT, |row| {
        row.right_accepted + row.right_rejected
    });
    let holed = sum(records, EXACT, |row| row.holed_accepted);
    let mut notes = Vec::new();
    if right > 0 {
        notes.push(format!(
            "one face left out of a right hull: {holed} of {right} are accepted by exact orientations; the check tests \
             planes, not that the faces close"
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::super::Outcome;
    use super::*;
    use crate::reproduce::day::records::Studied;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |right_rejected, wrong_accepted, wrong_rejected| {
            let row = CheckRow {
                checked_in: EXACT.to_owned(),
                right_accepted: 200,
                right_rejected,
                wrong_accepted,
                wrong_rejected,
                ..CheckRow::default()
            };
            judge(&Records::from(Studied {
                checks: vec![row],
                ..Studied::default()
            }))
            .outcome
        };
        assert_eq!(judged(0, 0, 100), Outcome::Confirmed);
        assert_eq!(judged(1, 0, 100), Outcome::Refuted);
        assert_eq!(judged(0, 1, 100), Outcome::Refuted);
        assert_eq!(judged(0, 0, 5), Outcome::NotDistinguishable);
    }
}
