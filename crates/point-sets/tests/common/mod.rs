//! What the tests share: points of a spec, and hulls by a few lines of exact monotone chain.
#![allow(dead_code, reason = "each test file uses a part")]

use geometry_core::{Exact, Kernel2, Sign};
use point_sets::Spec;

pub(crate) type Point = [f64; 2];

pub(crate) fn points(spec: &str, n: usize, seed: u64) -> Vec<Point> {
    let spec: Spec = spec.parse().unwrap_or_else(|error| panic!("{error}"));
    spec.generate(n, seed)
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The corners of the hull of distinct points, or all its boundary points if `keep_straight`.
pub(crate) fn hull(points: &[Point], keep_straight: bool) -> Vec<Point> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| Exact.lexicographic(*a, *b));
    let mut boundary = Vec::new();
    for pass in 0..2 {
        let mut chain: Vec<Point> = Vec::new();
        for &point in &sorted {
            while let [.., a, b] = chain[..] {
                match Exact.orient(a, b, point) {
                    Sign::Positive => break,
                    Sign::Zero if keep_straight => break,
                    _ => chain.pop(),
                };
            }
            chain.push(point);
        }
        if pass == 0 || chain.len() > 1 {
            chain.pop();
        }
        boundary.extend(chain);
        sorted.reverse();
    }
    boundary
}

/// The sizes of the convex layers of distinct points, boundary points counted.
pub(crate) fn layers(points: &[Point]) -> Vec<usize> {
    let mut left = points.to_vec();
    let mut sizes = Vec::new();
    while !left.is_empty() {
        let mut layer = hull(&left, true);
        layer.sort_by(|a, b| Exact.lexicographic(*a, *b));
        layer.dedup();
        left.retain(|point| !layer.contains(point));
        sizes.push(layer.len());
    }
    sizes
}

/// Whether all points are on one line, exactly.
pub(crate) fn collinear(points: &[Point]) -> bool {
    let Some(other) = points.iter().find(|point| **point != points[0]) else {
        return true;
    };
    points
        .iter()
        .all(|point| Exact.orient(points[0], *other, *point) == Sign::Zero)
}
