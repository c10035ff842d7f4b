//! Step 3 of method GS: the test lists of the base line.

use super::arrays::Arrays;
use super::bookkeeping::Bookkeeping;
use super::call::{BLOCK, Call, Draft};
use super::forming::Forming;
use geometry_core::{Boundary, Kernel2, Observer, Step};

impl<K: Kernel2, O: Observer, B: Bookkeeping> Call<'_, K, O, B> {
    /// Step 3: forms `[ij]` at the beginning of NWK and `[ji]` at its end from the points in the tail of LIST, which
    /// they leave, and pushes their labels. Returns whether no point lies off the line.
    ///
    /// Points on the base line wait at the end of LIST until it is known which side is empty (departure 2).
    pub(super) fn split_base(&mut self, arrays: &mut Arrays, i: u32, j: u32) -> bool {
        let (points, kernel) = (self.points, self.kernel);
        let [a, b] = [points[i], points[j]];
        let (mut below, mut above) = (Forming::new(a, b), Forming::new(b, a));
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
                let sign = kernel.orient(a, b, points[id]);
                if sign.is_zero() {
                    if below.ends_in_copy_of(kernel, points[id]) {
                        self.bookkeeping.copy(id, self.observer);
                    } else {
                        waiting -= 1;
                        list[waiting] = id;
                    }
                    continue;
                }
                // The side is a coin toss, and a branch would guess it wrong every other time. So both ends are
                // written, and one of them advances.
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
        let (below, above) = (
            below.draft(0, front - 1),
            above.draft(back - 1, cells - back),
        );
        let flat = below.len == 0 && above.len == 0;
        let [below, above] = self.list_waiting(arrays, below, above);
        above.push(arrays, j, i);
        below.push(arrays, i, j);
        flat
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
}
