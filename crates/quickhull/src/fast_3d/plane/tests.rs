use super::*;
use geometry_core::{Exact, Kernel3, Sign};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// What a plane of the set says about each point, and the exact answer.
fn answers(points: &[Point3]) -> Vec<(Side, Sign)> {
    let span = Span::of(points);
    let mut answers = Vec::new();
    for corners in points.windows(3) {
        let [a, b, c] = [corners[0], corners[1], corners[2]];
        let plane = Plane::through([a, b, c], &span);
        for &p in points {
            answers.push((plane.side(plane.height(p)), Exact.orient3(a, b, c, p)));
        }
    }
    answers
}

fn assert_true(points: &[Point3]) {
    for (side, sign) in answers(points) {
        match side {
            Side::Outside => assert!(sign.is_positive(), "{sign:?}: {points:?}"),
            Side::Within => assert!(!sign.is_positive(), "{sign:?}: {points:?}"),
            Side::Unsure => {}
        }
    }
}

/// Points a few ulps off an oblique plane, near and far, at every magnitude: rounding decides the sign of most heights.
#[test]
fn a_certain_side_is_the_exact_one() {
    let mut rng = ChaCha8Rng::seed_from_u64(9);
    for exponent in (-1074..=1020).step_by(6) {
        let scale = 2.0_f64.powi(exponent.max(-1000)) * 2.0_f64.powi(exponent.min(-1000) + 1000);
        let points: Vec<Point3> = (0..8)
            .map(|_| {
                let (x, y) = (rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
                let off = f64::from(rng.random_range(-3..=3)) * f64::EPSILON;
                [x, y, 0.3 * x - 0.7 * y + 0.1 + off].map(|x: f64| x * scale)
            })
            .collect();
        assert_true(&points);
    }
}

/// The bound is needed: without it, the sign of a rounded height is wrong for some of these points, and zero for others.
#[test]
fn without_the_bound_sides_would_be_wrong() {
    let mut rng = ChaCha8Rng::seed_from_u64(10);
    let mut wrong = 0;
    for _ in 0..200 {
        let points: Vec<Point3> = (0..6)
            .map(|_| {
                let (x, y) = (rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0));
                [x, y, 0.3 * x - 0.7 * y + 0.1]
            })
            .collect();
        let span = Span::of(&points);
        let [a, b, c] = [points[0], points[1], points[2]];
        let plane = Plane::through([a, b, c], &span);
        for &p in &points[3..] {
            let height = plane.height(p);
            assert_eq!(plane.side(height), Side::Unsure);
            wrong += usize::from(Sign::of(height) != Exact.orient3(a, b, c, p));
        }
    }
    assert!(wrong > 20, "{wrong} wrong signs");
}

/// Heights that overflow to minus infinity are not below a bound that does, too.
#[test]
fn overflow_leaves_the_question_open() {
    let points = [
        [-1e-105, 1e135, 1e-75],
        [1e105, -1e15, -1e135],
        [-1e135, -1e-15, 1e105],
        [-1e-15, -1e45, -1e135],
        [1e135, 1e105, -1e135],
    ];
    assert_true(&points);
    let span = Span::of(&points);
    let plane = Plane::through([points[0], points[1], points[2]], &span);
    assert_eq!(plane.side(plane.height(points[3])), Side::Unsure);
}

/// Both cases in which heights are exact: small integers, also far from the origin, and planes across an axis.
#[test]
fn points_in_a_plane_are_certainly_within() {
    let lattice: Vec<Point3> = (0..64)
        .map(|i| [i & 3, i >> 2 & 3, i >> 4].map(|x| f64::from(x) * 0.25 + 1e6))
        .collect();
    assert!(
        answers(&lattice)
            .iter()
            .all(|&(side, _)| side != Side::Unsure)
    );
    assert_true(&lattice);
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    for axis in 0..3 {
        let points: Vec<Point3> = (0..20)
            .map(|_| {
                let mut p = [(); 3].map(|()| rng.random_range(0.0..1.0));
                p[axis] = 0.7;
                p
            })
            .collect();
        assert!(
            answers(&points)
                .iter()
                .all(|&(side, _)| side == Side::Within)
        );
    }
}

/// A grid whose unit is not a power of two is none, and neither are points far apart.
#[test]
fn only_small_integers_are_taken_for_such() {
    let is_exact = |points: &[Point3]| Span::of(points).relative == 0.0;
    assert!(is_exact(&[[0.0; 3], [65535.0, 3.0, 1.0]]));
    assert!(!is_exact(&[[0.0; 3], [65535.5, 3.0, 1.0]]));
    assert!(!is_exact(&[[0.1; 3], [0.2, 0.3, 0.4]]));
    assert!(!is_exact(&[[1e-30, 0.0, 0.0], [5.0, 0.0, 0.0]]));
    assert!(!is_exact(&[[0.0; 3], [2.0_f64.powi(400), 0.0, 0.0]]));
}
