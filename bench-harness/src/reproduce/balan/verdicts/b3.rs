//! B-3: insertion without a conflict graph.

use super::{Outcome, Part, Verdict, verdict};
use crate::reproduce::balan::derived::{plane_tests, runs};
use crate::reproduce::balan::records::Records;
use crate::reproduce::space::growth::{against_n, at_largest, exponent, grows_as};
use crate::reproduce::theory::hull_size_in_space::expected;

const METHOD: &str = "incremental-3d";

/// From the most facets to the fewest.
const DISTRIBUTIONS: [&str; 5] = ["sphere", "ball", "cube", "normal3", "cauchy3"];

pub(super) fn judge(records: &Records) -> Verdict {
    let quadratic = DISTRIBUTIONS.map(|distribution| {
        let data = against_n(runs(records, distribution, METHOD), plane_tests);
        grows_as(
            format!("{distribution}: visibility tests grow as n²"),
            &data,
            2.0,
            0.05,
        )
    });
    let parts: Vec<Part> = [identity(records)].into_iter().chain(quadratic).collect();
    verdict("B-3", parts, constants(records))
}

/// With all points extreme and in general position, the i-th is tested against 2 (i - 1) - 4 facets.
fn identity(records: &Records) -> Part {
    let what = "sphere: the visibility tests are exactly (n-1)(n-4)";
    let data = against_n(runs(records, "sphere", METHOD), plane_tests);
    let exact = |&&(n, tests): &&(f64, f64)| (tests - (n - 1.0) * (n - 4.0)).abs() < 0.5;
    let right = data.iter().filter(exact).count();
    let outcome = match data.len() {
        0 => Outcome::NotTestable,
        all if all == right => Outcome::Confirmed,
        _ => Outcome::Refuted,
    };
    Part::new(what, outcome, format!("{right} of {} runs", data.len()))
}

/// The tests at the largest n over n to the `power`.
pub(super) fn over_power(records: &Records, distribution: &str, power: f64) -> Option<f64> {
    let (n, tests) = at_largest(&against_n(runs(records, distribution, METHOD), plane_tests))?;
    Some(tests / n.powf(power))
}

/// The tests at the largest n over their exact expectation.
pub(super) fn over_expectation(records: &Records, distribution: &str) -> Option<f64> {
    let (n, tests) = at_largest(&against_n(runs(records, distribution, METHOD), plane_tests))?;
    Some(tests / expected_tests(distribution, n as usize)?)
}

/// The exponents there are, and the average of the largest n beside the exact expectation.
fn constants(records: &Records) -> Vec<String> {
    let note = |distribution: &str| {
        let data = against_n(runs(records, distribution, METHOD), plane_tests);
        let exponent = exponent(&data)?;
        let (n, tests) = at_largest(&data)?;
        let share = match distribution {
            "sphere" => format!("{:.4} n²", tests / n.powi(2)),
            "ball" => format!("{:.3} n^1.5", tests / n.powf(1.5)),
            "cauchy3" => format!("{:.3} n", tests / n),
            _ => format!("{:.3} n ln n", tests / (n * n.ln())),
        };
        let theory = expected_tests(distribution, n as usize).map_or_else(String::new, |sum| {
            format!("; expected facets summed over the insertions: {sum:.4e}")
        });
        Some(format!(
            "{distribution}: exponent {exponent}; {tests:.4e} tests at n = {n}, {share}{theory}"
        ))
    };
    DISTRIBUTIONS.into_iter().filter_map(note).collect()
}

/// The sum of the expected numbers of facets of the hulls of 4, 5, … n - 1 points.
///
/// Facets are computed for some sizes, four in each doubling, and taken to follow a power of n between them.
fn expected_tests(distribution: &str, n: usize) -> Option<f64> {
    let facets = |n: usize| Some(2.0 * expected(distribution, n)? - 4.0);
    let mut sum = 0.0;
    let (mut from, mut at_from) = (4_usize, facets(4)?);
    while from < n {
        let to = (from + (from / 4).max(1)).min(n);
        let at_to = facets(to)?;
        let exponent = (at_to / at_from).ln() / (to as f64 / from as f64).ln();
        let between = (from..to).map(|i| at_from * (i as f64 / from as f64).powf(exponent));
        sum += between.sum::<f64>();
        (from, at_from) = (to, at_to);
    }
    Some(sum)
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;
    use crate::reproduce::rows::CountRow;

    fn verdict(tests: impl Fn(&str, f64) -> f64 + Copy) -> Verdict {
        let mut records = Records::default();
        made_up::counts(&mut records, &DISTRIBUTIONS, METHOD, |distribution, n| {
            // One for the first tetrahedron.
            let tests = tests(distribution, n.floor());
            CountRow {
                orientations: tests as u64 + 1,
                ..CountRow::default()
            }
        });
        for row in &mut records.counts {
            if row.distribution == "sphere" && row.replicate > 0 {
                row.orientations = tests("sphere", row.n as f64) as u64 + 1;
            }
        }
        judge(&records)
    }

    #[test]
    fn each_outcome_can_come_out() {
        let all_extreme = |_: &str, n: f64| (n - 1.0) * (n - 4.0);
        assert_eq!(verdict(all_extreme).outcome, Outcome::Confirmed);
        let fewer = |distribution: &str, n: f64| match distribution {
            "sphere" => (n - 1.0) * (n - 4.0),
            _ => 6.0 * n.powf(1.5),
        };
        let verdict = verdict(fewer);
        assert_eq!(verdict.outcome, Outcome::Refuted);
        assert_eq!(verdict.parts[0].outcome, Outcome::Confirmed);
        assert_eq!(verdict.parts[2].outcome, Outcome::Refuted);
    }

    #[test]
    fn expected_tests_are_sums() {
        for n in [5, 100, 1_000] {
            let sum = expected_tests("sphere", n).expect("a formula");
            let exact = (n as f64 - 1.0) * (n as f64 - 4.0);
            assert!((sum / exact - 1.0).abs() < 0.02, "{sum} for {exact}");
        }
        let by_hand: f64 = (4..300)
            .filter_map(|i| Some(2.0 * expected("ball", i)? - 4.0))
            .sum();
        let sum = expected_tests("ball", 300).expect("a formula");
        assert!((sum / by_hand - 1.0).abs() < 0.005, "{sum} for {by_hand}");
        assert!(expected_tests("cube", 100).is_none());
    }
}
