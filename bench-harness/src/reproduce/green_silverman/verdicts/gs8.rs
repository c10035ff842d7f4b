//! GS-8: collinear points on the boundary count as vertices.

use super::gs5::RINGS;
use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::green_silverman::published::Published;
use crate::reproduce::green_silverman::records::{Records, RingRow};

pub(super) fn judge(records: &Records, _: &Published) -> Verdict {
    let parts = vec![with_all(records), with_corners(records)];
    verdict("GS-8", parts, Vec::new())
}

fn rows<'a>(records: &'a Records, boundary: &'a str) -> Vec<&'a RingRow> {
    records
        .own
        .rings
        .iter()
        .filter(|row| row.boundary == boundary)
        .collect()
}

fn with_all(records: &Records) -> Part {
    let what = format!("counted as vertices, a 10 by 10 lattice peels off in rings of {RINGS}");
    let rows = rows(records, "all");
    let right = rows
        .iter()
        .filter(|row| row.certified && row.rings == RINGS)
        .count();
    Part::new(
        what,
        of(right, rows.len()),
        format!("{right} of {} certified peelings", rows.len()),
    )
}

fn with_corners(records: &Records) -> Part {
    let what = "not counted, it does not: the convention matters";
    let rows = rows(records, "extreme");
    let other = rows
        .iter()
        .filter(|row| row.certified && row.rings != RINGS)
        .count();
    let example = rows.first().map_or(String::new(), |row| {
        format!("; {}: rings of {}", row.distribution, row.rings)
    });
    Part::new(
        what,
        of(other, rows.len()),
        format!("{other} of {} certified peelings{example}", rows.len()),
    )
}

fn of(hits: usize, all: usize) -> Outcome {
    match (hits, all) {
        (_, 0) => Outcome::NotTestable,
        (hits, all) if hits == all => Outcome::Confirmed,
        _ => Outcome::Refuted,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::green_silverman::records::Studied;

    fn verdict(all: &str, extreme: &str, certified: bool) -> Outcome {
        let row = |boundary: &str, rings: &str| RingRow {
            distribution: "lattice".into(),
            n: 100,
            boundary: boundary.into(),
            method: "gs-peel".into(),
            rings: rings.into(),
            certified,
        };
        let records = Records::from(Studied {
            rings: vec![row("all", all), row("extreme", extreme)],
            ..Studied::default()
        });
        judge(&records, &Published::load().expect("valid")).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(RINGS, "4 8 8", true), Outcome::Confirmed);
        assert_eq!(verdict("4 8 8", "4 8 8", true), Outcome::Refuted);
        assert_eq!(verdict(RINGS, RINGS, true), Outcome::Refuted);
        assert_eq!(verdict(RINGS, "4 8 8", false), Outcome::Refuted);
    }
}
