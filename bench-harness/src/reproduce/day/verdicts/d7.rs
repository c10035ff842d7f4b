//! D-7: whether the whole takes time of the order of n log n.

use super::{Outcome, Part, Verdict};
use crate::reproduce::day::derived::{in_order, times};
use crate::reproduce::day::laws::{Model, compare};
use crate::reproduce::day::records::Records;
use crate::reproduce::space::growth::{against_n, at_largest, exponent, questions, range};
use crate::reproduce::verdict::{all_of, with_time};
use crate::stats::growth::Law;

pub(super) fn judge(records: &Records) -> Verdict {
    let counted = in_order(records.counts.iter().map(|row| &row.distribution));
    let timed = in_order(records.times.iter().map(|row| &row.distribution));
    let counts: Vec<Part> = counted
        .iter()
        .map(|name| within(format!("{name}: all questions"), &asked(records, name)))
        .collect();
    let clock: Vec<Part> = timed
        .iter()
        .map(|name| within(format!("{name}: time"), &times(records, name)))
        .collect();
    let by_counts = all_of(counts.iter().map(|part| part.outcome));
    let by_time = all_of(clock.iter().map(|part| part.outcome));
    let notes = counted.iter().filter_map(|name| note(records, name));
    Verdict {
        id: "D-7",
        outcome: match by_counts {
            // A claim that counts speak against is not saved by the clock.
            Outcome::Confirmed => with_time(by_counts, by_time),
            other => other,
        },
        notes: notes.collect(),
        parts: counts.into_iter().chain(clock).collect(),
    }
}

/// All questions of the whole call against n.
fn asked(records: &Records, distribution: &str) -> Vec<(f64, f64)> {
    let rows = records.counts.iter();
    against_n(
        rows.filter(|row| row.distribution == distribution),
        questions,
    )
}

/// Whether no law that the data leave grows faster than n log n.
fn within(what: String, data: &[(f64, f64)]) -> Part {
    let what = format!("{what} O(n log n)");
    let models = compare(data);
    let left = models.iter().filter(|model| !model.ruled_out);
    let faster: Vec<bool> = left.map(|model| model.law > Law::NLogN).collect();
    let outcome = if faster.is_empty() {
        return Part::new(
            what,
            Outcome::NotTestable,
            "fewer than six sizes, or no law fits",
        );
    } else if faster.iter().all(|faster| *faster) {
        Outcome::Refuted
    } else if faster.iter().any(|faster| *faster) {
        Outcome::NotDistinguishable
    } else {
        Outcome::Confirmed
    };
    let texts: Vec<String> = models.iter().map(text).collect();
    Part::new(
        what,
        outcome,
        format!("{}; {}", range(data), texts.join("; ")),
    )
}

/// A law, its errors, and whether it is ruled out.
fn text(model: &Model) -> String {
    let Some(fit) = model.fit else {
        return format!("{}: no factor above zero fits, ruled out", model.law);
    };
    format!(
        "{}: error {:.3} %, ahead {:.3} %, AICc +{:.0}, {}",
        model.law,
        100.0 * fit.scatter,
        100.0 * model.ahead,
        model.behind,
        if model.ruled_out { "ruled out" } else { "left" }
    )
}

fn note(records: &Records, distribution: &str) -> Option<String> {
    let data = asked(records, distribution);
    let exponent = exponent(&data)?;
    let (n, asked) = at_largest(&data)?;
    let fitted = compare(&data)
        .into_iter()
        .find(|model| model.law == Law::NLogN)
        .and_then(|model| model.fit)
        .map_or_else(String::new, |fit| {
            format!("; {:.3} n ln n {:+.2} n", fit.leading, fit.correction)
        });
    Some(format!(
        "{distribution}: exponent {exponent} (n log n looks like {:.3} there); {:.2} questions a point at n = {n}{fitted}",
        1.0 + 1.0 / (n.ln() - 100_f64.ln() / 2.0),
        asked / n
    ))
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |cost: fn(f64) -> f64, time: fn(f64) -> f64| {
            let mut records = Records::default();
            made_up::counts(&mut records, &["ball", "sphere"], cost);
            made_up::times(&mut records, &["sphere"], time, 1.0);
            judge(&records).outcome
        };
        let good = |n: f64| n * (20.0 * n.ln() - 7.0);
        let slow = |n: f64| n * (n.sqrt() + 40.0);
        assert_eq!(judged(good, good), Outcome::Confirmed);
        assert_eq!(judged(good, slow), Outcome::CountsOnly);
        assert_eq!(judged(slow, good), Outcome::Refuted);
        let scattered = |n: f64| n * n.ln() * (2.0 + n.log2().floor() % 2.0);
        assert_eq!(judged(scattered, good), Outcome::NotDistinguishable);
    }
}
