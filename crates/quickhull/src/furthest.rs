//! The point furthest outside a facet.
//!
//! Heights over the plane are compared exactly. Of equally high points one at a corner of their hull is taken, the
//! lexicographically largest, so that the choice depends on the coordinates alone.

use geometry_core::{Kernel3, Points};
use std::cmp::Ordering;

/// The highest of `ids` over the plane; of several the lexicographically largest, and of its copies the one with
/// the smallest index.
pub(crate) fn furthest<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    plane: [u32; 3],
    ids: impl IntoIterator<Item = u32>,
) -> Option<u32> {
    let plane = plane.map(|id| points[id]);
    ids.into_iter().reduce(|best, id| {
        let height = kernel.compare_height(plane, points[id], points[best]);
        if height.is_gt() || (height.is_eq() && precedes(points, kernel, id, best)) {
            id
        } else {
            best
        }
    })
}

/// Whether `id` is preferred to `best`, which is as high.
#[cold]
fn precedes<K: Kernel3>(points: Points<'_, 3>, kernel: &K, id: u32, best: u32) -> bool {
    match kernel.lexicographic3(points[id], points[best]) {
        Ordering::Greater => true,
        Ordering::Less => false,
        Ordering::Equal => id < best,
    }
}
