//! The order of insertion: biased at random into rounds, along Hilbert's curve within each.
//!
//! N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", *Proceedings of the 19th Annual Symposium on
//! Computational Geometry*, 211–219, 2003. The last round has three of four points, chosen at random, the one before it
//! three of four of the others, and so on down to a few dozen. Within a round any order will do for the bound, and one
//! that stays in place keeps the walk short and the surface in the cache.
//!
//! A round, a place on the curve and an index are one word, and the words are sorted. Where many points fall into one
//! cell, as when a few lie far away, the points of the cell are sorted again in a grid of their own.

use super::hilbert::Grid;
use super::line::Line;
use geometry_core::{Point3, Points};

/// The fewest points of all rounds but the last to come; below it there is one round.
const FIRST_ROUND: u32 = 32;
/// More points than this in one cell are sorted again.
const CROWD: usize = 8;
const ROUND_BITS: u32 = 4;
const POINTS_A_CELL: usize = 16;
const FINEST: u32 = 10;

/// The indices of all points in the order of insertion: `first`, then the others by rounds; `None` if `first` names a point
/// twice.
pub(super) fn order(points: Points<'_, 3>, first: [u32; 4]) -> Option<Vec<u32>> {
    let mut order = Vec::with_capacity(points.len() + first.len());
    order.extend(first);
    order.extend(points.ids());
    // From the greatest, so that an index to be removed is still in its place.
    let mut removed = first;
    removed.sort_unstable();
    if removed.windows(2).any(|pair| pair[0] == pair[1]) {
        return None;
    }
    for id in removed.into_iter().rev() {
        order.swap_remove(first.len() + id as usize);
    }
    let rounds = (points.len() as u32 / FIRST_ROUND).max(1).ilog(4);
    let mut sorter = Sorter {
        points,
        index_bits: points.len().max(2).ilog2() + 1,
        keys: Vec::with_capacity(points.len()),
        spare: Vec::new(),
        crowds: Vec::new(),
    };
    let first = first.len();
    sorter.sort(&mut order[first..], first, |id| {
        u64::from(rounds - quarters(id).min(rounds))
    });
    while let Some((start, end)) = sorter.crowds.pop() {
        sorter.sort(&mut order[start..end], start, |_| 0);
    }
    Some(order)
}

/// How many rounds from the last the point is in, were there no first: 0 with probability 3/4, 1 with 3/16, ...
///
/// The index goes through the finaliser of D. Lea's and G. Steele's SplitMix64, a fixed permutation of 64-bit words, so
/// that a row of points is in rounds that look random.
fn quarters(id: u32) -> u32 {
    let mut x = (u64::from(id) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (x ^ (x >> 31)).trailing_zeros() / 2
}

/// Sorts words, of which those with the same `bits` above the `skipped` lowest are in order already.
///
/// From the lowest digit to the highest; a comparison sort is faster for few.
fn radix_sort(words: &mut Vec<u64>, spare: &mut Vec<u64>, skipped: u32, bits: u32) {
    if words.len() < FEW {
        return words.sort_unstable();
    }
    spare.resize(words.len(), 0);
    for shift in (skipped..skipped + bits).step_by(DIGIT as usize) {
        let digit = |word: u64| (word >> shift) as usize % (1 << DIGIT);
        let mut places = [0_u32; 1 << DIGIT];
        for &word in &*words {
            places[digit(word)] += 1;
        }
        let mut total = 0;
        for place in &mut places {
            total += std::mem::replace(place, total);
        }
        for &word in &*words {
            let place = &mut places[digit(word)];
            spare[*place as usize] = word;
            *place += 1;
        }
        std::mem::swap(words, spare);
    }
}

const DIGIT: u32 = 10;
const FEW: usize = 1 << (DIGIT + 2);

struct Sorter<'a> {
    points: Points<'a, 3>,
    index_bits: u32,
    keys: Vec<u64>,
    spare: Vec<u64>,
    /// Where in the order there are too many points of one cell: start and end.
    crowds: Vec<(usize, usize)>,
}

impl Sorter<'_> {
    /// Sorts `ids`, which begin at `offset` of the whole order, by round and by place; notes the crowds.
    ///
    /// A crowd of all of them, which no grid can tell apart, is left as it is.
    fn sort(&mut self, ids: &mut [u32], offset: usize, round: impl Fn(u32) -> u64) {
        // A surface meets about as many cells as 4 to the power of the levels: a few points for each. A radix sort takes
        // longer for more; where points are compared, more cost nothing, and help if they lie along a curve.
        let wanted = if ids.len() < FEW {
            FINEST
        } else {
            (ids.len() / POINTS_A_CELL + 1).ilog(4) + 1
        };
        let room = (u64::BITS - ROUND_BITS - self.index_bits) / 3;
        let levels = wanted.min(room - room % 2);
        let grid = Grid::over(ids.iter().map(|&id| self.points[id]), levels);
        let line = Line::along(
            ids.len(),
            |i| self.points[ids[i]],
            grid,
            grid.bits().min(30),
        );
        match line {
            Some(line) => self.sort_keys(ids, round, line.bits(), |p| line.place(p)),
            None => self.sort_keys(ids, round, grid.bits(), |p| grid.place(p)),
        }
        let mask = (1 << self.index_bits) - 1;
        for (id, key) in ids.iter_mut().zip(&self.keys) {
            *id = (key & mask) as u32;
        }
        let mut start = 0;
        for cell in self
            .keys
            .chunk_by(|a, b| a >> self.index_bits == b >> self.index_bits)
        {
            let end = start + cell.len();
            if cell.len() > CROWD && cell.len() < ids.len() {
                self.crowds.push((offset + start, offset + end));
            }
            start = end;
        }
    }

    /// Puts the words of `ids` in order, with `bits` for the place of a point.
    fn sort_keys(
        &mut self,
        ids: &[u32],
        round: impl Fn(u32) -> u64,
        bits: u32,
        place: impl Fn(Point3) -> u64,
    ) {
        self.keys.clear();
        self.keys.extend(ids.iter().map(|&id| {
            let cell = (round(id) << bits) | place(self.points[id]);
            (cell << self.index_bits) | u64::from(id)
        }));
        radix_sort(
            &mut self.keys,
            &mut self.spare,
            self.index_bits,
            bits + ROUND_BITS,
        );
    }
}
