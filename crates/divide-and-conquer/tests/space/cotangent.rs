//! Day's report on number formats (section 5), on a small scale: which are right at which eps2.

use crate::sets::{ball, cube, lattice};
use divide_and_conquer::preparata_hong_3d::cotangent::{Failure, Outcome, day_cotangent, outcome};
use geometry_core::Points;
use geometry_core::tolerance::formats::{Double, Extended, Format, Single};

/// How many of 20 sets of `n` points uniform in a cube end in each way, in the order of [`Outcome`].
fn ends<F: Format>(n: usize, eps2: f64) -> [usize; 4] {
    let mut ends = [0; 4];
    for seed in 0..20 {
        let points = cube(seed, n);
        let end = outcome::<F>(Points::new(&points).expect("finite"), eps2);
        ends[end.expect("an exact kernel") as usize] += 1;
    }
    ends
}

/// "The hull produced was consistently found to be correct using extended with an eps2 value of 1E16. [...] When using
/// singles, and to a lesser extent doubles, it was necessary to reduce the value of eps2."
#[test]
fn extended_is_right_at_days_bound_and_shorter_formats_are_not() {
    let all_right = [20, 0, 0, 0];
    assert_eq!(ends::<Extended>(100, 1e16), all_right);
    let [right, ..] = ends::<Double>(100, 1e16);
    assert!(right < 5, "{right} of 20 right in 53 bits");
    assert_eq!(ends::<Double>(100, 1e13), all_right);
    let [right, ..] = ends::<Single>(100, 1e16);
    assert_eq!(right, 0, "in 24 bits");
    assert_eq!(ends::<Single>(100, 1e4), all_right);
}

/// "Failure to do this caused errors [...] such as pointer dereferencing zero, incorrect hulls, and infinite looping."
#[test]
fn failures_take_all_of_days_forms() {
    let seen = [1e3, 1e4, 1e6].map(|eps2| ends::<Single>(1000, eps2));
    for end in [
        Outcome::WrongHull,
        Outcome::NotTerminating,
        Outcome::Dangling,
    ] {
        let count: usize = seen.iter().map(|ends| ends[end as usize]).sum();
        assert!(count > 0, "{end:?} among {seen:?}");
    }
}

/// Too small a bound is no good either: facets nearly in line are then all taken for a half-turn.
#[test]
fn a_small_bound_is_wrong_in_any_format() {
    let [right, ..] = ends::<Extended>(1000, 1e2);
    assert_eq!(right, 0);
}

#[test]
fn any_number_of_points_is_rounded_up_to_fours() {
    for n in 4..30 {
        let points = ball(n as u64, n);
        let points = Points::new(&points).expect("finite");
        assert_eq!(
            outcome::<Double>(points, 1e12),
            Ok(Outcome::Right),
            "{n} points"
        );
    }
    let few = [[0.0; 3]; 3];
    let facets = day_cotangent::<Double>(Points::new(&few).expect("finite"), 1e16);
    assert_eq!(facets, Err(Failure::TooFewPoints));
}

/// Whatever the points, the experiment ends.
#[test]
fn degenerate_sets_neither_panic_nor_loop() {
    let copies = vec![[1.0, 2.0, 3.0]; 17];
    let line: Vec<_> = (0..21).map(|i| [f64::from(i); 3]).collect();
    let plane: Vec<_> = lattice(5).into_iter().map(|p| [p[0], p[1], 0.0]).collect();
    let huge: Vec<_> = ball(1, 40)
        .into_iter()
        .map(|p| p.map(|x| 1e300 * x))
        .collect();
    let tiny: Vec<_> = ball(1, 40)
        .into_iter()
        .map(|p| p.map(|x| 1e-310 * x))
        .collect();
    for points in [copies, line, plane, huge, tiny, lattice(2), lattice(5)] {
        let points = Points::new(&points).expect("finite");
        for eps2 in [0.0, 1e4, 1e16, f64::INFINITY, f64::NAN] {
            // Any end will do; that there is one is the test.
            let _ = day_cotangent::<Single>(points, eps2);
            let _ = day_cotangent::<Double>(points, eps2);
            let _ = day_cotangent::<Extended>(points, eps2);
        }
    }
}
