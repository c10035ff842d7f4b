//! The Delaunay triangulation by every spatial method: always the same, always Delaunay.

use geometry_core::{Exact, Kernel3, Lifted, Method, Point2, Points, Task, Triangulation};
use hull_verify::families::random;
use point_sets::Spec;
use std::collections::HashMap;

fn spatial_methods() -> impl Iterator<Item = &'static Method> {
    hullkit::methods().filter(|method| matches!(method.task, Task::SpatialHull(_)))
}

fn certified(points: &[Point2]) -> Triangulation {
    let triangulation = hullkit::delaunay(points).expect("finite points");
    if let Err(findings) = hull_verify::check::delaunay(points, &triangulation) {
        panic!("{findings:?} of {points:?}");
    }
    triangulation
}

fn assert_same_by_all(points: &[Point2]) {
    let triangulation = certified(points);
    let methods = hullkit::methods().filter_map(|method| match method.task {
        Task::Delaunay(task) => Some((method.slug, task.exact)),
        _ => None,
    });
    for (slug, triangulate) in methods {
        let view = Points::new(points).expect("finite points");
        assert_eq!(triangulate(view).as_ref(), Ok(&triangulation), "{slug}");
    }
    for method in spatial_methods() {
        let other = hullkit::delaunay_by(method, points).expect("a spatial method");
        assert_eq!(other.as_ref(), Ok(&triangulation), "{}", method.slug);
    }
}

/// Points of the unit sphere, flattened, as in Nathan's figure 1.
fn flattened_sphere(seed: u64, n: usize) -> Vec<Point2> {
    let spec: Spec = "flattened-sphere".parse().expect("a set of the catalogue");
    spec.generate(n, seed)
        .expect("parameters at their defaults")
}

fn moved(points: &[Point2], offset: f64) -> Vec<Point2> {
    points.iter().map(|p| p.map(|x| x + offset)).collect()
}

#[test]
fn conformance() {
    let triangulates = |method: &&Method| matches!(method.task, Task::Delaunay(_));
    for method in hullkit::methods().filter(triangulates) {
        hull_verify::conformance::delaunay(method);
    }
}

#[test]
fn nathans_figure_1_by_every_method() {
    let points = flattened_sphere(1, 1_024);
    assert_same_by_all(&points);
}

#[test]
fn nathans_figure_1_far_from_the_origin() {
    let points = moved(&flattened_sphere(2, 1_024), 1e7);
    assert_same_by_all(&points);
}

#[test]
fn integer_grids_near_and_far() {
    let grid: Vec<Point2> = (0..1_024)
        .map(|i| [i % 32, i / 32].map(f64::from))
        .collect();
    let near = certified(&grid);
    assert_eq!(near.len(), 2 * 31 * 31);
    // Each cell is cut from its lower left corner to its upper right one.
    assert_eq!(near.triangles()[..2], [[0, 1, 33], [0, 33, 32]]);
    assert_eq!(certified(&moved(&grid, 1e7)), near);
    let small: Vec<Point2> = (0..64).map(|i| [i % 8, i / 8].map(f64::from)).collect();
    assert_same_by_all(&small);
    assert_same_by_all(&moved(&small, 1e7));
}

#[test]
fn copies_and_few_points_by_every_method() {
    for seed in 0..40 {
        for n in 0..12 {
            assert_same_by_all(&random::on_grid(seed, 3, n));
        }
    }
    for magnitude in [1e300, 1e-300, 5e-324] {
        let points: Vec<Point2> = random::on_grid(7, 16, 60)
            .iter()
            .map(|p| p.map(|x| x * magnitude))
            .collect();
        assert_same_by_all(&points);
    }
}

/// The apexes on either side of every inner edge.
fn quadruples(triangulation: &Triangulation) -> Vec<[u32; 4]> {
    let mut apexes: HashMap<[u32; 2], u32> = HashMap::new();
    for &[a, b, c] in triangulation.triangles() {
        for (edge, apex) in [([a, b], c), ([b, c], a), ([c, a], b)] {
            assert_eq!(apexes.insert(edge, apex), None, "{edge:?} is a side twice");
        }
    }
    let inner = apexes.iter().filter(|([a, b], _)| a < b);
    inner
        .filter_map(|(&[a, b], &apex)| Some([a, b, apex, *apexes.get(&[b, a])?]))
        .collect()
}

/// The share of local questions that an exact orientation of rounded lifts answers wrongly.
fn wrong_signs(points: &[Point2]) -> f64 {
    let quadruples = quadruples(&certified(points));
    let is_wrong = |quadruple: &&[u32; 4]| {
        let flat = quadruple.map(|id| points[id as usize]);
        let lifted = flat.map(|[x, y]| [x, y, x * x + y * y]);
        let [[a, b, c, d], [p, q, r, s]] = [flat.map(|[x, y]| [x, y, 0.0]), lifted];
        Lifted(Exact).orient3(a, b, c, d) != Exact.orient3(p, q, r, s)
    };
    quadruples.iter().filter(is_wrong).count() as f64 / quadruples.len() as f64
}

#[test]
fn rounded_heights_answer_the_wrong_question() {
    let points = random::square(3, 1_000);
    assert_eq!(wrong_signs(&points), 0.0);
    let at_a_million = wrong_signs(&moved(&points, 1e6));
    assert!((0.03..0.12).contains(&at_a_million), "{at_a_million}");
    let at_ten_million = wrong_signs(&moved(&points, 1e7));
    assert!((0.42..0.55).contains(&at_ten_million), "{at_ten_million}");
    // Heights of quarters do not round.
    let quarters: Vec<Point2> = (0..400)
        .map(|i| [i % 20, i / 20].map(|x| f64::from(x) / 4.0))
        .collect();
    assert_eq!(wrong_signs(&quarters), 0.0);
}
