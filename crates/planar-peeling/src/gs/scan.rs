//! The two scans of method GS that ask the kernel: the base line (step 3) and the split of a test list (step 4c).
//!
//! Both go block by block, and through each block twice: once to ask which side, once to find the furthest of
//! the points just listed. Which side is a matter of chance, so the first pass has no branch that depends on it;
//! in the second, a new furthest point is rare.

use super::arrays::{Arrays, Label};
use super::bookkeeping::Bookkeeping;
use super::forming::Forming;
use geometry_core::{Boundary, Kernel2, Observer, Points, Step};

/// Points asked before the furthest of them is sought: few enough to be still in the nearest cache.
const BLOCK: usize = 128;

/// What one call of the routine works with, besides the arrays.
pub(super) struct Call<'a, K, O, B> {
    pub(super) points: Points<'a, 2>,
    pub(super) boundary: Boundary,
    pub(super) kernel: &'a K,
    pub(super) observer: &'a mut O,
    pub(super) bookkeeping: &'a mut B,
}

/// A test list whose points are in place in NWK, but not yet its length.
struct Draft {
    at: usize,
    len: usize,
    furthest: Option<usize>,
}

impl<K: Kernel2, O: Observer, B: Bookkeeping> Call<'_, K, O, B> {
    /// Step 3: forms [ij] at the beginning of NWK and [ji] at its end from the points in the tail of LIST, which
    /// they leave, and pushes their labels. Returns whether no point lies off the line.
    ///
    /// Points on the base line wait at the end of LIST until it is known which side is empty (departure 2).
    pub(super) fn split_base(&mut self, arrays: &mut Arrays, i: u32, j: u32) -> bool {
        let (points, kernel) = (self.points, self.kernel);
        let mut below = Forming::new(points[i], points[j]);
        let mut above = Forming::new(points[j], points[i]);
        self.observer.step(|| Step::Line(i, j));

        let (tail, cells) = (arrays.tail, arrays.left() + 2);
        let (list, nwk) = (&mut arrays.list[..], &mut arrays.nwk[..cells]);
        let (mut read, mut waiting) = (list.len(), list.len());
        let (mut front, mut back) = (1, cells);
        while read > tail {
            let end = read;
            read = tail.max(end.saturating_sub(BLOCK));
            let (first, last) = (front, back);
            for cell in (read..end).rev() {
                let id = list[cell];
                self.observer.step(|| Step::Visit(id));
                let sign = kernel.orient(points[i], points[j], points[id]);
                if sign.is_zero() {
                    if below.ends_in_copy_of(kernel, points[id]) {
                        self.bookkeeping.copy(id, self.observer);
                    } else {
                        waiting -= 1;
                        list[waiting] = id;
                    }
                    continue;
                }
                // Both ends are written, and one of them advances.
                let outside = usize::from(sign.is_negative());
                nwk[front] = id;
                nwk[back - 1] = id;
                front += outside;
                back -= 1 - outside;
            }
            below.note(kernel, points, &nwk[first..front], first);
            above.note(kernel, points, &nwk[back..last], back);
        }
        arrays.tail = waiting;
        let (len_below, len_above) = (front - 1, cells - back);
        let below = Draft {
            at: 0,
            len: len_below,
            furthest: below.furthest_of(len_below),
        };
        let above = Draft {
            at: back - 1,
            len: len_above,
            furthest: above.furthest_of(len_above),
        };
        let [below, above] = self.list_waiting(arrays, below, above);
        self.push(arrays, j, i, above);
        self.push(arrays, i, j, below);
        len_below == 0 && len_above == 0
    }

    /// Gives the points that wait on the base line to its empty side, where they are doubtful points; if no
    /// side is empty, they are inside the peel and stay where they are.
    fn list_waiting(&mut self, arrays: &mut Arrays, below: Draft, above: Draft) -> [Draft; 2] {
        let waiting = &arrays.list[arrays.tail..];
        let on_boundary = below.len == 0 || above.len == 0;
        if self.boundary == Boundary::Extreme || !on_boundary {
            for &id in waiting {
                self.bookkeeping.interior(id, self.observer);
            }
            return [below, above];
        }
        let len = waiting.len();
        let at = if below.len == 0 { 0 } else { below.len + 1 };
        arrays.nwk[at + 1..=at + len].copy_from_slice(waiting);
        arrays.tail = arrays.list.len();
        let doubtful = Draft {
            at,
            len,
            furthest: None,
        };
        if below.len == 0 {
            [doubtful, above]
        } else {
            [below, doubtful]
        }
    }

    /// Step 4c: splits the item of [ij], which has `len` points, k first, into [ik] at its beginning, [kj] at its
    /// end, and the points inside, which go to the tail of LIST.
    ///
    /// The points outside kj would overwrite points still to be read. They wait in the free cells of LIST, of
    /// which there are enough (invariant 5).
    pub(super) fn split(&mut self, arrays: &mut Arrays, label: Label, len: usize) {
        let (points, kernel, boundary) = (self.points, self.kernel, self.boundary);
        let (at, free) = (label.at as usize, arrays.front);
        let k = arrays.nwk[at + 1];
        let mut left = Forming::new(points[label.from], points[k]);
        let mut right = Forming::new(points[k], points[label.to]);
        self.observer.step(|| Step::Line(label.from, label.to));
        self.observer.step(|| Step::Apex(k));

        let item_end = at + 1 + len;
        let (list, nwk) = (&mut arrays.list[..], &mut arrays.nwk[..item_end]);
        let (mut read, mut front) = (at + 2, at + 1);
        let (mut spill, mut tail) = (free, arrays.tail);
        let mut pool = [0; BLOCK];
        while read < item_end {
            let block = read..item_end.min(read + BLOCK);
            read = block.end;
            let (first, mut pooled) = (front, 0);
            for cell in block {
                let id = nwk[cell];
                self.observer.step(|| Step::Visit(id));
                let Some(listed) = left.lists(kernel, boundary, points[id]) else {
                    self.bookkeeping.copy(id, self.observer);
                    continue;
                };
                let listed = usize::from(listed);
                nwk[front] = id;
                pool[pooled] = id;
                front += listed;
                pooled += 1 - listed;
            }
            left.note(kernel, points, &nwk[first..front], first);
            let first = spill;
            for &id in &pool[..pooled] {
                let Some(listed) = right.lists(kernel, boundary, points[id]) else {
                    self.bookkeeping.copy(id, self.observer);
                    continue;
                };
                let inside = usize::from(!listed);
                list[spill] = id;
                spill += 1 - inside;
                if B::KEEPS_INTERIOR {
                    list[tail - 1] = id;
                    tail -= inside;
                }
                if inside == 1 {
                    self.bookkeeping.interior(id, self.observer);
                }
            }
            right.note(kernel, points, &list[first..spill], first);
        }
        arrays.tail = tail;

        let (len_left, len_right) = (front - (at + 1), spill - free);
        let begin = item_end - len_right;
        nwk[begin..].copy_from_slice(&list[free..spill]);
        let furthest = right
            .furthest_of(len_right)
            .map(|cell| begin + (cell - free));
        let right = Draft {
            at: begin - 1,
            len: len_right,
            furthest,
        };
        let left = Draft {
            at,
            len: len_left,
            furthest: left.furthest_of(len_left),
        };
        self.push(arrays, k, label.to, right);
        self.push(arrays, label.from, k, left);
    }

    /// Completes a test list and puts its label on the stack.
    fn push(&mut self, arrays: &mut Arrays, from: u32, to: u32, draft: Draft) {
        let at = arrays.complete(draft.at, draft.len, draft.furthest);
        arrays.open.push(Label { from, to, at });
    }
}
