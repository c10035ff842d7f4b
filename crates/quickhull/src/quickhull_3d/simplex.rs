//! The first simplex: four extreme points far apart, found with exact questions only.
//!
//! 1. a and b have the extreme x (lexicographically).
//! 2. From the plane through them and any point off their line, d is the furthest point.
//! 3. From the plane abd, c is the furthest, on a side where there is any.
//!
//! Each is an extreme point of the set, up to ties, and no four of them are coplanar: a point off the plane is known
//! from the affine basis, and the furthest is further.

use crate::furthest::furthest;
use geometry_core::{Kernel3, Points};
use std::cmp::Ordering;

/// Four points that span space, positively oriented, better spread than the four of `basis`, which are such.
pub(super) fn spread<K: Kernel3>(points: Points<'_, 3>, kernel: &K, basis: [u32; 4]) -> [u32; 4] {
    // The first of an affine basis is the lexicographically smallest, and its second or third the largest.
    let [a, b, c, d] = basis;
    let [b, c] = match kernel.lexicographic3(points[b], points[c]) {
        Ordering::Less => [c, b],
        _ => [b, c],
    };
    let d = furthest_on_side_of(points, kernel, [a, b, c], d);
    let c = furthest_on_side_of(points, kernel, [a, b, d], c);
    let orientation = kernel.orient3(points[a], points[b], points[c], points[d]);
    if orientation.is_positive() {
        [a, b, c, d]
    } else {
        [a, c, b, d]
    }
}

/// The point furthest from the plane on the side of `id`, which is not on it.
fn furthest_on_side_of<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    [a, b, c]: [u32; 3],
    id: u32,
) -> u32 {
    let [a, b, c] = [a, b, c].map(|id| points[id]);
    let above = kernel.orient3(a, b, c, points[id]).is_positive();
    let plane = if above { [a, b, c] } else { [a, c, b] };
    furthest(points.as_slice(), kernel, plane, points.ids()).unwrap_or(id)
}
