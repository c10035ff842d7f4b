//! A part of the plane inside the hull, and the passes that keep the points outside it.
//!
//! The passes are plain loops over [`blocks`](crate::blocks).

pub(super) use crate::blocks::BLOCK;
use crate::blocks::{filled_up, first_bits};
use geometry_core::Point2;
use rayon::prelude::*;
use smallvec::SmallVec;

/// Up to so many points are kept without allocation.
pub(super) const INLINE: usize = 128;

/// A part of the plane in which every point is an inner point of the hull of the input.
pub(super) trait Region {
    /// A number for each point: greater than the [`bound`](Self::bound) only if the point lies in the region for certain.
    /// Where a coordinate is not finite it is not, or NaN.
    ///
    /// Written as plain loops over the whole block: the compiler makes good vectors of these, and bad ones of loops over
    /// parts of it.
    fn measure(&self, block: &Block) -> [f64; BLOCK];

    /// What a measure must exceed.
    fn bound(&self) -> f64;

    /// Bit i for point i not certain to lie in the region.
    #[inline(always)]
    fn not_inside(&self, points: &[Point2; BLOCK]) -> u64 {
        let bound = self.bound();
        let mut inside = 0;
        for (place, measure) in self.measure(&Block::of(points)).into_iter().enumerate() {
            inside |= u64::from(measure > bound) << place;
        }
        !inside
    }
}

/// The coordinates of the points of a block, side by side.
pub(super) struct Block {
    pub(super) x: [f64; BLOCK],
    pub(super) y: [f64; BLOCK],
}

impl Block {
    #[inline(always)]
    fn of(points: &[Point2; BLOCK]) -> Self {
        let (mut x, mut y) = ([0.0; BLOCK], [0.0; BLOCK]);
        for (place, point) in points.iter().enumerate() {
            x[place] = point[0];
            y[place] = point[1];
        }
        Self { x, y }
    }
}

/// The lesser number; the second if one is NaN.
#[inline(always)]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The points kept, with their indices in the caller's slice, in its order.
#[derive(Default)]
pub(super) struct Kept {
    /// How many there are; what is stored behind them is of no meaning.
    len: usize,
    points: SmallVec<[Point2; INLINE]>,
    ids: SmallVec<[u32; INLINE]>,
}

impl Kept {
    pub(super) fn points(&self) -> &[Point2] {
        &self.points[..self.len]
    }

    pub(super) fn ids(&self) -> &[u32] {
        &self.ids[..self.len]
    }

    /// Adds those of the points that are not certain to lie in the region; the first point's index is `first`.
    pub(super) fn fill<R: Region>(&mut self, points: &[Point2], first: u32, region: &R) {
        pulp::Arch::new().dispatch(Fill {
            kept: self,
            points,
            first,
            region,
        });
    }

    /// Keeps those that are not certain to lie in the region.
    pub(super) fn thin<R: Region>(&mut self, region: &R) {
        let (points, ids) = (&mut self.points[..self.len], &mut self.ids[..self.len]);
        self.len = thinned(points, ids, region);
    }

    /// [`thin`](Self::thin), on all threads of the current Rayon pool, which take `part` points at a time.
    pub(super) fn thin_in_parts<R: Region + Sync>(&mut self, region: &R, part: usize) {
        let (points, ids) = (&mut self.points[..self.len], &mut self.ids[..self.len]);
        let parts = points.par_chunks_mut(part).zip(ids.par_chunks_mut(part));
        let counts = parts.map(|(points, ids)| thinned(points, ids, region));
        let counts: Vec<usize> = counts.collect();
        self.len = 0;
        for (start, count) in (0..).step_by(part).zip(counts) {
            points.copy_within(start..start + count, self.len);
            ids.copy_within(start..start + count, self.len);
            self.len += count;
        }
    }

    /// Adds what another kept.
    pub(super) fn append(&mut self, other: &Kept) {
        self.points.truncate(self.len);
        self.ids.truncate(self.len);
        self.points.extend_from_slice(other.points());
        self.ids.extend_from_slice(other.ids());
        self.len = self.points.len();
    }

    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// Adds the points of the block whose bits are set; the block's first point has the index `first`.
    #[inline(always)]
    fn add(&mut self, block: &[Point2; BLOCK], first: u32, mut bits: u64) {
        let (before, after) = (self.len, self.len + bits.count_ones() as usize);
        if after > self.points.len() {
            self.make_room(after);
        }
        self.len = after;
        let new = self.points[before..after]
            .iter_mut()
            .zip(&mut self.ids[before..after]);
        for (point, id) in new {
            let place = bits.trailing_zeros() % BLOCK as u32;
            bits &= bits.wrapping_sub(1);
            *point = block[place as usize];
            *id = first + place;
        }
    }

    /// Room for so many, and if there are many, for more.
    #[inline(never)]
    fn make_room(&mut self, len: usize) {
        let room = if len > INLINE { len + len / 2 } else { len };
        self.points.resize(room, [0.0; 2]);
        self.ids.resize(room, 0);
    }
}

struct Fill<'a, R> {
    kept: &'a mut Kept,
    points: &'a [Point2],
    first: u32,
    region: &'a R,
}

impl<R: Region> pulp::NullaryFnOnce for Fill<'_, R> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self {
            kept,
            points,
            mut first,
            region,
        } = self;
        let (blocks, rest) = points.as_chunks::<BLOCK>();
        for block in blocks {
            let bits = region.not_inside(block);
            if bits != 0 {
                kept.add(block, first, bits);
            }
            first += BLOCK as u32;
        }
        if !rest.is_empty() {
            let block = filled_up(rest);
            let bits = region.not_inside(&block) & first_bits(rest.len());
            kept.add(&block, first, bits);
        }
    }
}

/// Moves those that are not certain to lie in the region to the front, with their indices, and returns how many they are.
fn thinned<R: Region>(points: &mut [Point2], ids: &mut [u32], region: &R) -> usize {
    pulp::Arch::new().dispatch(Thin {
        points,
        ids,
        region,
    })
}

struct Thin<'a, R> {
    points: &'a mut [Point2],
    ids: &'a mut [u32],
    region: &'a R,
}

impl<R: Region> pulp::NullaryFnOnce for Thin<'_, R> {
    type Output = usize;

    #[inline(always)]
    fn call(self) -> usize {
        let Self {
            points,
            ids,
            region,
        } = self;
        let mut count = 0;
        for start in (0..points.len()).step_by(BLOCK) {
            let len = BLOCK.min(points.len() - start);
            let block = filled_up(&points[start..start + len]);
            let mut bits = region.not_inside(&block) & first_bits(len);
            // What is written lies before what is still to be read.
            while bits != 0 {
                let place = bits.trailing_zeros() as usize;
                bits &= bits - 1;
                points[count] = block[place];
                ids[count] = ids[start + place];
                count += 1;
            }
        }
        count
    }
}
