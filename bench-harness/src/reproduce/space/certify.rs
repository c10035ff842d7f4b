//! Proof before use: the hull of a set, and which methods found it.
//!
//! The checker, which shares no arithmetic with the methods, certifies one result; every other method must
//! give that same value.

use super::spatial_method;
use crate::reproduce::rows::{FailureRow, SetRow};
use crate::reproduce::sets::PointSet3;
use anyhow::Result;
use geometry_core::{Hull3, HullError, Points};

/// What the results of several methods on one set came to.
#[derive(Clone, Debug)]
pub(crate) struct Certified3 {
    /// The certified hull, if any result was one.
    pub(crate) hull: Option<Hull3>,
    /// The set, and how many methods passed.
    pub(crate) set: SetRow,
    /// The methods that passed.
    pub(crate) methods: Vec<String>,
    /// The others.
    pub(crate) failures: Vec<FailureRow>,
}

/// A result and the name of what made it.
pub(crate) type Named = (String, Result<Hull3, HullError>);

/// Runs `methods` on `set` with exact answers and certifies their results.
pub(crate) fn certify(stage: &str, set: &PointSet3, methods: &[String]) -> Result<Certified3> {
    let points = Points::new(&set.points)?;
    let mut results = Vec::new();
    for slug in methods {
        results.push((slug.clone(), (spatial_method(slug)?.exact)(points)));
    }
    Ok(certify_results(stage, set, results))
}

/// Certifies `results`, however they were made.
pub(crate) fn certify_results(stage: &str, set: &PointSet3, results: Vec<Named>) -> Certified3 {
    let proved = results
        .iter()
        .filter_map(|(_, result)| result.as_ref().ok())
        .find(|hull| hull_verify::check::hull3(&set.points, hull).is_ok())
        .cloned();
    let tried = results.len();
    let mut passed = Vec::new();
    let mut failures = Vec::new();
    for (method, result) in results {
        match fault(set, &result, proved.as_ref()) {
            None => passed.push(method),
            Some(what) => failures.push(FailureRow {
                stage: stage.to_owned(),
                distribution: set.distribution.clone(),
                n: set.n,
                replicate: set.replicate,
                method,
                what,
            }),
        }
    }
    let set = SetRow {
        stage: stage.to_owned(),
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        seed: set.seed,
        fingerprint: set.fingerprint(),
        vertices: proved.as_ref().map_or(0, Hull3::len),
        facets: proved.as_ref().map(|hull| hull.facets().count()),
        certified: passed.len(),
        methods: tried,
    };
    Certified3 {
        hull: proved,
        set,
        methods: passed,
        failures,
    }
}

/// What is wrong with `result`, if it is not the hull `proved`.
fn fault(
    set: &PointSet3,
    result: &Result<Hull3, HullError>,
    proved: Option<&Hull3>,
) -> Option<String> {
    match result {
        Err(error) => Some(error.to_string()),
        Ok(hull) if Some(hull) == proved => None,
        Ok(hull) => match hull_verify::check::hull3(&set.points, hull) {
            Ok(_) => Some("passes the checker, but differs from another hull that does".to_owned()),
            Err(findings) => {
                let first = findings
                    .first()
                    .map(ToString::to_string)
                    .unwrap_or_default();
                Some(format!("{} findings, first: {first}", findings.len()))
            }
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ball() -> PointSet3 {
        PointSet3::generate(1, "ball", 40, 0).expect("a set")
    }

    #[test]
    fn methods_that_agree_with_a_proved_hull_pass() {
        let methods = ["quickhull-3d", "pivot-wrap"].map(str::to_owned);
        let certified = certify("test", &ball(), &methods).expect("methods");
        assert_eq!(certified.methods, methods);
        assert!(certified.failures.is_empty() && certified.set.vertices > 4);
    }

    #[test]
    fn a_wrong_hull_and_an_error_are_failures() {
        let right = hullkit::convex_hull_3d(&ball().points);
        let error = HullError::Contradiction { what: "made up" };
        let results = vec![
            ("empty".to_owned(), Ok(Hull3::Empty)),
            ("right".to_owned(), right),
            ("none".to_owned(), Err(error)),
        ];
        let certified = certify_results("test", &ball(), results);
        assert_eq!(certified.methods, ["right"]);
        let failed: Vec<&str> = certified
            .failures
            .iter()
            .map(|row| row.method.as_str())
            .collect();
        assert_eq!(failed, ["empty", "none"]);
    }

    #[test]
    fn a_planar_method_is_refused() {
        assert!(certify("test", &ball(), &["gs".to_owned()]).is_err());
    }
}
