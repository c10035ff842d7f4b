//! The same hull on several processors.
//!
//! The sample is taken, and the discards are made, in shares; the hull of the points left is found by [`halves`](super::halves).
//! The map of the sample alone, a tenth of the work, is one thread's.
//!
//! The hull is unique, and so is how it is told, so the result does not depend on the number of threads.

use super::directions::DirectionMap;
use super::discard::discard_in_shares;
use super::halves::{Forks, hull_by_halves};
use super::left::Left;
use super::{FEW, map_of, map_of_left, sample_size, unseen};
use geometry_core::{Hull3, HullError, Kernel3, Point3, Silent};
use rayon::prelude::*;

/// Where the method on several processors departs from the sequential one.
pub const PARALLEL_DEPARTURES: &[&str] = &[
    "the discards are made by as many threads as there are, and the points left divided among them by planes; the hulls of \
     the parts are joined at the end",
    "steps are reported, and questions counted, by the sequential method",
    "otherwise as fast-3d",
];

/// [`fast_3d_unseen`](super::fast_3d_unseen) on all threads of the current Rayon pool: the same value, whatever their number.
///
/// # Errors
///
/// As [`fast_3d_unseen`](super::fast_3d_unseen).
///
/// # Cost
///
/// That of [`fast_3d_unseen`](super::fast_3d_unseen), divided by the number of threads but for the map of the sample and the
/// joining of parts.
///
/// ```
/// use geometry_core::Exact;
///
/// let lattice: Vec<[f64; 3]> = (0..8000).map(|i| [i % 20, i / 20 % 20, i / 400].map(f64::from)).collect();
/// let hull = quickhull::fast_3d_parallel(&lattice, &Exact)?;
/// assert_eq!(hull.vertices(), [0, 19, 380, 399, 7600, 7619, 7980, 7999]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_3d_parallel<K: Kernel3 + Sync>(
    points: &[Point3],
    kernel: &K,
) -> Result<Hull3, HullError> {
    unseen(points, kernel, || {
        let Some(map) = map_of_sample(points, kernel)? else {
            return Ok(None);
        };
        let parts = discard_in_shares(points, &map);
        hull_by_halves(parts, Forks::for_all_threads(), kernel).map(Some)
    })
}

/// As the sequential one; the sample is taken, and thinned, in shares.
fn map_of_sample<K: Kernel3>(
    points: &[Point3],
    kernel: &K,
) -> Result<Option<DirectionMap>, HullError> {
    let count = points.len();
    if count < FEW {
        return Ok(None);
    }
    let places = Left::places_of_sample(count, sample_size(count));
    let taken = places.par_iter().map(|&place| points[place as usize]);
    let sample = Left {
        points: taken.collect(),
        ids: places,
    };
    if sample.ids.len() < FEW {
        return map_of(sample, count, kernel, &mut Silent);
    }
    let few = sample.sample(sample_size(sample.ids.len()));
    let thinned = map_of(few, sample.ids.len(), kernel, &mut Silent)?.map(|map| {
        let parts = discard_in_shares(&sample.points, &map);
        sample.those_of(Left::joined(parts))
    });
    let left = thinned.as_ref().unwrap_or(&sample);
    map_of_left(&sample, left, count, kernel, &mut Silent)
}
