//! The two scans of method GS that ask the kernel: the base line (step 3) and the split of a test list (step 4c).

use super::arrays::{Arrays, Label};
use super::bookkeeping::Bookkeeping;
use geometry_core::{Boundary, Kernel2, Observer, Point2, Points, Sign, Step};
use std::cmp::Ordering;

/// What one call of the routine works with, besides the arrays.
pub(super) struct Call<'a, K, O, B> {
    pub(super) points: Points<'a, 2>,
    pub(super) boundary: Boundary,
    pub(super) kernel: &'a K,
    pub(super) observer: &'a mut O,
    pub(super) bookkeeping: &'a mut B,
}

/// Where a point lies with regard to a directed line.
enum Side {
    /// To the right: it is listed.
    Outside,
    /// On the line between its ends, and boundary points count: a doubtful point, listed too.
    Between,
    /// A copy of the apex.
    Copy,
    /// None of these.
    Elsewhere,
}

/// The point furthest outside a line so far.
struct Furthest {
    line: [Point2; 2],
    point: Point2,
    id: u32,
    place: Option<usize>,
}

impl Furthest {
    fn outside(from: Point2, to: Point2) -> Self {
        Self {
            line: [to, from],
            point: from,
            id: 0,
            place: None,
        }
    }

    /// Takes note of a point outside the line, which is at `place` in NWK.
    ///
    /// Of points equally far, the one nearest to the end of the line is an extreme point (invariant 3); of
    /// copies, the smallest index stands for all.
    #[inline(always)]
    fn offer<K: Kernel2>(&mut self, kernel: &K, id: u32, point: Point2, place: usize) {
        let further = match self.place {
            None => true,
            Some(_) => {
                let [a, b] = self.line;
                match kernel.compare_distance_then_along(a, b, point, self.point) {
                    Ordering::Greater => true,
                    Ordering::Equal => id < self.id,
                    Ordering::Less => false,
                }
            }
        };
        if further {
            (self.id, self.point, self.place) = (id, point, Some(place));
        }
    }
}

/// A test list whose points are in place in NWK, but not yet its length.
struct Draft {
    at: usize,
    len: usize,
    furthest: Option<usize>,
}

impl<K: Kernel2, O: Observer, B: Bookkeeping> Call<'_, K, O, B> {
    /// Step 3: forms [ij] at the beginning of NWK and [ji] at its end from the tail of LIST, which they
    /// leave, and
    /// pushes their labels. Returns whether no point lies off the line.
    ///
    /// Points on the base line wait at the end of LIST until it is known which side is empty (departure 2).
    pub(super) fn split_base(&mut self, arrays: &mut Arrays, i: u32, j: u32) -> bool {
        let points = self.points;
        let [a, b] = [points[i], points[j]];
        let mut furthest = [Furthest::outside(a, b), Furthest::outside(b, a)];
        let (tail, cells) = (arrays.tail, arrays.left() + 2);
        let (list, nwk) = (&mut arrays.list[..], &mut arrays.nwk[..cells]);
        let (mut front, mut back, mut waiting) = (1, cells, list.len());
        self.observer.step(|| Step::Line(i, j));
        for cell in (tail..list.len()).rev() {
            let id = list[cell];
            let point = points[id];
            self.observer.step(|| Step::Visit(id));
            let sign = self.kernel.orient(a, b, point);
            if sign.is_zero() {
                if self.are_copies(point, a) || self.are_copies(point, b) {
                    self.bookkeeping.copy(id, self.observer);
                } else {
                    waiting -= 1;
                    list[waiting] = id;
                }
                continue;
            }
            // The side is a coin toss, and a branch would guess it wrong every other time. So both ends are
            // written and one of them advances.
            let inside = usize::from(sign.is_positive());
            nwk[front] = id;
            nwk[back - 1] = id;
            let place = [front, back - 1][inside];
            front += 1 - inside;
            back -= inside;
            furthest[inside].offer(self.kernel, id, point, place);
        }
        arrays.tail = waiting;
        let [below, above] = furthest;
        let below = Draft {
            at: 0,
            len: front - 1,
            furthest: below.place,
        };
        let above = Draft {
            at: back - 1,
            len: cells - back,
            furthest: above.place,
        };
        let flat = below.len == 0 && above.len == 0;
        let [below, above] = self.list_waiting(arrays, below, above);
        self.push(arrays, j, i, above);
        self.push(arrays, i, j, below);
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
        arrays.tail = arrays.list.len();
        let draft = |at| Draft {
            at,
            len,
            furthest: None,
        };
        if below.len == 0 {
            arrays.nwk[1..=len].copy_from_slice(waiting);
            [draft(0), above]
        } else {
            let end = below.len + len + 2;
            arrays.nwk[end - len..end].copy_from_slice(waiting);
            [below, draft(end - len - 1)]
        }
    }

    /// Step 4c: splits the item of [ij], which has `len` points, k first, into [ik] at its beginning, [kj] at its
    /// end, and the points inside, which go to the tail of LIST.
    pub(super) fn split(&mut self, arrays: &mut Arrays, label: Label, len: usize) {
        let points = self.points;
        let at = label.at as usize;
        let k = arrays.nwk[at + 1];
        let [i, k_point, j] = [label.from, k, label.to].map(|id| points[id]);
        let mut left = Furthest::outside(i, k_point);
        let mut right = Furthest::outside(k_point, j);
        self.observer.step(|| Step::Line(label.from, label.to));
        self.observer.step(|| Step::Apex(k));

        let item_end = at + 1 + len;
        // Written up to `front` and from `back` on; `read..back` is still to be read (invariant 4).
        let (mut front, mut read, mut back) = (at + 1, at + 2, item_end);
        let (list, nwk) = (&mut arrays.list[..], &mut arrays.nwk[..item_end]);
        let mut tail = arrays.tail;
        while read < back {
            let id = nwk[read];
            let point = points[id];
            self.observer.step(|| Step::Visit(id));
            let mut side = self.side(i, k_point, k_point, point);
            if let Side::Outside | Side::Between = side {
                if let Side::Outside = side {
                    left.offer(self.kernel, id, point, front);
                }
                nwk[front] = id;
                front += 1;
                read += 1;
                continue;
            }
            if let Side::Elsewhere = side {
                side = self.side(k_point, j, k_point, point);
            }
            match side {
                Side::Outside | Side::Between => {
                    back -= 1;
                    nwk.swap(read, back);
                    if let Side::Outside = side {
                        right.offer(self.kernel, id, point, back);
                    }
                }
                Side::Copy => {
                    read += 1;
                    self.bookkeeping.copy(id, self.observer);
                }
                Side::Elsewhere => {
                    read += 1;
                    self.bookkeeping.interior(id, self.observer);
                    if B::KEEPS_INTERIOR {
                        tail -= 1;
                        list[tail] = id;
                    }
                }
            }
        }
        arrays.tail = tail;
        let left = Draft {
            at,
            len: front - at - 1,
            furthest: left.place,
        };
        let right = Draft {
            at: back - 1,
            len: item_end - back,
            furthest: right.place,
        };
        self.push(arrays, k, label.to, right);
        self.push(arrays, label.from, k, left);
    }

    /// Completes a test list and puts its label on the stack.
    fn push(&mut self, arrays: &mut Arrays, from: u32, to: u32, draft: Draft) {
        let at = arrays.complete(draft.at, draft.len, draft.furthest);
        arrays.open.push(Label { from, to, at });
    }

    /// Where `point` lies with regard to a→b, one of whose ends is `apex`. One orientation.
    #[inline(always)]
    fn side(&self, a: Point2, b: Point2, apex: Point2, point: Point2) -> Side {
        match self.kernel.orient(a, b, point) {
            Sign::Negative => Side::Outside,
            Sign::Positive => Side::Elsewhere,
            Sign::Zero => self.side_on_line(a, b, apex, point),
        }
    }

    #[cold]
    fn side_on_line(&self, a: Point2, b: Point2, apex: Point2, point: Point2) -> Side {
        let before = |p, q| self.kernel.compare_along(a, b, p, q).is_lt();
        if self.are_copies(point, apex) {
            Side::Copy
        } else if self.boundary == Boundary::All && before(a, point) && before(point, b) {
            Side::Between
        } else {
            Side::Elsewhere
        }
    }

    pub(super) fn are_copies(&self, p: Point2, q: Point2) -> bool {
        self.kernel.lexicographic(p, q).is_eq()
    }
}
