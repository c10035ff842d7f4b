//! Step 4c of method GS: a test list is split about its furthest point.
//!
//! Block by block, and through each block in passes: fetch the coordinates, ask about `[ik]`, note the furthest, ask
//! the others about `[kj]`, note the furthest. Where a point goes is a matter of chance, so the passes that ask have
//! no branch that depends on it, and fetching first lets the slow reads from memory overlap. In the passes that
//! note, a new furthest point is rare.

use super::arrays::{Arrays, Label};
use super::bookkeeping::Bookkeeping;
use super::call::{BLOCK, Call};
use super::forming::Forming;
use geometry_core::{Kernel2, Observer, Step};
use std::ops::Range;

/// The item of `[ij]` while it is split about k.
struct Splitting<'a> {
    /// `[ik]`, in the cells of NWK up to `front` (invariant 4).
    left: Forming,
    nwk: &'a mut [u32],
    front: usize,
    /// `[kj]`, in the cells of LIST up to `spill`.
    right: Forming,
    list: &'a mut [u32],
    spill: usize,
    /// The points inside, in the cells of LIST from `tail` on.
    tail: usize,
    /// Points of the present block not outside ik.
    pool: [u32; BLOCK],
}

impl<K: Kernel2, O: Observer, B: Bookkeeping> Call<'_, K, O, B> {
    /// Splits the item of `[ij]`, which has `len` points, k first, into `[ik]` at its beginning, `[kj]` at its end, and
    /// the points inside, which go to the tail of LIST.
    ///
    /// Points outside kj would overwrite points still to be read. They wait in the free cells of LIST, of which
    /// there are enough (invariant 5).
    pub(super) fn split(&mut self, arrays: &mut Arrays, label: Label, len: usize) {
        let Label { from: i, to: j, at } = label;
        let (at, free) = (at as usize, arrays.front);
        let (begin, end) = (at + 1, at + 1 + len);
        let k = arrays.nwk[begin];
        self.observer.step(|| Step::Line(i, j));
        self.observer.step(|| Step::Apex(k));

        let mut splitting = Splitting {
            left: Forming::new(self.points[i], self.points[k]),
            nwk: &mut arrays.nwk[..end],
            front: begin,
            right: Forming::new(self.points[k], self.points[j]),
            list: &mut arrays.list,
            spill: free,
            tail: arrays.tail,
            pool: [0; BLOCK],
        };
        for start in (begin + 1..end).step_by(BLOCK) {
            let block = start..end.min(start + BLOCK);
            let pooled = self.ask_left(&mut splitting, block);
            self.ask_right(&mut splitting, pooled);
        }
        let Splitting {
            left,
            nwk,
            front,
            right,
            list,
            spill,
            tail,
            ..
        } = splitting;

        let middle = end - (spill - free);
        nwk[middle..].copy_from_slice(&list[free..spill]);
        let left = left.draft(at, front - begin);
        let mut right = right.draft(middle - 1, end - middle);
        right.furthest = right.furthest.map(|cell| middle + (cell - free));
        arrays.tail = tail;
        right.push(arrays, k, j);
        left.push(arrays, i, k);
    }

    /// Puts the points in the cells `block` of NWK into `[ik]` or into the pool. Returns the number of the latter.
    fn ask_left(&mut self, splitting: &mut Splitting<'_>, block: Range<usize>) -> usize {
        let (points, kernel, boundary) = (self.points, self.kernel, self.boundary);
        let Splitting {
            left,
            nwk,
            front,
            pool,
            ..
        } = splitting;
        let mut near = [[0.0; 2]; BLOCK];
        for (near, &id) in near.iter_mut().zip(&nwk[block.clone()]) {
            *near = points[id];
        }
        let (first, mut pooled) = (*front, 0);
        for (cell, &point) in block.zip(&near) {
            let id = nwk[cell];
            self.observer.step(|| Step::Visit(id));
            let Some(listed) = left.lists(kernel, boundary, point) else {
                self.bookkeeping.copy(id, self.observer);
                continue;
            };
            // Both places are written, and one of them advances.
            let listed = usize::from(listed);
            nwk[*front] = id;
            pool[pooled] = id;
            *front += listed;
            pooled += 1 - listed;
        }
        left.note(kernel, points, &nwk[first..*front], first);
        pooled
    }

    /// Puts the first `pooled` points of the pool into `[kj]`, or takes them for inside.
    fn ask_right(&mut self, splitting: &mut Splitting<'_>, pooled: usize) {
        let (points, kernel, boundary) = (self.points, self.kernel, self.boundary);
        let Splitting {
            right,
            list,
            spill,
            tail,
            pool,
            ..
        } = splitting;
        let first = *spill;
        for &id in &pool[..pooled] {
            let Some(listed) = right.lists(kernel, boundary, points[id]) else {
                self.bookkeeping.copy(id, self.observer);
                continue;
            };
            let inside = usize::from(!listed);
            list[*spill] = id;
            *spill += 1 - inside;
            if B::KEEPS_INTERIOR {
                list[*tail - 1] = id;
                *tail -= inside;
            }
            if inside == 1 {
                self.bookkeeping.interior(id, self.observer);
            }
        }
        right.note(kernel, points, &list[first..*spill], first);
    }
}
