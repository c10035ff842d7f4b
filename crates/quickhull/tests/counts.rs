//! What Eddy's method asks, counted: the machine-independent side of its cost.

use geometry_core::Step::*;
use geometry_core::{Boundary, Counted, Exact, Hull2, Points, QuestionCounts, Recorder, Tally};
use hull_verify::families::{curves, grids, random};

fn counted(points: &[[f64; 2]], boundary: Boundary) -> (Hull2, QuestionCounts, Tally) {
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let points = Points::new(points).expect("finite points");
    let hull = quickhull::eddy(points, boundary, &kernel, &mut tally).expect("an exact kernel");
    (hull, kernel.counts(), tally)
}

/// Uniform in a disc: the limit of the number of orientations a point is 3.7457, that of method GS.
#[test]
fn orientations_on_a_disc_are_linear() {
    for n in [1_000, 10_000, 100_000] {
        let (_, counts, _) = counted(&random::disc(1, n), Boundary::Extreme);
        let per_point = counts.orientations.total() as f64 / n as f64;
        assert!((3.5..3.9).contains(&per_point), "{per_point} at n = {n}");
    }
}

/// On a circle, where no point is ever dropped, about 1.5 log2 n - 3 a point.
#[test]
fn orientations_on_a_circle_grow_with_the_logarithm() {
    for n in [1_000, 8_000] {
        let (_, counts, _) = counted(&curves::circle(n), Boundary::Extreme);
        let per_point = counts.orientations.total() as f64 / f64::from(n);
        let expected = 1.5 * f64::from(n).log2() - 3.0;
        assert!(
            (per_point / expected - 1.0).abs() < 0.1,
            "{per_point} for {expected}"
        );
    }
}

#[test]
fn each_visit_is_one_orientation() {
    for points in [
        random::disc(2, 500),
        grids::lattice(12),
        curves::parabola(60),
    ] {
        for boundary in [Boundary::Extreme, Boundary::All] {
            let (hull, counts, tally) = counted(&points, boundary);
            assert_eq!(tally.visits, counts.orientations.total());
            // All vertices but the first two are inserted; each edge is confirmed once.
            assert_eq!(tally.inserts as usize, hull.len() - 2);
            assert_eq!(tally.edges as usize, hull.len());
        }
    }
}

/// The trace of a triangle above its base with one point inside: one SPLIT a line.
#[test]
fn a_trace_tells_the_splits() {
    let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 4.0], [2.0, 1.0]];
    let points = Points::new(&points).expect("finite points");
    let mut recorder = Recorder::default();
    quickhull::eddy(points, Boundary::Extreme, &Exact, &mut recorder).expect("an exact kernel");
    #[rustfmt::skip]
    let expected = [
        Line(1, 0), Visit(2), Visit(3),                       // the first line: both points are above it
        Apex(2), Insert(2), Line(1, 2), Visit(3), Storage(1), // 3 is not above 1 -> 2 and laid aside
        Edge(1, 2),
        Line(2, 0), Visit(3), Discard(3),                     // nor above 2 -> 0: in the triangle
        Edge(2, 0),
        Edge(0, 1),                                           // nothing below the first line
    ];
    assert_eq!(recorder.steps, expected);
}
