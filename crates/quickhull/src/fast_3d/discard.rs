//! The passes that discard points that are certainly inside.

use super::core::Core;
use super::directions::{DirectionMap, Scratch};
use super::left::Left;
use crate::blocks::{BLOCK, filled_up, first_bits, places};
use geometry_core::{Observer, Point3, Step};
use rayon::prelude::*;

/// The most points that a thread takes at a time.
const SHARE: usize = 1 << 16;

/// So many shares a thread, if these are smaller: some take longer than others.
const SHARES: usize = 4;

/// The points, numbered from `first`, that the map does not find inside.
pub(super) fn discard<O: Observer>(
    points: &[Point3],
    first: u32,
    map: &DirectionMap,
    observer: &mut O,
) -> Left {
    let mut left = Left::default();
    pass(map, points, |block, start, bits| {
        let id = |place: usize| first + (start + place) as u32;
        left.points.extend(places(bits).map(|place| block[place]));
        left.ids.extend(places(bits).map(id));
        if O::ACTIVE {
            for place in 0..BLOCK.min(points.len() - start) {
                observer.step(|| Step::Visit(id(place)));
                if bits >> place & 1 == 0 {
                    observer.step(|| Step::Discard(id(place)));
                }
            }
        }
    });
    left
}

/// [`discard`] on all threads of the current Rayon pool: the same points, in parts to be put one behind the other.
pub(super) fn discard_in_shares(points: &[Point3], map: &DirectionMap) -> Vec<Left> {
    let share = points.len().div_ceil(SHARES * rayon::current_num_threads());
    let len = share.next_multiple_of(BLOCK).clamp(BLOCK, SHARE);
    let shares = points.par_chunks(len).enumerate();
    let of_share = |(number, share)| {
        let first = (number * len) as u32;
        discard(share, first, map, &mut geometry_core::Silent)
    };
    shares.map(of_share).collect()
}

/// How many of the points are certainly inside.
pub(super) fn count_inside<T: Test>(test: &T, points: &[Point3]) -> usize {
    let mut outside = 0;
    pass(test, points, |_, _, bits| {
        outside += bits.count_ones() as usize
    });
    points.len() - outside
}

/// Tells which points are certainly inside the hull, and not extreme.
pub(super) trait Test {
    /// The points of a block of which that is not certain, a bit for each.
    fn not_inside(&self, block: &[Point3; BLOCK], scratch: &mut Scratch) -> u64;
}

impl Test for Core {
    #[inline(always)]
    fn not_inside(&self, block: &[Point3; BLOCK], _: &mut Scratch) -> u64 {
        self.not_held(block)
    }
}

impl Test for DirectionMap {
    #[inline(always)]
    fn not_inside(&self, block: &[Point3; BLOCK], scratch: &mut Scratch) -> u64 {
        self.not_inside(block, scratch)
    }
}

/// Calls `take` with each block of the points, the place of its first point, and the bits of those not certainly inside.
fn pass<T: Test>(test: &T, points: &[Point3], take: impl FnMut(&[Point3; BLOCK], usize, u64)) {
    pulp::Arch::new().dispatch(Pass { test, points, take });
}

struct Pass<'a, T, F> {
    test: &'a T,
    points: &'a [Point3],
    take: F,
}

impl<T: Test, F: FnMut(&[Point3; BLOCK], usize, u64)> pulp::NullaryFnOnce for Pass<'_, T, F> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        let (blocks, rest) = self.points.as_chunks::<BLOCK>();
        let last = (!rest.is_empty()).then(|| filled_up(rest));
        let mut scratch = Scratch::default();
        for (number, block) in blocks.iter().chain(&last).enumerate() {
            let start = number * BLOCK;
            let len = BLOCK.min(self.points.len() - start);
            let bits = self.test.not_inside(block, &mut scratch) & first_bits(len);
            (self.take)(block, start, bits);
        }
    }
}
