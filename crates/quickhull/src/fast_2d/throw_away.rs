//! The points that are certainly inside are thrown away, in passes against polygons with more and more corners.
//!
//! 1. Choose regions on a sample. If most of the sample is in none, hardly any point will be: keep all.
//! 2. Pass over all points and keep, side by side in memory, those not certain to lie in a region.
//! 3. Refine the corners by the points kept, and pass over these again, while that pays.

use super::cascade::{self, Cascade, pays};
use super::polygon::Polygon;
use super::region::Kept;
use geometry_core::{Observer, Point2};
use std::borrow::Cow;

/// What is left of the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Left {
    /// All: nothing was thrown away.
    All,
    /// Those in [`Kept`].
    Kept,
}

/// How passes are made: by one thread, or by several.
pub(super) trait Passes<O> {
    /// The pass over all points.
    fn sift(cascade: &Cascade, points: &[Point2], kept: &mut Kept, observer: &mut O);

    /// A pass over those kept.
    fn thin(kept: &mut Kept, polygon: &Polygon, observer: &mut O);
}

/// Throws away points that are certainly inside the hull, and puts the others into `kept`, which is empty.
pub(super) fn throw_away<P: Passes<O>, O: Observer>(
    points: &[Point2],
    kept: &mut Kept,
    observer: &mut O,
) -> Left {
    let Some(cascade) = Cascade::of(points) else {
        return Left::All;
    };
    P::sift(&cascade, points, kept, observer);
    let (mut before, mut corners) = (points.len(), cascade.corners);
    let mut may_be_too_few = corners.len() < cascade::ENOUGH && points.len() >= MANY;
    while pays(before, kept.len(), &corners) || may_be_too_few {
        may_be_too_few = false;
        corners = corners.refined(&few_enough(kept.points()));
        let Some(polygon) = Polygon::of(&corners) else {
            break;
        };
        before = kept.len();
        P::thin(kept, &polygon, observer);
    }
    Left::Kept
}

/// With fewer points, it does not matter.
const MANY: usize = 512;

/// So many points decide about corners: with more of them the polygon hardly grows.
const ENOUGH: usize = 1 << 13;

/// Fewer than twice [`ENOUGH`] of the points, from all over the slice.
fn few_enough(points: &[Point2]) -> Cow<'_, [Point2]> {
    if points.len() <= 2 * ENOUGH {
        return points.into();
    }
    points
        .iter()
        .copied()
        .step_by(points.len() / ENOUGH)
        .collect()
}
