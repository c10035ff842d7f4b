//! The points that are certainly inside are thrown away, in passes against polygons with more and more corners.
//!
//! 1. The corners of the first polygon are sought in a sample. If most of the sample is not inside, hardly any point
//!    will be: keep all.
//! 2. Pass over all points and keep, side by side in memory, those not certified to lie inside.
//! 3. Seek the corners in twice as many directions among the points kept, and pass again, while that pays.

use super::extremes::MOST_POINTS;
use super::polygon::{Directions, Polygon};
use geometry_core::{Observer, Point2, Step};
use smallvec::SmallVec;

/// Up to so many points are looked at for the first corners: enough that a better polygon would save less time than
/// finding it takes.
const SAMPLE: usize = 1 << 14;

/// With fewer points, a pass takes longer than sorting those that it throws away.
const FEW: usize = 24;

const BLOCK: usize = 64;

/// Up to so many points are kept without allocation.
pub(super) const INLINE: usize = 128;

/// The points kept, with their indices in the caller's slice, in its order.
#[derive(Default)]
pub(super) struct Kept {
    pub(super) points: SmallVec<[Point2; INLINE]>,
    pub(super) ids: SmallVec<[u32; INLINE]>,
}

/// What is left of the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Left {
    /// All: nothing was thrown away.
    All,
    /// Those in [`Kept`].
    Kept,
}

/// Throws away points that are certainly inside the hull, and puts the others into `kept`, which is empty.
pub(super) fn throw_away<O: Observer>(
    points: &[Point2],
    kept: &mut Kept,
    observer: &mut O,
) -> Left {
    let Some(polygon) = first_polygon(points) else {
        return Left::All;
    };
    kept.fill(points, &polygon);
    report(0..points.len() as u32, &kept.ids, observer);
    let (mut directions, mut before) = (Directions::Eight, points.len());
    while let Some(more) = directions.doubled()
        && pays(before, kept.points.len(), more)
    {
        let sample = sampled(&kept.points, MOST_POINTS);
        let Some(polygon) = Polygon::around(&sample, more) else {
            break;
        };
        directions = more;
        before = kept.points.len();
        let ids = if O::ACTIVE {
            kept.ids.to_vec()
        } else {
            Vec::new()
        };
        kept.thin(&polygon);
        report(ids, &kept.ids, observer);
    }
    Left::Kept
}

/// Whether one more pass pays, after one that kept `after` of `before` points.
fn pays(before: usize, after: usize, directions: Directions) -> bool {
    after > 3 * directions.count() && after < before - before / 4
}

/// The polygon for the first pass, unless there are few points or most of a sample is not inside.
fn first_polygon(points: &[Point2]) -> Option<Polygon> {
    if points.len() < FEW {
        return None;
    }
    let sample = sampled(points, SAMPLE);
    let polygon = Polygon::around(&sample, Directions::Eight)?;
    if sample.len() < points.len() {
        let mut kept = Kept::default();
        kept.fill(&sample, &polygon);
        if kept.points.len() > sample.len() / 2 {
            return None;
        }
    }
    Some(polygon)
}

/// At most `most` of the points, from all over the slice.
fn sampled(points: &[Point2], most: usize) -> std::borrow::Cow<'_, [Point2]> {
    if points.len() <= most {
        return points.into();
    }
    let step = points.len().div_ceil(most);
    points.iter().copied().step_by(step).collect()
}

fn report<O: Observer>(looked_at: impl IntoIterator<Item = u32>, kept: &[u32], observer: &mut O) {
    if !O::ACTIVE {
        return;
    }
    let mut kept = kept.iter().peekable();
    for id in looked_at {
        observer.step(|| Step::Visit(id));
        if kept.next_if_eq(&&id).is_none() {
            observer.step(|| Step::Discard(id));
        }
    }
}

impl Kept {
    /// Adds those of the points that are not certified to lie inside the polygon.
    fn fill(&mut self, points: &[Point2], polygon: &Polygon) {
        pulp::Arch::new().dispatch(Fill {
            kept: self,
            points,
            polygon,
        });
    }

    /// Keeps those of the kept that are not certified to lie inside the polygon.
    fn thin(&mut self, polygon: &Polygon) {
        pulp::Arch::new().dispatch(Thin {
            kept: self,
            polygon,
        });
    }
}

struct Fill<'a> {
    kept: &'a mut Kept,
    points: &'a [Point2],
    polygon: &'a Polygon,
}

impl pulp::NullaryFnOnce for Fill<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let (blocks, rest) = self.points.as_chunks::<BLOCK>();
        let mut first = 0;
        for block in blocks {
            self.kept.add(block, first, self.polygon.not_inside(block));
            first += BLOCK as u32;
        }
        if !rest.is_empty() {
            let block = filled_up(rest);
            let bits = self.polygon.not_inside(&block) & !(u64::MAX << rest.len());
            self.kept.add(&block, first, bits);
        }
    }
}

impl Kept {
    /// Adds the points of the block whose bits are set; the block's first point has the index `first`.
    #[inline(always)]
    fn add(&mut self, block: &[Point2; BLOCK], first: u32, mut bits: u64) {
        let (mut points, mut ids) = ([[0.0; 2]; BLOCK], [0; BLOCK]);
        let mut count = 0;
        while bits != 0 {
            let place = bits.trailing_zeros();
            bits &= bits - 1;
            points[count] = block[place as usize];
            ids[count] = first + place;
            count += 1;
        }
        self.points.extend_from_slice(&points[..count]);
        self.ids.extend_from_slice(&ids[..count]);
    }
}

struct Thin<'a> {
    kept: &'a mut Kept,
    polygon: &'a Polygon,
}

impl pulp::NullaryFnOnce for Thin<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let (points, ids) = (&mut self.kept.points[..], &mut self.kept.ids[..]);
        let mut count = 0;
        for start in (0..points.len()).step_by(BLOCK) {
            let len = BLOCK.min(points.len() - start);
            let block = filled_up(&points[start..start + len]);
            let mut bits = self.polygon.not_inside(&block) & (u64::MAX >> (BLOCK - len));
            // What is written lies before what is still to be read.
            while bits != 0 {
                let place = bits.trailing_zeros() as usize;
                bits &= bits - 1;
                points[count] = block[place];
                ids[count] = ids[start + place];
                count += 1;
            }
        }
        self.kept.points.truncate(count);
        self.kept.ids.truncate(count);
    }
}

/// A block that begins with the points, which are at least one and at most [`BLOCK`].
#[inline(always)]
fn filled_up(points: &[Point2]) -> [Point2; BLOCK] {
    let mut block = [points[0]; BLOCK];
    block[..points.len()].copy_from_slice(points);
    block
}
