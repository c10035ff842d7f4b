//! What Preparata and Hong's method asks, counted: the merges together are linear.

use geometry_core::Step::*;
use geometry_core::{
    Boundary, Counted, Exact, Hull2, Point2, Points, QuestionCounts, Recorder, Tally,
};
use hull_verify::families::{curves, grids, random};

fn counted(points: &[Point2], boundary: Boundary) -> (Hull2, QuestionCounts, Tally) {
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let points = Points::new(points).expect("finite points");
    let hull = divide_and_conquer::preparata_hong_2d(points, boundary, &kernel, &mut tally)
        .expect("an exact kernel");
    (hull, kernel.counts(), tally)
}

/// The proved bound, 2 a step and 2 a line, on sets that walk far and sets that do not.
#[test]
fn merges_are_linear() {
    let sets = [
        random::disc(8, 20_000),
        random::square(9, 20_000),
        curves::circle(4_096),
        curves::parabola(1_000),
        grids::lattice(70),
        grids::columns(50, 50),
    ];
    for points in sets {
        let n = points.len() as u64;
        for boundary in [Boundary::Extreme, Boundary::All] {
            let (hull, counts, tally) = counted(&points, boundary);
            let asked = counts.orientations.total();
            assert_eq!((tally.merges, tally.bridges), (n - 1, 2 * (n - 1)));
            assert!(
                asked <= 2 * tally.pops + 4 * (n - 1),
                "{asked} for {n} points"
            );
            assert!(asked < 5 * n, "{asked} for {n} points");
            // Each place starts on both chains; the two ends of the hull stay on both.
            assert_eq!(2 * n - tally.pops, hull.len() as u64 + 2);
        }
    }
}

/// The count a point does not grow with n.
#[test]
fn orientations_on_a_disc_are_four_a_point() {
    for n in [1_000, 10_000, 100_000] {
        let (_, counts, _) = counted(&random::disc(10, n), Boundary::Extreme);
        let per_point = counts.orientations.total() as f64 / n as f64;
        assert!((3.9..4.2).contains(&per_point), "{per_point} at n = {n}");
    }
}

/// Two upright segments side by side, the right one longer, and the walk down its side.
#[test]
fn a_trace_tells_the_walk() {
    let points = [[0.0, 0.0], [0.0, 1.0], [1.0, -2.0], [1.0, 1.0]];
    let points = Points::new(&points).expect("finite points");
    let mut recorder = Recorder::default();
    divide_and_conquer::preparata_hong_2d(points, Boundary::Extreme, &Exact, &mut recorder)
        .expect("an exact kernel");
    #[rustfmt::skip]
    let last_merge = [
        Line(1, 2), Pop(1), Line(0, 2), Bridge(0, 2), // below: from the top of the left segment to its foot
        Line(1, 2), Pop(2), Line(1, 3), Bridge(1, 3), // above: from the foot of the right segment to its top
        Merge(4),
    ];
    assert!(
        recorder.steps.ends_with(&last_merge),
        "{:?}",
        recorder.steps
    );
}
