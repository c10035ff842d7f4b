//! What `fast-delaunay` asks, counted: the machine-independent side of its cost.

use geometry_core::{Point2, Points, QuestionCounts};
use hull_verify::families::random;
use lifted_delaunay::{fast_delaunay, fast_delaunay_counted};

fn asked(points: &[Point2]) -> QuestionCounts {
    let points = Points::new(points).expect("finite points");
    let (triangulation, counts) = fast_delaunay_counted(points).expect("few points");
    assert_eq!(fast_delaunay(points), Ok(triangulation));
    counts
}

fn lattice(side: u32) -> Vec<Point2> {
    let cells = 0..side * side;
    cells.map(|i| [i % side, i / side].map(f64::from)).collect()
}

fn circle(n: u32) -> Vec<Point2> {
    let angle = |i: u32| f64::from(i) / f64::from(n) * std::f64::consts::TAU;
    (0..n).map(|i| [angle(i).cos(), angle(i).sin()]).collect()
}

/// In-circle questions a point.
fn in_circles(points: &[Point2]) -> f64 {
    asked(points).in_circles.total() as f64 / points.len() as f64
}

/// Merges of neighbours dominate, and there are about as many for a point whatever the number of points.
#[test]
fn in_circles_a_point_do_not_grow() {
    for make in [random::square, random::disc] {
        let [few, more, many] = [1_000, 10_000, 100_000].map(|n| in_circles(&make(1, n)));
        assert!((6.5..6.7).contains(&few), "{few}");
        assert!((6.9..7.1).contains(&more), "{more}");
        assert!((7.0..7.3).contains(&many), "{many}");
    }
}

#[test]
fn on_a_circle_they_do_not_grow_either() {
    let [few, more, many] = [1_000, 10_000, 100_000].map(|n| in_circles(&circle(n)));
    for found in [few, more, many] {
        assert!((3.9..4.1).contains(&found), "{found}");
    }
}

/// Wherever the lattice is and whatever its spacing, as long as coordinates are not rounded.
#[test]
fn on_a_lattice_nothing_is_looked_at_closely() {
    let lattice = lattice(100);
    for [factor, offset] in [
        [1.0, 0.0],
        [1.0, 1e7],
        [0.125, -3e6],
        [2_f64.powi(190), 0.0],
    ] {
        let moved: Vec<Point2> = lattice
            .iter()
            .map(|p| p.map(|x| x * factor + offset))
            .collect();
        let counts = asked(&moved);
        let closely = |counts: geometry_core::StageCounts| counts.adaptive + counts.integer;
        assert_eq!(closely(counts.in_circles), 0, "{factor} {offset}");
        assert_eq!(closely(counts.orientations), 0, "{factor} {offset}");
        let found = counts.in_circles.total() as f64 / lattice.len() as f64;
        assert!((4.05..4.15).contains(&found), "{found}");
    }
}

/// Questions about points far apart on a circle are hard, but most are about neighbours.
#[test]
fn on_a_circle_few_are_looked_at_closely() {
    let counts = asked(&circle(100_000)).in_circles;
    let closely = (counts.adaptive + counts.integer) as f64 / counts.total() as f64;
    assert!(closely < 0.06, "{closely}");
}
