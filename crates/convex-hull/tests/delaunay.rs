//! The Delaunay triangulation by every spatial method: always the same, always Delaunay.

use geometry_core::{Exact, InCircle, Kernel2, Method, Point2, Task, Triangulation};
use hull_verify::families::random;
use std::collections::HashMap;

fn spatial_methods() -> impl Iterator<Item = &'static Method> {
    hullkit::methods().filter(|method| matches!(method.task, Task::SpatialHull(_)))
}

fn assert_same_by_all(points: &[Point2]) -> Triangulation {
    let triangulation = hullkit::delaunay(points).expect("finite points");
    for method in spatial_methods() {
        let other = hullkit::delaunay_by(method, points).expect("a spatial method");
        assert_eq!(other.as_ref(), Ok(&triangulation), "{}", method.slug);
    }
    triangulation
}

/// Locally Delaunay at every edge, and a triangulation of the convex hull: together, Delaunay.
fn assert_delaunay(points: &[Point2], triangulation: &Triangulation) {
    let place = |id: u32| points[id as usize];
    let mut apexes: HashMap<[u32; 2], u32> = HashMap::new();
    for &[a, b, c] in triangulation.triangles() {
        assert!(Exact.orient(place(a), place(b), place(c)).is_positive());
        for (edge, apex) in [([a, b], c), ([b, c], a), ([c, a], b)] {
            assert_eq!(apexes.insert(edge, apex), None);
        }
    }
    for (&[a, b], &apex) in &apexes {
        if let Some(&other) = apexes.get(&[b, a]) {
            let inside = Exact.in_circle(place(a), place(b), place(apex), place(other));
            assert!(!inside.is_positive(), "{a} {b} {apex} {other}");
        }
    }
    let outline = triangulation.hull_edges();
    let hull = hullkit::convex_hull_2d_with(points, hullkit::Boundary::All).expect("finite points");
    assert_eq!(outline.len(), hull.len());
    let used: std::collections::BTreeSet<u32> = triangulation
        .triangles()
        .iter()
        .flatten()
        .copied()
        .collect();
    assert_eq!(triangulation.len(), 2 * used.len() - outline.len() - 2);
}

/// Points of the unit sphere, flattened, as in Nathan's figure 1.
fn flattened_sphere(seed: u64, n: usize) -> Vec<Point2> {
    // Uniform on the sphere: the height is uniform. Here only the disc matters, where the density grows outward.
    random::disc(seed, n)
        .into_iter()
        .map(|[x, y]| {
            let squared = x * x + y * y;
            // Archimedes: r² of the disc uniform becomes 1 - |height|; the radius is sqrt(1 - (1 - r²)²).
            let stretch = (2.0 - squared).sqrt();
            [x * stretch, y * stretch]
        })
        .collect()
}

fn moved(points: &[Point2], offset: f64) -> Vec<Point2> {
    points.iter().map(|p| p.map(|x| x + offset)).collect()
}

#[test]
fn nathans_figure_1_by_every_method() {
    let points = flattened_sphere(1, 1_024);
    let triangulation = assert_same_by_all(&points);
    assert_delaunay(&points, &triangulation);
}

#[test]
fn nathans_figure_1_far_from_the_origin() {
    let points = moved(&flattened_sphere(2, 1_024), 1e7);
    let triangulation = assert_same_by_all(&points);
    assert_delaunay(&points, &triangulation);
}

#[test]
fn integer_grids_near_and_far() {
    let grid: Vec<Point2> = (0..1_024)
        .map(|i| [i % 32, i / 32].map(f64::from))
        .collect();
    let near = hullkit::delaunay(&grid).expect("finite points");
    assert_eq!(near.len(), 2 * 31 * 31);
    // Each cell is cut from its lower left corner to its upper right one.
    assert_eq!(near.triangles()[..2], [[0, 1, 33], [0, 33, 32]]);
    assert_delaunay(&grid, &near);
    assert_eq!(hullkit::delaunay(&moved(&grid, 1e7)), Ok(near));
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
        let triangulation = assert_same_by_all(&points);
        assert_delaunay(&points, &triangulation);
    }
}
