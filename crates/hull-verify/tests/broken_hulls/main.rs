//! The checker on hulls broken on purpose: each kind of breakage is rejected, with the right finding.

mod polygons;
mod values;

use geometry_core::{Boundary, Hull2, Point2};
use hull_verify::check::{self, Finding};
use hull_verify::{families, oracle};

const BOUNDARIES: [Boundary; 2] = [Boundary::Extreme, Boundary::All];

/// Every family with its hull by the oracle.
fn hulls() -> Vec<(&'static str, Vec<Point2>, Boundary, Hull2)> {
    families::all()
        .into_iter()
        .flat_map(|family| {
            BOUNDARIES.map(|boundary| {
                let hull = oracle::hull2(&family.points, boundary);
                (family.name, family.points.clone(), boundary, hull)
            })
        })
        .collect()
}

fn findings(points: &[Point2], boundary: Boundary, hull: &Hull2) -> Vec<Finding> {
    check::hull2(points, boundary, hull).expect_err("a broken hull was certified")
}
