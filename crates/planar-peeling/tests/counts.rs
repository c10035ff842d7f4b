//! What the methods ask, counted: the machine-independent side of their cost.

use geometry_core::Step::*;
use geometry_core::{
    Boundary, Counted, Exact, Hull2, HullError, Points, QuestionCounts, Recorder, Tally,
};
use hull_verify::families::{curves, grids, random};
use planar_peeling::graham::graham;
use planar_peeling::gs::{gs, gs_bare};
use planar_peeling::monotone_chain::monotone_chain;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Run = fn(Points<'_, 2>, Boundary, &Counted<Exact>, &mut Tally) -> Result<Hull2, HullError>;

fn counted(run: Run, points: &[[f64; 2]], boundary: Boundary) -> (Hull2, QuestionCounts, Tally) {
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let points = Points::new(points).expect("finite points");
    let hull = run(points, boundary, &kernel, &mut tally).expect("an exact kernel");
    (hull, kernel.counts(), tally)
}

/// Orientations a point of method GS, averaged over sets made from seeds 1 to `sets`.
fn orientations_per_point(n: usize, sets: u64, make: fn(u64, usize) -> Vec<[f64; 2]>) -> f64 {
    let total: u64 = (1..=sets)
        .map(|seed| counted(gs, &make(seed, n), Boundary::Extreme).1)
        .map(|counts| counts.orientations.total())
        .sum();
    total as f64 / (n as f64 * sets as f64)
}

fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off < tolerance, "{found}, {expected} was expected");
}

/// Uniform in a disc: on the way to the limit 3.7457. The tolerances are three standard errors or more, and less
/// than what two superfluous questions a hull would add at n = 100.
#[test]
fn gs_on_a_disc() {
    assert_near(orientations_per_point(100, 400, random::disc), 3.468, 0.018);
    assert_near(
        orientations_per_point(1_000, 60, random::disc),
        3.718,
        0.018,
    );
    assert_near(
        orientations_per_point(10_000, 10, random::disc),
        3.747,
        0.017,
    );
    assert_near(
        orientations_per_point(300_000, 1, random::disc),
        3.7457,
        0.012,
    );
}

/// Normally distributed: one question at the base line and two at the first triangle, in the limit 3.
#[test]
fn gs_on_normal_points() {
    assert_near(orientations_per_point(10_000, 10, normal), 3.033, 0.02);
    assert_near(orientations_per_point(100_000, 2, normal), 3.014, 0.01);
}

fn normal(seed: u64, n: usize) -> Vec<[f64; 2]> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut point = || {
        let radius = (-2.0 * (1.0 - rng.random::<f64>()).ln()).sqrt();
        let (sine, cosine) = (std::f64::consts::TAU * rng.random::<f64>()).sin_cos();
        [radius * cosine, radius * sine]
    };
    (0..n).map(|_| point()).collect()
}

/// On a circle no point is ever inside, and each is asked again at every level: 1.5 log2 n - 3.0.
#[test]
fn gs_on_a_circle() {
    for (n, sets) in [(1_000, 10), (10_000, 2)] {
        let expected = 1.5 * (n as f64).log2() - 3.0;
        assert_near(orientations_per_point(n, sets, on_circle), expected, 0.15);
    }
}

fn on_circle(seed: u64, n: usize) -> Vec<[f64; 2]> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut point = || {
        let (sine, cosine) = (std::f64::consts::TAU * rng.random::<f64>()).sin_cos();
        [cosine, sine]
    };
    (0..n).map(|_| point()).collect()
}

/// On the geometric parabola every level scans all that is left and finds one vertex: 0.746 n².
#[test]
fn gs_on_its_worst_case() {
    let stretch = 2.0_f64.powi(1013);
    let abscissae = std::iter::successors(Some(1.0), |x| Some(-0.5698 * x));
    let points: Vec<[f64; 2]> = abscissae
        .take(800)
        .map(|x: f64| [x, -(x * stretch * x)])
        .collect();
    let (hull, counts, _) = counted(gs, &points, Boundary::Extreme);
    assert_eq!(hull.len(), 800);
    let square = (points.len() as f64).powi(2);
    assert_near(counts.orientations.total() as f64 / square, 0.746, 0.01);
}

/// Each point but the extremes is asked once about the base line, and then once or twice a split. Choosing the
/// furthest compares each listed point once, except the first of its list.
#[test]
fn gs_asks_no_question_twice() {
    for run in [gs as Run, gs_bare] {
        for points in [random::disc(2, 500), curves::circle(500)] {
            let (_, counts, tally) = counted(run, &points, Boundary::Extreme);
            let n = points.len() as u64;
            let visits_in_splits = tally.visits - n - (n - 2);
            let orientations_in_splits = counts.orientations.total() - (n - 2);
            assert!(orientations_in_splits >= visits_in_splits);
            assert!(orientations_in_splits <= 2 * visits_in_splits);
            assert_eq!(counts.distances.total(), visits_in_splits);
            assert_eq!(counts.along, 0);
        }
    }
}

/// One triangle below the base line with a point inside, nothing above.
#[test]
fn gs_tells_what_it_does() {
    let points = [[0.0, 4.0], [4.0, 4.0], [2.0, 0.0], [2.0, 3.0]];
    let points = Points::new(&points).expect("finite points");
    let mut recorder = Recorder::default();
    gs(points, Boundary::Extreme, &Exact, &mut recorder).expect("an exact kernel");
    #[rustfmt::skip]
    let expected = [
        Visit(3), Visit(2), Visit(1), Visit(0),         // for the extremes
        Line(0, 1), Visit(3), Visit(2),                 // both are outside [0 1]
        Line(0, 1), Apex(2), Visit(3), Discard(3),      // [0 1] becomes [0 2] and [2 1], both empty
        Storage(3),
        Edge(0, 2), Storage(3), Edge(2, 1), Storage(3), Edge(1, 0), Storage(3),
    ];
    assert_eq!(recorder.steps, expected);
}

/// Each orientation of a scan keeps a point or removes one for good.
#[test]
fn scans_are_linear() {
    for points in [
        random::disc(3, 2_000),
        curves::circle(2_000),
        grids::lattice(45),
    ] {
        for boundary in [Boundary::Extreme, Boundary::All] {
            let n = points.len() as u64;
            let (_, counts, _) = counted(monotone_chain, &points, boundary);
            assert!(counts.orientations.total() < 4 * n);
            let (_, counts, tally) = counted(graham, &points, boundary);
            // Each comparison of angles may take an orientation inside, which only the angle count shows.
            assert!(counts.orientations.total() < 2 * n + 4);
            assert!(tally.pops < n);
        }
    }
}
