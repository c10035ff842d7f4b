//! The distinct points in lexicographic order, copied together so that neighbours share cache lines.

use geometry_core::{Point2, Points};

/// A point, and what else there is to know of it in the inner loops.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Entry {
    /// Its coordinates.
    pub(super) point: Point2,
    /// Its rank in the lexicographic order of the distinct points.
    pub(super) rank: u32,
    /// The smallest of its indices in the caller's slice.
    pub(super) id: u32,
}

/// The distinct points by x, then y.
#[derive(Default)]
pub(super) struct Sorted {
    /// One entry for each distinct point, in order.
    pub(super) entries: Vec<Entry>,
    /// Each further index of a repeated point, with the smallest.
    pub(super) copies: Vec<[u32; 2]>,
}

impl Sorted {
    /// O(n log n) time; 16n bytes that are freed before it returns.
    pub(super) fn new(points: Points<'_, 2>) -> Self {
        let mut keys: Vec<u128> = points
            .ids()
            .map(|id| u128::from(ordered_bits(points[id][0])) << 64 | u128::from(id))
            .collect();
        keys.sort_unstable();
        sort_equal_abscissae(points, &mut keys);
        let mut sorted = Sorted {
            entries: Vec::with_capacity(keys.len()),
            copies: Vec::new(),
        };
        for key in keys {
            sorted.push(key as u32, points[key as u32]);
        }
        sorted
    }

    fn push(&mut self, id: u32, point: Point2) {
        match self.entries.last() {
            Some(last) if last.point == point => self.copies.push([id, last.id]),
            _ => {
                let rank = self.entries.len() as u32;
                self.entries.push(Entry { point, rank, id });
            }
        }
    }
}

/// Puts each run of keys of one x in order of y, then of index.
fn sort_equal_abscissae(points: Points<'_, 2>, keys: &mut [u128]) {
    for run in keys.chunk_by_mut(|a, b| a >> 64 == b >> 64) {
        if run.len() > 1 {
            run.sort_unstable_by_key(|&key| (ordered_bits(points[key as u32][1]), key as u32));
        }
    }
}

/// An integer that compares as `x` does among finite numbers, the two zeros equal.
#[inline(always)]
fn ordered_bits(x: f64) -> u64 {
    let bits = (x + 0.0).to_bits();
    let flips = (bits as i64 >> 63) as u64 | 1 << 63;
    bits ^ flips
}
