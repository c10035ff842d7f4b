//! The point furthest outside a facet.
//!
//! Heights over the plane are compared exactly. Of equally high points one at a corner of their hull is taken, the
//! lexicographically largest, so that the choice depends on the coordinates alone.

use geometry_core::{Kernel3, Point3};
use std::cmp::Ordering;

/// The highest over the plane of the points `ids`, as indices of `points`; of several the lexicographically largest,
/// and of its copies the smallest index.
#[inline]
pub(crate) fn furthest<K: Kernel3>(
    points: &[Point3],
    kernel: &K,
    plane: [Point3; 3],
    ids: impl IntoIterator<Item = u32>,
) -> Option<u32> {
    ids.into_iter().reduce(|best, id| {
        let [p, q] = [id, best].map(|id| points[id as usize]);
        let height = kernel.compare_height(plane, p, q);
        if height.is_gt() || (height.is_eq() && is_preferred(kernel, (p, id), (q, best))) {
            id
        } else {
            best
        }
    })
}

/// Whether the first point is preferred to the second, which is as high.
#[cold]
fn is_preferred<K: Kernel3>(kernel: &K, (p, id): (Point3, u32), (q, best): (Point3, u32)) -> bool {
    match kernel.lexicographic3(p, q) {
        Ordering::Greater => true,
        Ordering::Less => false,
        Ordering::Equal => id < best,
    }
}
