//! The initial tetrahedron of section 3.3.2.
//!
//! Distances between points, and from a line, are rounded here: nothing rests on them but which four points the hull
//! grows from. That the four span space is asked of the kernel; where rounding chose badly, a point of the
//! affine basis steps in.

use crate::furthest::furthest;
use geometry_core::{Kernel3, Point3, Points};

/// Four points that span space, positively oriented; `basis` are four such.
pub(super) fn tetrahedron<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    basis: [u32; 4],
) -> [u32; 4] {
    let [a, b] = furthest_apart(points, extremes(points, kernel));
    let on_line = |id: u32| kernel.collinear3(points[a], points[b], points[id]);
    let off_line = Some(furthest_from_line(points, [a, b])).filter(|&id| !on_line(id));
    // Of four points that span space, two at least are off any line, and one off any plane.
    let c = off_line.unwrap_or_else(|| {
        basis
            .into_iter()
            .find(|&id| !on_line(id))
            .unwrap_or(basis[2])
    });
    let [p, q, r] = [a, b, c].map(|id| points[id]);
    let most = |plane| furthest(points.as_slice(), kernel, plane, points.ids()).unwrap_or(basis[3]);
    let highest = most([p, q, r]);
    if kernel.orient3(p, q, r, points[highest]).is_positive() {
        [a, b, c, highest]
    } else {
        [a, c, b, most([p, r, q])]
    }
}

/// The smallest and the largest point along each axis, ties broken by the axes after it.
fn extremes<K: Kernel3>(points: Points<'_, 3>, kernel: &K) -> [u32; 6] {
    let turned =
        |id: u32, axis: usize| -> Point3 { std::array::from_fn(|i| points[id][(axis + i) % 3]) };
    let mut extremes = [0; 6];
    for axis in 0..3 {
        for id in points.ids().skip(1) {
            let place = turned(id, axis);
            if kernel
                .lexicographic3(place, turned(extremes[2 * axis], axis))
                .is_lt()
            {
                extremes[2 * axis] = id;
            }
            if kernel
                .lexicographic3(place, turned(extremes[2 * axis + 1], axis))
                .is_gt()
            {
                extremes[2 * axis + 1] = id;
            }
        }
    }
    extremes
}

/// The two with the largest distance, rounded. Distinct, as the distance of distinct points does not round to zero.
fn furthest_apart(points: Points<'_, 3>, ids: [u32; 6]) -> [u32; 2] {
    let mut best = ([ids[0], ids[1]], 0.0);
    for (i, &p) in ids.iter().enumerate() {
        for &q in &ids[i + 1..] {
            let [x, y, z] = minus(points[p], points[q]);
            let distance = x.hypot(y).hypot(z);
            if distance > best.1 {
                best = ([p, q], distance);
            }
        }
    }
    best.0
}

/// The point with the largest distance from the line, rounded; the first of several.
fn furthest_from_line(points: Points<'_, 3>, [a, b]: [u32; 2]) -> u32 {
    let along = minus(points[b], points[a]);
    let mut best = (a, 0.0);
    for id in points.ids() {
        let to = minus(points[id], points[a]);
        let [x, y, z]: Point3 = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            along[j] * to[k] - along[k] * to[j]
        });
        // The square of the distance, times that of the line's length.
        let area = x * x + y * y + z * z;
        if area > best.1 {
            best = (id, area);
        }
    }
    best.0
}

fn minus(p: Point3, q: Point3) -> Point3 {
    std::array::from_fn(|i| p[i] - q[i])
}
