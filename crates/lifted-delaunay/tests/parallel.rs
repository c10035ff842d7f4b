//! The same triangulation on any number of threads.

use geometry_core::{Point2, Points};
use hull_verify::families::random;
use lifted_delaunay::{fast_delaunay, fast_delaunay_parallel};

fn assert_same(points: &[Point2]) {
    let points = Points::new(points).expect("finite points");
    let expected = fast_delaunay(points);
    for threads in [1, 2, 3, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("a few threads");
        let found = pool.install(|| fast_delaunay_parallel(points));
        assert!(
            found == expected,
            "{} points, {threads} threads",
            points.len()
        );
    }
}

/// Large enough that each of eight threads gets its own part.
const MANY: usize = 100_000;

#[test]
fn on_points_inside_and_on_a_circle() {
    let disc = random::disc(1, MANY);
    assert_same(&disc);
    // A third of the room for edges stays unused.
    let onto_circle = |&[x, y]: &Point2| [x / x.hypot(y), y / x.hypot(y)];
    let circle: Vec<Point2> = disc.iter().map(onto_circle).collect();
    assert_same(&circle);
}

#[test]
fn on_a_lattice_with_copies() {
    assert_same(&random::on_grid(2, 200, MANY));
}

#[test]
fn where_halves_are_uneven_or_flat() {
    let mut points = random::square(3, MANY);
    for point in &mut points[..MANY / 2] {
        *point = point.map(|x| x * 1e-9);
    }
    assert_same(&points);
    let line: Vec<Point2> = points.iter().map(|p| [p[0], 0.0]).collect();
    assert_same(&line);
    assert_same(&vec![[1.0, 2.0]; MANY]);
    for n in 0..5 {
        assert_same(&points[..n]);
    }
}
