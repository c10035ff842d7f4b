//! B-5: the worst order of insertion.

use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::balan::records::Records;
use crate::reproduce::balan::studies::orders::{AS_GIVEN, SHUFFLED};
use crate::reproduce::rows::CountRow;
use crate::reproduce::space::growth::{against_n, at_largest, does_not_rise, grows_as};

pub(super) fn judge(records: &Records) -> Verdict {
    let facets = |order: &'static str| {
        let rows = records.counts.iter().filter(move |row| row.method == order);
        against_n(rows, |row: &CountRow| row.facets as f64)
    };
    let (given, shuffled) = (facets(AS_GIVEN), facets(SHUFFLED));
    let a_point: Vec<(f64, f64)> = shuffled.iter().map(|(n, y)| (*n, y / n)).collect();
    let parts = vec![
        grows_as("order as given: facets made grow as n²", &given, 2.0, 0.03),
        constant(&given),
        does_not_rise(
            "the same points in random order: facets made are O(n)",
            &a_point,
            0.03,
        ),
    ];
    let notes = at_largest(&given)
        .zip(at_largest(&shuffled))
        .map(|(given, shuffled)| {
            format!(
                "n = {}: {:.0} facets made as given, {:.0} in random order, {:.0} times fewer",
                given.0,
                given.1,
                shuffled.1,
                given.1 / shuffled.1
            )
        });
    verdict("B-5", parts, notes.into_iter().collect())
}

/// Whether the facets made in the order as given are n²/4 at the largest n, to one part in a hundred.
fn constant(given: &[(f64, f64)]) -> Part {
    let what = "order as given: n²/4 facets made";
    let Some((n, facets)) = at_largest(given) else {
        return Part::new(what, Outcome::NotTestable, "not counted");
    };
    let ratio = facets / (n * n / 4.0);
    let outcome = if (ratio - 1.0).abs() <= 0.01 {
        Outcome::Confirmed
    } else {
        Outcome::Refuted
    };
    Part::new(what, outcome, format!("{ratio:.4} n²/4 at n = {n}"))
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    fn verdict(given: f64, shuffled: f64) -> Outcome {
        let mut records = Records::default();
        for (order, factor, exponent) in [(AS_GIVEN, 0.25, given), (SHUFFLED, 5.0, shuffled)] {
            made_up::counts(&mut records, &["circle-and-axis"], order, |_, n| CountRow {
                facets: (factor * n.powf(exponent)) as u64,
                ..CountRow::default()
            });
        }
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(2.0, 1.0), Outcome::Confirmed);
        assert_eq!(verdict(1.5, 1.0), Outcome::Refuted);
        assert_eq!(verdict(2.0, 1.5), Outcome::Refuted);
    }
}
