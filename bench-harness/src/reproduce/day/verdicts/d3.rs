//! D-3: whether a merge may take quadratic time.

use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::day::derived::{WORST, largest, merged, top};
use crate::reproduce::day::laws::compare;
use crate::reproduce::day::records::{MergeRow, Records};
use crate::reproduce::day::variants;
use crate::reproduce::space::growth::exponent;
use crate::stats::growth::{Fit, Law};

/// Between linear and quadratic.
const BETWEEN: f64 = 1.5;

pub(super) fn judge(records: &Records) -> Verdict {
    let parts = WORST.map(|distribution| is_quadratic(records, distribution));
    verdict("D-3", parts.to_vec(), notes(records))
}

/// Whether the top merge of Day's own rule grows as the square on `distribution`.
fn is_quadratic(records: &Records, distribution: &str) -> Part {
    let what =
        format!("{distribution}: with the paper's own rule of search, the top merge is quadratic");
    let data = top(records, distribution, "resumed");
    let Some(exponent) = exponent(&data) else {
        return Part::new(
            what,
            Outcome::NotTestable,
            "not counted at two sizes or more",
        );
    };
    let (low, high) = exponent.interval;
    let outcome = if low > BETWEEN {
        Outcome::Confirmed
    } else if high < BETWEEN {
        Outcome::Refuted
    } else {
        Outcome::NotDistinguishable
    };
    Part::new(
        what,
        outcome,
        format!("exponent {exponent}; {}", fits(&data)),
    )
}

/// The linear and the quadratic law fitted, with their errors.
fn fits(data: &[(f64, f64)]) -> String {
    let text = |fit: Fit| {
        let linear = match fit.law {
            Law::N => String::new(),
            _ => format!(" {:+.3} n", fit.correction),
        };
        let (factor, error) = (fit.leading, 100.0 * fit.scatter);
        format!("fit {factor:.4} {}{linear}, error {error:.2} %", fit.law)
    };
    let fits = compare(data).into_iter().filter_map(|model| model.fit);
    let fits = fits.filter(|fit| matches!(fit.law, Law::N | Law::N2));
    let fits: Vec<String> = fits.map(text).collect();
    if fits.is_empty() {
        "too few sizes to fit laws".to_owned()
    } else {
        fits.join("; ")
    }
}

/// The other rules, and random sets.
fn notes(records: &Records) -> Vec<String> {
    let mut notes = Vec::new();
    for name in variants::NAMES {
        for distribution in merged(records, name) {
            let data = top(records, distribution, name);
            let is_worst = WORST.contains(&distribution);
            let Some(exponent) = exponent(&data) else {
                continue;
            };
            if name == "resumed" && is_worst {
                notes.extend(constant(records, distribution, name, 1.0));
                continue;
            }
            let rule = variants::words(name);
            let power = if is_worst { 2.0 } else { 1.0 };
            let constant = if is_worst {
                constant(records, distribution, name, power)
            } else {
                a_facet(records, distribution, name)
            };
            notes.push(format!(
                "{distribution}, {rule}: exponent {exponent}{}",
                constant.map_or_else(String::new, |text| format!("; {text}"))
            ));
        }
    }
    notes
}

/// Questions of the top merge at the largest n, over n to the `power`.
fn constant(records: &Records, distribution: &str, variant: &str, power: f64) -> Option<String> {
    let (n, asked) = largest(records, distribution, variant, |row| {
        row.top_candidates as f64
    })?;
    let unit = if power > 1.0 { "n²" } else { "n" };
    Some(format!(
        "{distribution}, n = {n}: {asked:.0} questions at the top merge, {:.4} {unit}",
        asked / n.powf(power)
    ))
}

/// Questions a facet of the wrap at the top merge, and how many facets there are, at the largest n.
fn a_facet(records: &Records, distribution: &str, variant: &str) -> Option<String> {
    let of = |quantity: fn(&MergeRow) -> f64| largest(records, distribution, variant, quantity);
    let (n, a_facet) = of(questions_a_facet)?;
    let (_, facets) = of(|row| row.top_facets as f64)?;
    Some(format!(
        "n = {n}: {a_facet:.3} questions a facet, {facets:.0} facets in the wrap"
    ))
}

/// Questions a facet of the wrap at the top merge.
pub(super) fn questions_a_facet(row: &MergeRow) -> f64 {
    row.top_candidates as f64 / row.top_facets.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    #[test]
    fn each_outcome_can_come_out() {
        let judged = |cost: fn(f64) -> f64| {
            let mut records = Records::default();
            made_up::merges(&mut records, &WORST, "resumed", |n| MergeRow {
                top_candidates: cost(n) as u64,
                ..MergeRow::default()
            });
            judge(&records)
        };
        let linear = judged(|n| 5.0 * n - 12.0);
        assert_eq!(linear.outcome, Outcome::Refuted);
        assert!(linear.parts[0].statistic.contains("fit 4.9"), "{linear:?}");
        assert_eq!(judged(|n| 0.125 * n * n).outcome, Outcome::Confirmed);
        let jumping = judged(|n| n.powf(1.5) * (1.0 + n.log2().floor() % 2.0));
        assert_eq!(jumping.outcome, Outcome::NotDistinguishable, "{jumping:?}");
    }
}
