//! B-4: insertion in random order with a conflict graph.

use super::{Outcome, Part, Verdict, all_of, verdict};
use crate::reproduce::balan::derived::{plane_tests, runs};
use crate::reproduce::balan::records::Records;
use crate::reproduce::rows::CountRow;
use crate::reproduce::space::growth::{against_n, at_largest, groups, is_n_log_n, upper_decades};
use crate::stats::line::{Line, fit_on_log};
use crate::stats::summary::{mean, standard_error};

const METHOD: &str = "incremental-conflict";

const DISTRIBUTIONS: [&str; 5] = ["sphere", "ball", "cube", "normal3", "cauchy3"];

pub(super) fn judge(records: &Records) -> Verdict {
    let facets = DISTRIBUTIONS.map(|distribution| facets_made(records, distribution));
    let tests = DISTRIBUTIONS.map(|distribution| {
        let data = against_n(runs(records, distribution, METHOD), plane_tests);
        is_n_log_n(format!("{distribution}: plane tests are O(n log n)"), &data)
    });
    let parts: Vec<Part> = facets.into_iter().chain(tests).collect();
    verdict("B-4", parts, constants(records))
}

/// Whether the facets made are expected to be 6 n - 20 at most, by the mean of each size and three standard errors.
fn facets_made(records: &Records, distribution: &str) -> Part {
    let what = format!("{distribution}: facets made are at most 6 n - 20 in expectation");
    let data = against_n(runs(records, distribution, METHOD), |row| row.facets as f64);
    let mut outcomes = Vec::new();
    let mut closest = (0.0, 0.0);
    for (n, values) in groups(&data) {
        let (bound, average) = (6.0 * n - 20.0, mean(&values));
        // A single set has no error to show, so it may be above by chance.
        let error = Some(standard_error(&values)).filter(|error| error.is_finite());
        let is_above = error.is_some_and(|error| average - 3.0 * error > bound);
        outcomes.push(match average <= bound {
            true => Outcome::Confirmed,
            false if is_above => Outcome::Refuted,
            false => Outcome::NotDistinguishable,
        });
        if average / bound > closest.1 {
            closest = (n, average / bound);
        }
    }
    let statistic = format!(
        "closest at n = {}: {:.4} of the bound",
        closest.0, closest.1
    );
    Part::new(what, all_of(outcomes), statistic)
}

/// Facets and tests a point at the largest n, and the growth of the tests on the sphere.
fn constants(records: &Records) -> Vec<String> {
    let note = |distribution: &str| {
        let (n, facets) = facets_a_point(records, distribution)?;
        let (_, tests) = at_largest(&tests_a_point(records, distribution))?;
        Some(format!(
            "{distribution}, n = {n}: {facets:.4} facets made and {tests:.2} plane tests a point"
        ))
    };
    let mut notes: Vec<String> = DISTRIBUTIONS.into_iter().filter_map(note).collect();
    if let Some(line) = sphere_line(records) {
        let (low, high) = line.slope_interval(0.95);
        notes.push(format!(
            "sphere: plane tests a point are {:.3} ln n {:+.2}, 95 % of the slope [{low:.3}, {high:.3}]: the graph holds \
             every facet that a point sees, so it asks three times what a list with one facet a point asks",
            line.slope, line.intercept
        ));
    }
    notes
}

/// n, and the mean number of facets made a point, at the largest n.
pub(super) fn facets_a_point(records: &Records, distribution: &str) -> Option<(f64, f64)> {
    let facets = |row: &CountRow| row.facets as f64 / row.n as f64;
    at_largest(&against_n(runs(records, distribution, METHOD), facets))
}

fn tests_a_point(records: &Records, distribution: &str) -> Vec<(f64, f64)> {
    let tests = |row: &CountRow| plane_tests(row) / row.n as f64;
    against_n(runs(records, distribution, METHOD), tests)
}

/// Plane tests a point on the sphere against ln n.
pub(super) fn sphere_line(records: &Records) -> Option<Line> {
    fit_on_log(&upper_decades(&tests_a_point(records, "sphere")))
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;

    fn verdict(facets: impl Fn(f64) -> f64, tests: impl Fn(f64) -> f64) -> Outcome {
        let mut records = Records::default();
        made_up::counts(&mut records, &DISTRIBUTIONS, METHOD, |_, n| {
            let made = (n * facets(n)) as u64;
            CountRow {
                facets: made,
                drops: made,
                orientations: tests(n) as u64,
                ..CountRow::default()
            }
        });
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        let n_log_n = |n: f64| 8.0 * n * n.ln();
        assert_eq!(verdict(|_| 5.7, n_log_n), Outcome::Confirmed);
        assert_eq!(verdict(|_| 6.5, n_log_n), Outcome::Refuted);
        assert_eq!(verdict(|_| 5.7, |n| n.powf(1.5)), Outcome::Refuted);
        let negative_term = |n: f64| 24.0 * n * (n.ln() - 3.0);
        assert_eq!(verdict(|_| 5.7, negative_term), Outcome::Confirmed);
        // 5.2, 6.2, 7.2 for the three runs of a cell: above the bound on average, but by chance perhaps.
        let scattered = |n: f64| {
            let run = (n / 10_f64.powf(n.log10().round()) - 1.0) * 1_000.0;
            5.2 + run.round()
        };
        assert_eq!(verdict(scattered, n_log_n), Outcome::NotDistinguishable);
    }
}
