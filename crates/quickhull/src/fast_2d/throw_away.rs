//! The points that are certainly inside are thrown away, in passes against polygons with more and more corners.
//!
//! 1. Choose regions on a sample. If most of the sample is in none, hardly any point will be: keep all.
//! 2. Pass over all points and keep, side by side in memory, those not certain to lie in a region. If there are few corners,
//!    what an eighth of the points leaves improves the polygon for the others, so that few are kept at any time.
//! 3. Refine the corners by the points kept, and pass over these again, while that pays.

use super::cascade::{self, Cascade, pays};
use super::polygon::{Corners, Polygon};
use super::region::{BLOCK, Kept};
use super::sample::Sample;
use geometry_core::{Observer, Point2};

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
    /// A pass over points, the first of which has the index `first`.
    fn sift(cascade: &Cascade, points: &[Point2], first: u32, kept: &mut Kept, observer: &mut O);

    /// A pass over those kept.
    fn thin(kept: &mut Kept, polygon: &Polygon, observer: &mut O);
}

/// Throws away points that are certainly inside the hull, and puts the others into `kept`, which is empty.
pub(super) fn throw_away<P: Passes<O>, O: Observer>(
    points: &[Point2],
    kept: &mut Kept,
    observer: &mut O,
) -> Left {
    let Some(mut cascade) = Cascade::of(points) else {
        return Left::All;
    };
    let (head, rest) = points.split_at(head(points.len(), &cascade.corners));
    if !head.is_empty() {
        P::sift(&cascade, head, 0, kept, observer);
        let expected = kept.len() * (points.len() / head.len());
        if pays(points.len(), expected, &cascade.corners) {
            improve::<P, O>(&mut cascade, kept, observer);
        }
    }
    P::sift(&cascade, rest, head.len() as u32, kept, observer);
    let (mut before, mut corners) = (points.len(), cascade.corners);
    let mut may_be_too_few = corners.len() < cascade::ENOUGH && points.len() >= MANY;
    while pays(before, kept.len(), &corners) || may_be_too_few {
        may_be_too_few = false;
        before = kept.len();
        let Some((_, refined)) = thin_by_more_corners::<P, O>(&corners, kept, observer) else {
            break;
        };
        corners = refined;
    }
    Left::Kept
}

/// Refines the corners by the points kept, and drops those in their polygon; none if that is out of range.
fn thin_by_more_corners<P: Passes<O>, O: Observer>(
    corners: &Corners,
    kept: &mut Kept,
    observer: &mut O,
) -> Option<(Polygon, Corners)> {
    let corners = corners.refined(few_enough(kept.points()));
    let polygon = Polygon::of(&corners)?;
    P::thin(kept, &polygon, observer);
    Some((polygon, corners))
}

/// Refines the last polygon by the points kept, if that leaves few of them.
fn improve<P: Passes<O>, O: Observer>(cascade: &mut Cascade, kept: &mut Kept, observer: &mut O) {
    let before = kept.len();
    let refined = thin_by_more_corners::<P, O>(&cascade.corners, kept, observer);
    if let Some((polygon, corners)) = refined
        && kept.len() < before - before / 4
    {
        cascade.improve(polygon, corners);
    }
}

/// How many of so many points are looked at before the others: an eighth, if there are many, but few corners, which a part
/// of the points improves at once.
fn head(count: usize, corners: &Corners) -> usize {
    const FROM: usize = 1 << 16;
    const FEW: usize = 16;
    if count < FROM || corners.len() > FEW {
        0
    } else {
        (count / 8).next_multiple_of(BLOCK)
    }
}

/// With fewer points, it does not matter.
const MANY: usize = 512;

/// If there are twice as many, so many points decide about corners: with more of them the polygon hardly grows.
const ENOUGH: usize = 1 << 13;

fn few_enough(points: &[Point2]) -> Sample<'_> {
    if points.len() < 2 * ENOUGH {
        Sample::all(points)
    } else {
        Sample::some(points, ENOUGH)
    }
}
