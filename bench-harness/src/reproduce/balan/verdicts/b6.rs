//! B-6: what quickhull costs.

use super::{Part, Verdict, verdict};
use crate::reproduce::balan::derived::{plane_tests, runs, triangles};
use crate::reproduce::balan::records::Records;
use crate::reproduce::rows::CountRow;
use crate::reproduce::space::growth::{
    against_n, at_largest, does_not_rise, is_n_log_n, range, upper_decades,
};
use crate::stats::line::{Line, fit_on_log};

/// The paper's program.
const METHOD: &str = "quickhull-balan";

/// Quickhull with each point in one outside set.
const TWIN: &str = "quickhull-3d";

const DISTRIBUTIONS: [&str; 5] = ["sphere", "ball", "cube", "normal3", "cauchy3"];

pub(super) fn judge(records: &Records) -> Verdict {
    let by_facets = DISTRIBUTIONS.map(|distribution| {
        let data = against_n(runs(records, distribution, METHOD), of_bound);
        let what = format!("{distribution}: plane evaluations are O(m n) for m facets");
        does_not_rise(what, &data, 0.05)
    });
    let on_average = DISTRIBUTIONS.map(|distribution| {
        let data = against_n(runs(records, distribution, METHOD), plane_tests);
        let what = format!("{distribution}: plane evaluations are O(n log n)");
        is_n_log_n(what, &data)
    });
    let parts: Vec<Part> = by_facets.into_iter().chain(on_average).collect();
    verdict("B-6", parts, notes(records))
}

/// Evaluations as a share of m n.
fn of_bound(row: &CountRow) -> f64 {
    plane_tests(row) / (triangles(row) * row.n as u64) as f64
}

/// Evaluations a point of `method`, against n.
fn a_point(records: &Records, distribution: &str, method: &str) -> Vec<(f64, f64)> {
    let evaluations = |row: &CountRow| plane_tests(row) / row.n as f64;
    against_n(runs(records, distribution, method), evaluations)
}

/// Evaluations a point of quickhull with one outside set a point, at the largest n.
pub(super) fn of_twin(records: &Records, distribution: &str) -> Option<f64> {
    Some(at_largest(&a_point(records, distribution, TWIN))?.1)
}

/// How they grow with ln n on the sphere.
pub(super) fn sphere_line(records: &Records) -> Option<Line> {
    fit_on_log(&upper_decades(&a_point(records, "sphere", TWIN)))
}

/// Evaluations a point at the largest n, how they grow, and what share of the bound m n that is.
fn notes(records: &Records) -> Vec<String> {
    let note = |distribution: &str, method: &str| {
        let data = a_point(records, distribution, method);
        let (n, evaluations) = at_largest(&data)?;
        let (_, share) = at_largest(&against_n(runs(records, distribution, method), of_bound))?;
        let upper = upper_decades(&data);
        let line = fit_on_log(&upper)?;
        let (low, high) = line.slope_interval(0.95);
        Some(format!(
            "{method}, {distribution}: {evaluations:.2} evaluations a point at n = {n}, changing by {:.3} for each unit of \
             ln n, 95 % [{low:.3}, {high:.3}] ({}; linear is 0); {share:.2e} of m n",
            line.slope,
            range(&upper),
        ))
    };
    [TWIN, METHOD]
        .into_iter()
        .flat_map(|method| DISTRIBUTIONS.map(|distribution| note(distribution, method)))
        .flatten()
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::made_up;
    use super::*;
    use crate::reproduce::verdict::Outcome;

    fn verdict(exponent: f64, facets: f64) -> Outcome {
        let mut records = Records::default();
        made_up::counts(&mut records, &DISTRIBUTIONS, METHOD, |_, n| CountRow {
            facets: n.powf(facets) as u64,
            orientations: (3.0 * n.powf(facets)) as u64 + (10.0 * n.powf(exponent)) as u64,
            ..CountRow::default()
        });
        judge(&records).outcome
    }

    #[test]
    fn each_outcome_can_come_out() {
        assert_eq!(verdict(1.0, 0.5), Outcome::Confirmed);
        assert_eq!(verdict(1.5, 0.8), Outcome::Refuted);
        assert_eq!(verdict(1.1, 0.01), Outcome::Refuted);
    }
}
