//! `fast-delaunay` against `lifted-delaunay`: equal values, on many small sets of every degenerate kind.

use geometry_core::{Method, Point2, Points, Task, Triangulation};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The number of sets; for a long run, set this variable of the environment and build with `--release`.
const CASES: &str = "DELAUNAY_CASES";
const CASES_BY_DEFAULT: u64 = 4_000;

fn by(slug: &str, points: &[Point2]) -> Triangulation {
    let Some(Method {
        task: Task::Delaunay(task),
        ..
    }) = hullkit::method(slug)
    else {
        panic!("{slug} is registered");
    };
    (task.exact)(Points::new(points).expect("finite points")).expect("few points")
}

fn assert_equal(points: &[Point2], seed: u64) {
    let [fast, lifted] = ["fast-delaunay", "lifted-delaunay"].map(|slug| by(slug, points));
    assert!(
        fast == lifted,
        "seed {seed}: {points:?}\nfast   {fast:?}\nlifted {lifted:?}"
    );
}

/// What is known of the lattice points on a circle: x² + y² = 5⁴ · 13².
fn on_a_circle() -> Vec<Point2> {
    let side = -325_i32..=325;
    let all = side.clone().flat_map(|x| side.clone().map(move |y| (x, y)));
    let on = all.filter(|(x, y)| x * x + y * y == 325 * 325);
    on.map(|(x, y)| [x, y].map(f64::from)).collect()
}

/// A small set of one of the kinds, with anything from no points to fifty.
fn degenerate(rng: &mut ChaCha8Rng, circle: &[Point2]) -> Vec<Point2> {
    let n = rng.random_range(0..50);
    let kind = rng.random_range(0..9);
    let k = rng.random_range(1..8);
    let mut points: Vec<Point2> = (0..n)
        .map(|_| {
            let mut small = || f64::from(rng.random_range(-k..=k));
            let grid: Point2 = [small(), small()];
            let unit: Point2 = [rng.random(), rng.random()];
            match kind {
                0 => grid,
                // Cocircular, with whatever the grid adds.
                1 => circle[rng.random_range(0..circle.len())],
                2 if rng.random() => circle[rng.random_range(0..circle.len())],
                2 => grid,
                // On one line, and nearly.
                3 => [grid[0] * 3.0, grid[0] * 7.0],
                4 => [grid[0] / 3.0, grid[0] * 7.0 / 3.0],
                5 => [unit[0], unit[0] / 3.0 + grid[1] * f64::EPSILON / 8.0],
                6 => unit,
                // Magnitudes side by side.
                7 => grid.map(|x| x * 10_f64.powi(rng.random_range(-3..=3) * 100)),
                _ => [grid[0] * 1e-30, grid[1]],
            }
        })
        .collect();
    let [factor, offset] = match rng.random_range(0..8) {
        0 => [1.0, 1e7],
        1 => [0.1, 1e7],
        2 => [1e-300, 0.0],
        3 => [5e-324, 0.0],
        4 => [1e5, -1e15],
        _ => [1.0, 0.0],
    };
    for point in &mut points {
        *point = point.map(|x| x * factor + offset);
    }
    let copies: Vec<Point2> = (0..points.len() / 5)
        .map(|_| points[rng.random_range(0..points.len())])
        .collect();
    points.extend(copies);
    points
}

#[test]
fn on_degenerate_sets() {
    let cases = std::env::var(CASES).map_or(CASES_BY_DEFAULT, |number| {
        number.parse().expect("the number of cases")
    });
    let circle = on_a_circle();
    for seed in 0..cases {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        assert_equal(&degenerate(&mut rng, &circle), seed);
    }
}

/// Large enough for grids within grids, and for the median where they fail.
#[test]
fn on_larger_sets() {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut assert_on = |make: &mut dyn FnMut(&mut ChaCha8Rng) -> Point2| {
        let points: Vec<Point2> = (0..3_000).map(|_| make(&mut rng)).collect();
        assert_equal(&points, 1);
    };
    assert_on(&mut |rng| [rng.random(), rng.random()]);
    // An integer grid far away, every place about three times.
    assert_on(&mut |rng| [0, 1].map(|_| 1e7 + f64::from(rng.random_range(0..32))));
    // Ever closer to the origin: no grid divides them.
    assert_on(&mut |rng| {
        let factor = 2_f64.powi(-rng.random_range(0..900));
        [0, 1].map(|_| rng.random::<f64>() * factor)
    });
    // Most of them on one upright line.
    assert_on(&mut |rng| {
        let off = if rng.random_range(0..10) == 0 {
            rng.random()
        } else {
            0.0
        };
        [off, rng.random()]
    });
    assert_on(&mut |rng| {
        let x: f64 = rng.random_range(-1.0..1.0);
        [x, x * x]
    });
    assert_on(&mut |rng| [0, 1].map(|_| f64::MAX * rng.random_range(-1.0..1.0)));
}

/// The triangles by places, whatever the names.
fn by_places(points: &[Point2]) -> Vec<[Point2; 3]> {
    let order = |p: &Point2, q: &Point2| p.partial_cmp(q).expect("finite");
    let triangulation = by("fast-delaunay", points);
    let mut places: Vec<[Point2; 3]> = triangulation
        .triangles()
        .iter()
        .map(|corners| {
            let mut places = corners.map(|id| points[id as usize]);
            places.sort_by(order);
            places
        })
        .collect();
    places.sort_by(|s, t| s.partial_cmp(t).expect("finite"));
    places
}

#[test]
fn the_order_of_the_points_does_not_matter() {
    let circle = on_a_circle();
    for seed in 0..500 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut points = degenerate(&mut rng, &circle);
        let expected = by_places(&points);
        for i in (1..points.len()).rev() {
            points.swap(i, rng.random_range(0..=i));
        }
        assert_eq!(by_places(&points), expected, "seed {seed}: {points:?}");
    }
}
