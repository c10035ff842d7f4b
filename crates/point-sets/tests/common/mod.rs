//! What the tests share: points of a spec, and hulls by a few lines of exact monotone chain.
#![allow(dead_code, reason = "each test file uses a part")]

use geometry_core::{Axis, Exact, Kernel2, Kernel3, Sign};
use point_sets::Spec;
use std::collections::BTreeSet;

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

pub(crate) type Point3 = [f64; 3];

pub(crate) fn points3(spec: &str, n: usize, seed: u64) -> Vec<Point3> {
    let spec: Spec = spec.parse().unwrap_or_else(|error| panic!("{error}"));
    spec.generate3(n, seed)
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The facets of the hull of distinct points, by trying every triple: for each the points in its plane.
pub(crate) fn facets(points: &[Point3]) -> BTreeSet<BTreeSet<usize>> {
    let n = points.len();
    let triples =
        (0..n).flat_map(|a| (a + 1..n).flat_map(move |b| (b + 1..n).map(move |c| [a, b, c])));
    let mut found = BTreeSet::new();
    for corners in triples {
        let [a, b, c] = corners.map(|id| points[id]);
        let mut sides = [false; 2];
        let mut plane = BTreeSet::new();
        for (id, d) in points.iter().enumerate() {
            match Exact.orient3(a, b, c, *d) {
                Sign::Zero => drop(plane.insert(id)),
                sign => sides[usize::from(sign == Sign::Positive)] = true,
            }
            if sides == [true; 2] {
                break;
            }
        }
        if sides != [true; 2] && !Exact.collinear3(a, b, c) {
            found.insert(plane);
        }
    }
    found
        .into_iter()
        .map(|plane| corners_in_plane(points, &plane))
        .collect()
}

/// The corners among coplanar points: those that are strictly outside some line through two others.
fn corners_in_plane(points: &[Point3], plane: &BTreeSet<usize>) -> BTreeSet<usize> {
    let ids: Vec<usize> = plane.iter().copied().collect();
    let [a, b, c] = spanning(points, &ids);
    let axis = *Axis::ALL
        .iter()
        .find(|&&axis| !Exact.shadow(axis, a, b, c).is_zero())
        .expect("a plane has a shadow");
    let flat: Vec<Point> = ids.iter().map(|&id| axis.shadow_of(points[id])).collect();
    let corners = hull(&flat, false);
    let is_corner = |&&id: &&usize| corners.contains(&axis.shadow_of(points[id]));
    ids.iter().filter(is_corner).copied().collect()
}

fn spanning(points: &[Point3], ids: &[usize]) -> [Point3; 3] {
    let [a, b] = [points[ids[0]], points[ids[1]]];
    let c = ids
        .iter()
        .map(|&id| points[id])
        .find(|&c| !Exact.collinear3(a, b, c));
    [a, b, c.expect("three points that are not collinear")]
}

/// The extreme points of distinct points that span space.
pub(crate) fn extreme3(points: &[Point3]) -> Vec<Point3> {
    let ids: BTreeSet<usize> = facets(points).into_iter().flatten().collect();
    ids.into_iter().map(|id| points[id]).collect()
}

/// The facets as the bits of the coordinates of their corners.
pub(crate) fn corners_of_facets(points: &[Point3]) -> Vec<BTreeSet<[u64; 3]>> {
    let bits = |facet: BTreeSet<usize>| {
        facet
            .into_iter()
            .map(|id| points[id].map(f64::to_bits))
            .collect()
    };
    facets(points).into_iter().map(bits).collect()
}
