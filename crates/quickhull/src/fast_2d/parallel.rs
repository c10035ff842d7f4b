//! The pass over all points on several processors.
//!
//! The points are cut into parts; what each part keeps is put together in order. Whether a point is dropped is not a matter of
//! its part, so the result, and which points are dropped, do not depend on how many threads there are, and are those of
//! the sequential method.

use super::cascade::Cascade;
use super::polygon::Polygon;
use super::region::{BLOCK, Kept};
use super::throw_away::Passes;
use super::{candidates, hull_of, hull_of_unseen};
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Point2, Points, Silent};
use rayon::prelude::*;

/// Where the parallel method departs from the sequential one.
pub const PARALLEL_DEPARTURES: &[&str] = &[
    "the passes over points are made by as many threads as there are; the corners are found, and what is left is sorted \
     and scanned, by one",
    "steps are reported, and questions counted, by the sequential method, whose steps and questions are the same",
    "otherwise as fast-2d",
];

/// So many parts a thread, as one may be held up. Each begins without room for what it keeps, so more of them take longer.
const PARTS: usize = 4;

/// Fewer points are one part, or fewer of those kept, which are tested against many edges.
const LEAST: usize = 1 << 17;
const LEAST_KEPT: usize = 1 << 13;

/// The result of [`fast_2d`](super::fast_2d()), found on several processors.
///
/// Runs on the current rayon thread pool.
///
/// # Errors
///
/// Those of [`fast_2d`](super::fast_2d()).
///
/// # Cost
///
/// The work of [`fast_2d`](super::fast_2d()). All of it but the passes is sequential, so a set whose points are mostly
/// extreme gains nothing.
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Exact, Points};
/// let points = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
/// let hull = quickhull::fast_2d_parallel(Points::new(&points)?, Boundary::Extreme, &Exact)?;
/// assert_eq!(hull.vertices(), [0, 1, 3]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_2d_parallel<K: Kernel2>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
) -> Result<Hull2, HullError> {
    let mut kept = Kept::default();
    let candidates = candidates::<InParts, _>(points.as_slice(), &mut kept, &mut Silent);
    Ok(hull_of(candidates, boundary, kernel, &mut Silent))
}

/// [`convex_hull`](super::convex_hull) on several processors: [`fast_2d_parallel`] of points that nobody has looked at
/// yet.
///
/// # Errors
///
/// Those of [`Points::new`].
///
/// # Cost
///
/// That of [`fast_2d_parallel`].
///
/// # Example
///
/// ```
/// use geometry_core::Boundary;
/// let points = [[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
/// assert_eq!(quickhull::convex_hull_parallel(&points, Boundary::Extreme)?.len(), 3);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn convex_hull_parallel(points: &[Point2], boundary: Boundary) -> Result<Hull2, HullError> {
    hull_of_unseen::<InParts>(points, boundary)
}

/// The passes of several threads.
struct InParts;

impl Passes<Silent> for InParts {
    fn sift(cascade: &Cascade, points: &[Point2], first: u32, kept: &mut Kept, _: &mut Silent) {
        let len = part(points.len(), LEAST);
        if points.len() <= len {
            return cascade.sift(points, first, kept, &mut Silent);
        }
        let sifted = |(number, part): (usize, &[Point2])| {
            let mut kept = Kept::default();
            cascade.sift(part, first + (number * len) as u32, &mut kept, &mut Silent);
            kept
        };
        let parts: Vec<Kept> = points.par_chunks(len).enumerate().map(sifted).collect();
        for part in &parts {
            kept.append(part);
        }
    }

    fn thin(kept: &mut Kept, polygon: &Polygon, _: &mut Silent) {
        let len = part(kept.len(), LEAST_KEPT);
        if kept.len() <= len {
            kept.thin(polygon);
        } else {
            kept.thin_in_parts(polygon, len);
        }
    }
}

/// The length of a part of `count` points, if parts are not to be shorter than `least`.
fn part(count: usize, least: usize) -> usize {
    let share = count.div_ceil(PARTS * rayon::current_num_threads());
    share.next_multiple_of(BLOCK).max(least)
}
