//! Nothing is counted or timed that is not proved.
//!
//! The checker, which shares no arithmetic with the methods, certifies one result; every other method must
//! give that same value.

use super::hull_method;
use crate::reproduce::green_silverman::records::{FailureRow, SetRow};
use crate::reproduce::green_silverman::sets::PointSet;
use anyhow::Result;
use geometry_core::{Boundary, Hull2, HullError, Points};

/// What the results of several methods on one set came to.
#[derive(Debug)]
pub(crate) struct Certified {
    /// The set, and how many methods passed.
    pub(crate) set: SetRow,
    /// The methods that passed.
    pub(crate) methods: Vec<String>,
    /// The others.
    pub(crate) failures: Vec<FailureRow>,
}

/// Runs `methods` on `set` with exact answers and certifies their results.
pub(crate) fn certify(stage: &str, set: &PointSet, methods: &[String]) -> Result<Certified> {
    let points = Points::new(&set.points)?;
    let mut results = Vec::new();
    for slug in methods {
        results.push((slug, (hull_method(slug)?.exact)(points, Boundary::All)));
    }
    let proved = results
        .iter()
        .filter_map(|(_, result)| result.as_ref().ok())
        .find(|hull| hull_verify::check::hull2(&set.points, Boundary::All, hull).is_ok());
    let mut passed = Vec::new();
    let mut failures = Vec::new();
    for (slug, result) in &results {
        match fault(set, result, proved) {
            None => passed.push((*slug).clone()),
            Some(what) => failures.push(FailureRow {
                stage: stage.to_owned(),
                distribution: set.distribution.clone(),
                n: set.n,
                replicate: set.replicate,
                method: (*slug).clone(),
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
        vertices: proved.map_or(0, Hull2::len),
        certified: passed.len(),
        methods: methods.len(),
    };
    Ok(Certified {
        set,
        methods: passed,
        failures,
    })
}

/// What is wrong with `result`, if it is not the hull `proved`.
fn fault(
    set: &PointSet,
    result: &Result<Hull2, HullError>,
    proved: Option<&Hull2>,
) -> Option<String> {
    match result {
        Err(error) => Some(error.to_string()),
        Ok(hull) if Some(hull) == proved => None,
        Ok(hull) => match hull_verify::check::hull2(&set.points, Boundary::All, hull) {
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
