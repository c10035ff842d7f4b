//! A coordinate that is not finite is named wherever it is, though most points are never searched for one.

use geometry_core::{Boundary, HullError, Point2, Points};
use hull_verify::families::{curves, lines, random};
use quickhull::{convex_hull, convex_hull_parallel};

const BAD: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// What both front doors say of a set with these points replaced: the same as the check of all points.
fn refuses(points: &[Point2], bad: &[(usize, Point2)]) {
    let mut points = points.to_vec();
    for &(index, point) in bad {
        points[index] = point;
    }
    let expected = Points::new(&points).expect_err("a coordinate is not finite");
    for hull in [convex_hull, convex_hull_parallel] {
        let error = hull(&points, Boundary::Extreme).expect_err("a coordinate is not finite");
        // Compared as text, as NaN is not equal to itself.
        assert_eq!(error.to_string(), expected.to_string());
        assert!(matches!(error, HullError::NotFinite { .. }));
    }
}

/// Each kind of bad coordinate, alone and with every other as its partner.
fn bad_points() -> Vec<Point2> {
    let mut all = Vec::new();
    for bad in BAD {
        all.extend([[bad, 0.1], [-0.2, bad], [bad, f64::MAX]]);
        all.extend(BAD.map(|other| [bad, other]));
    }
    all
}

#[test]
fn one_bad_point_is_found_anywhere() {
    for n in [1, 3, 24, 100, 1000, 5_000, 70_000] {
        let points = random::disc(n as u64, n);
        for bad in bad_points() {
            for index in [0, n / 3, n / 2 + n / 5, n - 1] {
                refuses(&points, &[(index, bad)]);
            }
        }
    }
}

/// Also where one lies in the sample that the first corners are taken from, or none is thrown away.
#[test]
fn the_first_of_several_is_named() {
    for points in [
        random::disc(1, 20_000),
        curves::circle(5_000),
        lines::diagonal(5_000),
    ] {
        for (first, second) in [(0, 16), (16, 4_000), (17, 33), (4_998, 4_999)] {
            for bad in bad_points() {
                refuses(&points, &[(first, bad), (second, [f64::INFINITY, -1.0])]);
            }
        }
    }
    refuses(&vec![[0.0, 0.0]; 5_000], &[(4_097, [1.0, f64::NAN])]);
    let all: Vec<(usize, Point2)> = (0..100).map(|index| (index, [f64::INFINITY; 2])).collect();
    refuses(&[[0.0, 0.0]; 100], &all);
}
