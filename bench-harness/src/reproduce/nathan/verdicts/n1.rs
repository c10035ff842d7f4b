//! N-1: the complexity is O(n h).

use super::{Outcome, Part, Verdict, distributions, verdict, wraps};
use crate::reproduce::nathan::records::{Records, WrapRow};
use crate::stats::interval::{Place, equivalence};
use crate::stats::line::{Line, fit_on_log};
use crate::stats::summary::mean;

/// From here on the number of searches is three a vertex, up to a tenth.
const FROM: usize = 64;

/// Growth of the tests over n h by less than this for every factor e of n is none.
const MARGIN: f64 = 0.1;

pub(super) fn judge(records: &Records) -> Verdict {
    let mut parts = Vec::new();
    for (order, words) in [("random", "in random order"), ("inside-out", "inside out")] {
        for distribution in distributions(wraps(records, order, "printed")) {
            parts.push(part(records, distribution, order, words));
        }
    }
    let notes = [law(records), passes_inside_out(records), pivoting(records)];
    verdict("N-1", parts, notes.into_iter().flatten().collect())
}

/// The line of tests over n h on ln n, as printed.
fn line(records: &Records, distribution: &str, order: &str) -> Option<Line> {
    let rows = wraps(records, order, "printed");
    let rows = rows.filter(|row| row.distribution == distribution && row.n >= FROM);
    let data: Vec<(f64, f64)> = rows.map(|row| (row.n as f64, row.over_nh())).collect();
    fit_on_log(&data)
}

fn part(records: &Records, distribution: &str, order: &str, words: &str) -> Part {
    let what = format!("{distribution}, points {words}: plane tests over n h do not grow with n");
    let Some(line) = line(records, distribution, order) else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "fewer than three runs, or one size",
        );
    };
    let interval = line.slope_interval(0.90);
    let outcome = match equivalence(interval, 0.0, MARGIN) {
        Place::Within => Outcome::Confirmed,
        // Falling is no growth.
        Place::Outside | Place::Across if interval.1 <= MARGIN => Outcome::Confirmed,
        Place::Outside => Outcome::Refuted,
        Place::Across => Outcome::NotDistinguishable,
    };
    Part::new(
        what,
        outcome,
        format!(
            "slope on ln n {:.3} [{:.3}, {:.3}], 90 %",
            line.slope, interval.0, interval.1
        ),
    )
}

/// The slope on ln n of the tests over n (h - 2), a third of the number of searches.
pub(super) fn slope(records: &Records, distribution: &str) -> Option<f64> {
    let rows = wraps(records, "random", "printed");
    let rows = rows.filter(|row| row.distribution == distribution && row.n >= FROM);
    let data: Vec<(f64, f64)> = rows.map(|row| (row.n as f64, 3.0 * row.passes())).collect();
    Some(fit_on_log(&data)?.slope)
}

/// Mean passes a search less ½ ln n, over all runs as printed in random order.
pub(super) fn constant(records: &Records) -> Option<f64> {
    let rows = wraps(records, "random", "printed").filter(|row| row.n >= FROM);
    let rest = rows.map(|row| row.passes() - 0.5 * (row.n as f64).ln());
    let rest: Vec<f64> = rest.collect();
    (!rest.is_empty()).then(|| mean(&rest))
}

fn law(records: &Records) -> Option<String> {
    let constant = constant(records)?;
    Some(format!(
        "in random order a search takes n (½ ln n + {constant:.3}) tests on average, so the whole is O(h n log n)"
    ))
}

/// The most plane tests of a search over n², points inside out.
fn passes_inside_out(records: &Records) -> Option<String> {
    let most_n = wraps(records, "inside-out", "printed")
        .map(|row| row.n)
        .max()?;
    let rows = wraps(records, "inside-out", "printed").filter(|row| row.n == most_n);
    let shares: Vec<f64> = rows.map(|row| row.passes() / row.n as f64).collect();
    Some(format!(
        "inside out a search takes {:.4} n² tests at n = {most_n}, so the whole is O(h n²)",
        mean(&shares)
    ))
}

/// Most tests a facet over n, by pivoting.
pub(super) fn pivot_share(records: &Records) -> Option<f64> {
    let rows = records
        .own
        .wraps
        .iter()
        .filter(|row| row.variant == "pivot-wrap");
    let share = |row: &WrapRow| row.plane_tests as f64 / (row.triangles as f64 * row.n as f64);
    rows.map(share).reduce(f64::max)
}

fn pivoting(records: &Records) -> Option<String> {
    let share = pivot_share(records)?;
    Some(format!(
        "with one pass a search, by pivoting, wrapping does take O(n h): at most {share:.4} n tests a facet in any run"
    ))
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    fn outcome(random: fn(f64) -> f64, inside_out: fn(f64) -> f64) -> Outcome {
        let mut records = Records::default();
        for (order, factor) in [("random", random), ("inside-out", inside_out)] {
            made_up::wraps(&mut records, order, "printed", |row| {
                row.plane_tests = made_up::nh(row, factor(row.n as f64));
            });
        }
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(outcome(|_| 3.0, |_| 4.0), Outcome::Confirmed);
        assert_eq!(outcome(|n| 1.5 * n.ln() + 3.0, |_| 4.0), Outcome::Refuted);
        assert_eq!(outcome(|_| 3.0, |n| 0.2 * n), Outcome::Refuted);
        assert_eq!(outcome(|_| 3.0, |n| 9.0 - n.ln()), Outcome::Confirmed);
        // A slope at the margin, hidden by what differs from run to run.
        let unclear = outcome(|n| 50.0 + 0.1 * n.ln(), |_| 4.0);
        assert_eq!(unclear, Outcome::NotDistinguishable);
    }

    #[test]
    fn the_law_is_read_off() {
        let mut records = Records::default();
        made_up::wraps(&mut records, "random", "printed", |row| {
            let passes = 0.5 * (row.n as f64).ln() + 1.05;
            row.plane_tests = (row.n as f64 * row.searches as f64 * passes).round() as u64;
        });
        let constant = constant(&records).expect("runs");
        assert!((constant - 1.05).abs() < 1e-3, "{constant}");
        let slope = slope(&records, "ball").expect("a line");
        assert!((slope - 1.5).abs() < 1e-3, "{slope}");
        assert!(pivot_share(&records).is_none());
    }
}
