//! Triangulations against the definition: no point inside the circle of a triangle, and the outline filled.
//!
//! The hull method is the plainest there is, every plane through three points, so these sets are small; larger ones
//! go through every registered method in the tests of `hullkit`.

use geometry_core::dimension::AffineBasis;
use geometry_core::hull3::Solid;
use geometry_core::{
    Exact, Hull3, HullError, InCircle, Kernel2, Kernel3, Lifted, Point2, Point3, Points,
    Triangulation,
};
use hull_verify::check;
use hull_verify::families::{curves, random};
use lifted_delaunay::{Voronoi, VoronoiEdge, delaunay_with};
use std::collections::BTreeSet;

/// The hull by trying the plane of every three points.
fn every_plane<K: Kernel3>(points: Points<'_, 3>, kernel: &K) -> Result<Hull3, HullError> {
    if let Ok(flat) = AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        return Ok(flat);
    }
    let mut facets = BTreeSet::new();
    for a in points.ids() {
        for b in a + 1..points.len() as u32 {
            for c in b + 1..points.len() as u32 {
                facets.extend(facet_through(points, [a, b, c], kernel));
            }
        }
    }
    Ok(Hull3::Solid(Solid::from_loops(
        facets.into_iter().collect(),
    )))
}

fn facet_through<K: Kernel3>(
    points: Points<'_, 3>,
    [a, b, c]: [u32; 3],
    kernel: &K,
) -> Option<Vec<u32>> {
    let side = |id: u32| kernel.orient3(points[a], points[b], points[c], points[id]);
    let inside = points.ids().find(|&id| !side(id).is_zero())?;
    if points.ids().any(|id| side(id) == -side(inside))
        || kernel.collinear3(points[a], points[b], points[c])
    {
        return None;
    }
    let ids: Vec<u32> = points.ids().filter(|&id| side(id).is_zero()).collect();
    let places: Vec<Point3> = ids.iter().map(|&id| points[id]).collect();
    let sub = Points::new(&places).ok()?;
    let hull = AffineBasis::of(sub, kernel).flat_hull(sub, kernel).ok()?;
    let mut corners: Vec<u32> = hull.vertices().iter().map(|&i| ids[i as usize]).collect();
    let [p, q, r] = [0, 1, 2].map(|i| points[corners[i]]);
    if kernel.orient3(p, q, r, points[inside]).is_positive() {
        corners.reverse();
    }
    let first = (0..corners.len()).min_by_key(|&i| corners[i])?;
    corners.rotate_left(first);
    Some(corners)
}

fn triangulated(points: &[Point2]) -> Triangulation {
    let view = Points::new(points).expect("finite points");
    delaunay_with(view, &Lifted(Exact), every_plane).expect("an exact kernel")
}

fn assert_delaunay(points: &[Point2]) -> Triangulation {
    let triangulation = triangulated(points);
    if let Err(findings) = check::delaunay(points, &triangulation) {
        panic!("{findings:?} of {points:?}");
    }
    triangulation
}

/// The definition once more, by the in-circle question that the construction asked in another guise.
fn assert_empty_circles(points: &[Point2]) {
    for &corners in assert_delaunay(points).triangles() {
        let [a, b, c] = corners.map(|id| points[id as usize]);
        assert!(
            Exact.orient(a, b, c).is_positive(),
            "{corners:?} of {points:?}"
        );
        let is_inside = |&p: &Point2| Exact.in_circle(a, b, c, p).is_positive();
        assert!(!points.iter().any(is_inside), "{corners:?} of {points:?}");
    }
}

#[test]
fn small_grids_with_copies() {
    for seed in 0..300 {
        for n in 0..10 {
            assert_empty_circles(&random::on_grid(seed, 2 + seed as u32 % 3, n));
        }
    }
}

#[test]
fn larger_grids() {
    for seed in 0..20 {
        assert_empty_circles(&random::on_grid(seed, 6, 30));
    }
}

#[test]
fn random_sets() {
    for seed in 0..10 {
        assert_empty_circles(&random::disc(seed, 40));
        assert_empty_circles(&random::near_a_line(seed, 30));
    }
    assert_empty_circles(&curves::parabola(30));
}

#[test]
fn every_magnitude() {
    for scale in [1e300, 1e-300, 5e-324] {
        for seed in 0..10 {
            let points: Vec<Point2> = random::on_grid(seed, 8, 20)
                .iter()
                .map(|p| p.map(|x| x * scale))
                .collect();
            assert_delaunay(&points);
        }
    }
    assert_delaunay(&[
        [f64::MAX, 0.0],
        [-f64::MAX, 1.0],
        [0.0, f64::MAX],
        [5e-324, -f64::MAX],
        [0.0, 0.0],
    ]);
}

#[test]
fn far_from_the_origin() {
    for seed in 0..10 {
        let near = random::on_grid(seed, 10, 25);
        let far: Vec<Point2> = near.iter().map(|p| p.map(|x| x + 1e7)).collect();
        assert_eq!(assert_delaunay(&near), assert_delaunay(&far));
        // Tenths round differently at each place, so the cells of this grid are not quite cocircular.
        let tenths: Vec<Point2> = near.iter().map(|p| p.map(|x| 1e7 + 0.1 * x)).collect();
        assert_delaunay(&tenths);
    }
}

#[test]
fn the_order_of_the_points_does_not_matter() {
    let points: Vec<Point2> = (0..25)
        .map(|i| [f64::from(i % 5), f64::from(i / 5)])
        .collect();
    let reversed: Vec<Point2> = points.iter().rev().copied().collect();
    let places = |points: &[Point2]| {
        let triangles = assert_delaunay(points);
        let mut places: Vec<[Point2; 3]> = triangles
            .triangles()
            .iter()
            .map(|corners| {
                let mut places = corners.map(|id| points[id as usize]);
                places.sort_by(|p, q| p.partial_cmp(q).expect("finite"));
                places
            })
            .collect();
        places.sort_by(|s, t| s.partial_cmp(t).expect("finite"));
        places
    };
    assert_eq!(places(&points), places(&reversed));
}

#[test]
fn the_dual_has_a_vertex_a_triangle_and_an_edge_an_edge() {
    for seed in 0..10 {
        let points = random::disc(seed, 30);
        let triangulation = triangulated(&points);
        let voronoi = Voronoi::of(Points::new(&points).expect("finite points"), &triangulation);
        assert_eq!(voronoi.vertices.len(), triangulation.len());
        let rays = voronoi
            .edges
            .iter()
            .filter(|edge| matches!(edge, VoronoiEdge::Ray { .. }));
        assert_eq!(rays.count(), triangulation.hull_edges().len());
        let edges: Vec<[u32; 2]> = voronoi
            .edges
            .iter()
            .map(|edge| edge.sites())
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        assert_eq!(edges, triangulation.edges());
        // A vertex is equally far from the three points around it, and no nearer to any other.
        for (&[x, y], &corners) in voronoi.vertices.iter().zip(triangulation.triangles()) {
            let distance = |p: &Point2| ((p[0] - x).powi(2) + (p[1] - y).powi(2)).sqrt();
            let radius = distance(&points[corners[0] as usize]);
            for id in corners {
                assert!((distance(&points[id as usize]) / radius - 1.0).abs() < 1e-9);
            }
            assert!(points.iter().all(|p| distance(p) > radius * (1.0 - 1e-9)));
        }
    }
}
