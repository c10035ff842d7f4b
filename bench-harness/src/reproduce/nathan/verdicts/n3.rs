//! N-3: looking for an edge in the array of edges does not spoil O(n h).

use super::{Outcome, Part, Verdict, distributions, verdict, wraps};
use crate::reproduce::nathan::records::{Records, WrapRow};
use crate::stats::line::fit_log_log;
use crate::stats::summary::mean;

/// An exponent up to this is one that does not exceed 1.
const LARGEST: f64 = 1.05;

/// From here on lower terms do not show in an exponent.
const FROM: usize = 64;

pub(super) fn judge(records: &Records) -> Verdict {
    let names = distributions(wraps(records, "random", "printed"));
    let parts = names
        .into_iter()
        .map(|distribution| part(records, distribution));
    let notes = [squares(records), hashed(records), beside_tests(records)];
    verdict(
        "N-3",
        parts.collect(),
        notes.into_iter().flatten().collect(),
    )
}

fn part(records: &Records, distribution: &str) -> Part {
    let what = format!("{distribution}: comparisons of edges grow no faster than n h");
    let rows = wraps(records, "random", "printed");
    let rows = rows.filter(|row| row.distribution == distribution && row.n >= FROM);
    let data: Vec<(f64, f64)> = rows
        .map(|row| ((row.n * row.h) as f64, row.mark_comparisons as f64))
        .collect();
    let Some(line) = fit_log_log(&data) else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "fewer than three runs, or one size",
        );
    };
    let interval = line.slope_interval(0.95);
    let outcome = match interval {
        (_, high) if high <= LARGEST => Outcome::Confirmed,
        (low, _) if low > LARGEST => Outcome::Refuted,
        _ => Outcome::NotDistinguishable,
    };
    Part::new(
        what,
        outcome,
        format!(
            "exponent of n h {:.3} [{:.3}, {:.3}], 95 %",
            line.slope, interval.0, interval.1
        ),
    )
}

/// Comparisons as printed over the square of the number of edges, at the largest sizes.
pub(super) fn share_of_square(records: &Records) -> Option<f64> {
    let most = wraps(records, "random", "printed").map(|row| row.h).max()?;
    let rows = wraps(records, "random", "printed").filter(|row| 2 * row.h > most);
    let share = |row: &WrapRow| row.mark_comparisons as f64 / (3.0 * row.h as f64 - 6.0).powi(2);
    Some(mean(&rows.map(share).collect::<Vec<f64>>()))
}

fn squares(records: &Records) -> Option<String> {
    let share = share_of_square(records)?;
    Some(format!(
        "the array is searched from the front: {share:.3} (3h - 6)² comparisons at the largest h, O(h²), which is within \
         O(n h) only because h is at most n"
    ))
}

fn hashed(records: &Records) -> Option<String> {
    let rows = wraps(records, "random", "corrected");
    let an_edge = |row: &WrapRow| row.mark_comparisons as f64 / (3.0 * row.h as f64 - 6.0);
    let most = rows.map(an_edge).reduce(f64::max)?;
    Some(format!(
        "in a hash table: at most {most:.2} look-ups an edge"
    ))
}

fn beside_tests(records: &Records) -> Option<String> {
    let rows = wraps(records, "random", "printed").filter(|row| row.n >= FROM);
    let most = rows
        .map(|row| row.mark_comparisons as f64 / row.plane_tests as f64)
        .reduce(f64::max)?;
    Some(format!(
        "beside every plane test at most {most:.2} comparisons of edges (n from {FROM})"
    ))
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    fn judged(power: f64, noise: f64) -> Verdict {
        let mut records = Records::default();
        made_up::wraps(&mut records, "random", "printed", |row| {
            let wobble = (noise * (row.replicate as f64 - 1.5)).exp();
            row.mark_comparisons = ((row.h as f64).powf(power) * wobble) as u64;
            row.plane_tests = made_up::nh(row, 10.0);
        });
        judge(&records)
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(judged(2.0, 0.01).outcome, Outcome::Confirmed);
        assert_eq!(judged(2.4, 0.01).outcome, Outcome::Refuted);
        assert_eq!(judged(2.1, 1.0).outcome, Outcome::NotDistinguishable);
    }
}
