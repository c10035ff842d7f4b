//! Tests a point: visits in passes over points, and orientations asked about the rest. They do not grow with n where few
//! points are extreme.

use geometry_core::{Boundary, Counted, Exact, Hull2, Points, Tally};
use point_sets::Spec;

struct Counts {
    hull: Hull2,
    tally: Tally,
    /// Visits a point.
    visits: f64,
    /// Orientations a point.
    orientations: f64,
}

fn counts(set: &str, n: usize) -> Counts {
    let spec: Spec = set.parse().expect("a set of the catalogue");
    let points = spec.generate(n, 1).expect("the set has any size");
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let view = Points::new(&points).expect("finite points");
    let hull = quickhull::fast_2d(view, Boundary::Extreme, &kernel, &mut tally)
        .expect("an exact kernel is consistent");
    let per_point = |count: u64| count as f64 / points.len() as f64;
    Counts {
        hull,
        tally,
        visits: per_point(tally.visits),
        orientations: per_point(kernel.counts().orientations.total()),
    }
}

#[test]
fn tests_a_point_do_not_grow() {
    for set in ["disc", "square", "normal", "cauchy", "lattice"] {
        let mut least_visits: f64 = f64::INFINITY;
        for n in [10_000, 40_000, 160_000, 640_000] {
            let counts = counts(set, n);
            let (visits, asked) = (counts.visits, counts.orientations);
            assert!(visits < 1.35, "{set}, n = {n}: {visits} visits a point");
            assert!(asked < 0.2, "{set}, n = {n}: {asked} orientations a point");
            assert!(
                visits < 1.1 * least_visits,
                "{set}, n = {n}: {visits} visits"
            );
            least_visits = least_visits.min(visits);
        }
        // What is left is a smaller part of more points.
        let [few, many] = [10_000, 640_000].map(|n| counts(set, n).orientations);
        assert!(
            many < few / 4.0,
            "{set}: {few}, then {many} orientations a point"
        );
    }
}

/// Where all points are extreme, none is visited in vain, and each is asked about twice: which side, which turn.
#[test]
fn all_extreme_points_are_asked_about_twice() {
    for set in ["circle", "parabola"] {
        for n in [10_000, 100_000] {
            let counts = counts(set, n);
            assert_eq!(counts.visits, 0.0, "{set}");
            assert!((1.99..2.1).contains(&counts.orientations), "{set}, n = {n}");
            assert_eq!(counts.tally.edges as usize, counts.hull.len());
        }
    }
}

/// Every point is dropped in a pass, popped from a chain, or stays.
#[test]
fn the_steps_account_for_every_point() {
    for set in ["disc", "square", "cauchy"] {
        for n in [10, 100, 1_000, 50_000] {
            let Counts { hull, tally, .. } = counts(set, n);
            assert_eq!(tally.pushes - tally.pops, hull.len() as u64, "{set}");
            assert_eq!(
                tally.discards + tally.pops + hull.len() as u64,
                n as u64,
                "{set}"
            );
            assert_eq!(tally.edges, hull.len() as u64);
        }
    }
}
