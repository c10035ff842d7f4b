//! Point sets in space, and the hull by trying every plane.

use geometry_core::dimension::AffineBasis;
use geometry_core::{Exact, Hull3, Kernel3, Point3, Points, Sign, Solid};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeSet;

/// `n` points in the unit ball, in random order.
pub(crate) fn ball(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut points = Vec::with_capacity(n);
    while points.len() < n {
        let p: Point3 = std::array::from_fn(|_| rng.random_range(-1.0..1.0));
        if p.iter().map(|x| x * x).sum::<f64>() <= 1.0 {
            points.push(p);
        }
    }
    points
}

/// `n` points on the unit sphere, up to rounding, in random order.
pub(crate) fn sphere(seed: u64, n: usize) -> Vec<Point3> {
    ball(seed, n)
        .into_iter()
        .map(|p| {
            let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            p.map(|x| x / length)
        })
        .collect()
}

/// `n` points of the k × k × k integer grid, with repetition.
pub(crate) fn on_grid(seed: u64, k: u32, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..n)
        .map(|_| std::array::from_fn(|_| f64::from(rng.random_range(0..k))))
        .collect()
}

/// All points of the k × k × k integer grid.
pub(crate) fn grid(k: u32) -> Vec<Point3> {
    (0..k.pow(3))
        .map(|i| [i % k, i / k % k, i / k / k].map(f64::from))
        .collect()
}

/// The hull by trying the plane of every three points. O(n⁴).
pub(crate) fn brute_force(points: &[Point3]) -> Hull3 {
    let view = Points::new(points).expect("finite points");
    if let Ok(flat) = AffineBasis::of(view, &Exact).flat_hull(view, &Exact) {
        return flat;
    }
    let mut facets = BTreeSet::new();
    for a in view.ids() {
        for b in view.ids().filter(|&b| b > a) {
            for c in view.ids().filter(|&c| c > b) {
                facets.extend(facet_through(view, [a, b, c]));
            }
        }
    }
    Hull3::Solid(Solid::from_loops(facets.into_iter().collect()))
}

fn facet_through(points: Points<'_, 3>, triangle: [u32; 3]) -> Option<Vec<u32>> {
    let [a, b, c] = triangle.map(|id| points[id]);
    if Exact.collinear3(a, b, c) {
        return None;
    }
    let sides: Vec<Sign> = points
        .ids()
        .map(|id| Exact.orient3(a, b, c, points[id]))
        .collect();
    if sides.contains(&Sign::Positive) && sides.contains(&Sign::Negative) {
        return None;
    }
    let ids: Vec<u32> = points
        .ids()
        .filter(|&id| sides[id as usize].is_zero())
        .collect();
    let places: Vec<Point3> = ids.iter().map(|&id| points[id]).collect();
    let sub = Points::new(&places).expect("finite points");
    let hull = AffineBasis::of(sub, &Exact)
        .flat_hull(sub, &Exact)
        .expect("coplanar points");
    let mut corners: Vec<u32> = hull.vertices().iter().map(|&i| ids[i as usize]).collect();
    let inside = points.ids().find(|&id| !sides[id as usize].is_zero())?;
    let [p, q, r] = [0, 1, 2].map(|i| points[corners[i]]);
    if Exact.orient3(p, q, r, points[inside]).is_positive() {
        corners.reverse();
    }
    let first = (0..corners.len()).min_by_key(|&i| corners[i])?;
    corners.rotate_left(first);
    Some(corners)
}
