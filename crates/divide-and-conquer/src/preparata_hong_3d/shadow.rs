//! The hull of the shadow on the x-y plane, kept as a ring of places within each hull in space.
//!
//! ```text
//!        .------.___________ upper line         seen from the far end of the z axis;
//!       /        \          '-----.             rings run anticlockwise
//!      (   first  a0      b0       \
//!       \        /          (second )
//!        '------'            \     /
//!           lower line ───────'---'
//! ```
//!
//! The walks for the supporting lines start at the facing ends a0 and b0 of the halves, which the sorted order
//! provides: the last place of the first half and the first of the second. An end steps on while the next vertex of
//! its ring lies beyond the line (Day's `onleft`), and what is passed leaves the ring for good, so all walks together
//! are linear in the number of points.

use super::questions::Questions;
use super::surface::{Fault, Policy, Surface};
use geometry_core::sort::merge_sort;
use geometry_core::{Observer, Sign, Step};
use std::ops::Range;

/// Which of the two supporting lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Line {
    Lower,
    Upper,
}

impl<P: Policy, Q: Questions, O: Observer> Surface<'_, P, Q, O> {
    /// The ends of a supporting line of the shadows of the halves of `range`, which meet at `middle`.
    pub(super) fn supporting_line(
        &mut self,
        line: Line,
        range: &Range<usize>,
        middle: usize,
    ) -> Result<[u32; 2], Fault> {
        let (mut left, mut right) = (middle as u32 - 1, middle as u32);
        let (mut left_stands, mut right_stands) = (false, false);
        // An exact kernel passes each place once at most.
        let mut budget = range.len();
        while !(left_stands && right_stands) {
            let next = if left_stands {
                self.around(line, right)
            } else {
                self.around_back(line, left)
            };
            let stands = if left_stands {
                next == right || self.turns(line, [left, right, next])
            } else {
                next == left || self.turns(line, [next, left, right])
            };
            match (left_stands, stands) {
                (true, true) => right_stands = true,
                (false, true) => left_stands = true,
                (true, false) => (right, left_stands) = (next, false),
                (false, false) => (left, right_stands) = (next, false),
            }
            if !stands {
                budget = budget.checked_sub(1).ok_or(Fault::Endless)?;
            }
        }
        let [from, to] = [left, right].map(|place| self.id(place));
        self.observer.step(|| Step::Bridge(from, to));
        Ok([left, right])
    }

    /// The next place along the lower or upper side of a ring, from left to right.
    fn around(&self, line: Line, place: u32) -> u32 {
        let links = &self.places[place as usize];
        match line {
            Line::Lower => links.after,
            Line::Upper => links.before,
        }
    }

    /// The next place along the lower or upper side of a ring, from right to left.
    fn around_back(&self, line: Line, place: u32) -> u32 {
        let links = &self.places[place as usize];
        match line {
            Line::Lower => links.before,
            Line::Upper => links.after,
        }
    }

    /// Whether three places turn as the lower or upper side of a ring does, or not at all (only rounding makes it so).
    fn turns(&self, line: Line, places: [u32; 3]) -> bool {
        let [a, b, c] = places.map(|place| self.point(place));
        let sign = self.questions.shadow(a, b, c);
        match line {
            Line::Lower => sign != Sign::Negative,
            Line::Upper => sign != Sign::Positive,
        }
    }

    /// Joins two rings by their supporting lines.
    pub(super) fn join_rings(&mut self, lower: [u32; 2], upper: [u32; 2]) {
        self.link_ring(lower[0], lower[1]);
        self.link_ring(upper[1], upper[0]);
    }

    fn link_ring(&mut self, place: u32, next: u32) {
        self.places[place as usize].after = next;
        self.places[next as usize].before = place;
    }

    /// Makes the ring of the hull of `range` anew: Graham's scan of its vertices, sorted by angle about the leftmost.
    pub(super) fn scan_ring(&mut self, range: Range<usize>) {
        let pivot = range.start as u32;
        let rest = range.start as u32 + 1..range.end as u32;
        let mut order: Vec<u32> = rest
            .filter(|&place| self.places[place as usize].has_edges())
            .collect();
        let mut scratch = vec![0; order.len()];
        let point = |place: u32| self.point(place);
        merge_sort(&mut order, &mut scratch, |p, q| {
            let turn = self.questions.shadow(point(pivot), point(p), point(q));
            (-turn).ordering()
        });
        let mut ring = vec![pivot];
        for place in order {
            while let [.., p, q] = ring[..]
                && !self.turns(Line::Lower, [p, q, place])
            {
                ring.pop();
            }
            ring.push(place);
        }
        for (i, &place) in ring.iter().enumerate() {
            self.link_ring(place, ring[(i + 1) % ring.len()]);
        }
    }
}
