//! N-6: it is faster to test a triangle's own corners than to skip them by their indices.

use super::{Outcome, Part, Verdict, verdict};
use crate::records::rows::twin;
use crate::reproduce::nathan::records::Records;
use crate::reproduce::nathan::studies::corners::arm;
use crate::reproduce::ratio::time_ratio;
use crate::reproduce::verdict::ratio_text;
use crate::stats::interval::{Place, equivalence};
use gift_wrap::nathan::OwnCorners;

/// A share of the time that makes no difference.
pub(crate) const CELL_MARGIN: f64 = 0.02;

pub(super) fn judge(records: &Records) -> Verdict {
    let mut cells: Vec<(String, usize)> = Vec::new();
    let printed = arm("printed", OwnCorners::Tested);
    for row in records.times.iter().filter(|row| row.method == printed) {
        let cell = (row.distribution.clone(), row.n);
        if !cells.contains(&cell) {
            cells.push(cell);
        }
    }
    let cells = || {
        cells
            .iter()
            .map(|(distribution, n)| (distribution.as_str(), *n))
    };
    let parts = cells().filter_map(|cell| part(records, cell)).collect();
    let notes = cells().flat_map(|cell| [with_exact_answers(records, cell), itself(records, cell)]);
    verdict("N-6", parts, notes.flatten().collect())
}

fn part(records: &Records, cell: (&str, usize)) -> Option<Part> {
    let [tested, skipped] =
        [OwnCorners::Tested, OwnCorners::Skipped].map(|own| arm("printed", own));
    let ratio = time_ratio(&records.times, cell, &tested, &skipped)?;
    let interval = ratio.interval(0.90);
    let outcome = match equivalence(interval, 0.0, CELL_MARGIN.ln_1p()) {
        Place::Outside if interval.1 < 0.0 => Outcome::Confirmed,
        // Slower, or no faster by more than what makes no difference.
        Place::Outside | Place::Within => Outcome::Refuted,
        Place::Across => Outcome::NotDistinguishable,
    };
    Some(Part::new(
        format!(
            "{} {}: testing over skipping, less than 1 by more than 2 %",
            cell.0, cell.1
        ),
        outcome,
        format!("{}, 90 %", ratio_text(ratio.median, interval)),
    ))
}

fn with_exact_answers(records: &Records, cell: (&str, usize)) -> Option<String> {
    let [tested, skipped] = [OwnCorners::Tested, OwnCorners::Skipped].map(|own| arm("exact", own));
    let ratio = time_ratio(&records.times, cell, &tested, &skipped)?;
    Some(format!(
        "{} {}, exact answers in place of the epsilon: testing over skipping {}: no filter settles a point on the plane",
        cell.0,
        cell.1,
        ratio_text(ratio.median, ratio.interval(0.90))
    ))
}

fn itself(records: &Records, cell: (&str, usize)) -> Option<String> {
    let tested = arm("printed", OwnCorners::Tested);
    let itself = time_ratio(&records.times, cell, &twin(&tested), &tested)?;
    Some(format!(
        "{} {}: testing against itself {}: what this machine can resolve",
        cell.0,
        cell.1,
        ratio_text(itself.median, itself.interval(0.90))
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::rows::TimeRow;
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    fn outcome(tested: f64, noise: f64) -> Outcome {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        let mut records = Records::default();
        for realisation in 0..5 {
            for round in 0..7 {
                for (own, factor) in [(OwnCorners::Tested, tested), (OwnCorners::Skipped, 1.0)] {
                    let wobble = 1.0 + noise * (2.0 * random.random::<f64>() - 1.0);
                    records.times.push(TimeRow {
                        distribution: "ball".to_owned(),
                        n: 100,
                        realisation,
                        round,
                        method: arm("printed", own),
                        calls: 1,
                        nanoseconds: (1e6 * factor * wobble) as u64,
                    });
                }
            }
        }
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(outcome(0.9, 0.001), Outcome::Confirmed);
        assert_eq!(outcome(1.0, 0.001), Outcome::Refuted);
        assert_eq!(outcome(1.1, 0.001), Outcome::Refuted);
        assert_eq!(outcome(0.98, 0.3), Outcome::NotDistinguishable);
    }
}
