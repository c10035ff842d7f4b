//! The outside sets of all facets, as lists of points that stay where they are.
//!
//! A point is on one list at most, so one vector of links holds all of them:
//!
//! ```text
//!               0   1   2   3   4   5   6   7   8  = the number of points
//!     links   | 4 | - | 7 |   | 2 | - |   | 5 |  0 |  1 | ...    the last ones: heads of lists under way
//!
//!     first list: 0, 4, 2, 7, 5      second list: 1
//! ```
//!
//! Invariants:
//!
//! 1. What follows the last point of a list that is [closed](Links::closed) is [`NIL`].
//! 2. Points are put behind the others, so that those that go together stay in order.

use super::fan::LANES;

/// Of a list without points, the first, and of any, what follows the last.
pub(super) const NIL: u32 = u32::MAX;

/// The most points that links can name.
pub(super) const MOST: usize = u32::MAX as usize - HANDS;

/// As many lists are under way as a fan has lanes, and one for the points that none takes; rounded up.
const HANDS: usize = (LANES + 1).next_power_of_two();

/// So many points are looked at before one is put on a list.
const BLOCK: usize = 64;

/// A list of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct List {
    /// The first point, or [`NIL`].
    pub(super) first: u32,
    /// The last point, if there is a first.
    last: u32,
}

impl List {
    pub(super) const EMPTY: Self = Self {
        first: NIL,
        last: NIL,
    };
}

/// The last points of the lists under way, or their heads.
#[derive(Debug)]
pub(super) struct Hands {
    last: [u32; HANDS],
}

/// The links of all lists.
#[derive(Debug)]
pub(super) struct Links {
    after: Vec<u32>,
    count: u32,
}

impl Links {
    /// All points on one list, in their order; there are at least one and at most [`MOST`].
    pub(super) fn of_all(count: usize) -> Self {
        let mut after = Vec::with_capacity(count + HANDS);
        after.extend(1..count as u32);
        after.resize(count + HANDS, NIL);
        Self {
            after,
            count: count as u32,
        }
    }

    /// Takes points off the list of [all](Self::of_all), from which no others have been taken; the first point left.
    pub(super) fn first_without<const N: usize>(&mut self, mut ids: [u32; N]) -> u32 {
        ids.sort_unstable();
        let mut first = 0;
        for &id in ids.iter().rev() {
            let following = self.after(id);
            match id.checked_sub(1) {
                Some(before) => self.after[before as usize] = following,
                None => first = following,
            }
        }
        first
    }

    /// The points of the list that begins with `first`.
    pub(super) fn from(&self, first: u32) -> impl Iterator<Item = u32> + '_ {
        let point = |id: u32| (id != NIL).then_some(id);
        std::iter::successors(point(first), move |&id| point(self.after(id)))
    }

    /// What follows a point on its list.
    #[inline(always)]
    pub(super) fn after(&self, id: u32) -> u32 {
        self.after[id as usize]
    }

    /// Takes the point after `before` off a list, or the first if that is [`NIL`].
    #[inline(always)]
    pub(super) fn take_after(&mut self, before: u32, list: &mut List) -> u32 {
        let taken = match before {
            NIL => list.first,
            _ => self.after(before),
        };
        let following = self.after(taken);
        match before {
            NIL => list.first = following,
            _ => self.after[before as usize] = following,
        }
        if taken == list.last {
            list.last = before;
        }
        taken
    }

    /// Puts lists one behind the other; the first point of all, or [`NIL`].
    #[inline(always)]
    pub(super) fn joined(&mut self, lists: impl Iterator<Item = List>) -> u32 {
        let head = self.count;
        let mut last = head;
        self.after[head as usize] = NIL;
        for list in lists {
            self.after[last as usize] = list.first;
            last = if list.first == NIL { last } else { list.last };
        }
        self.after(head)
    }

    /// No points in hand.
    #[inline(always)]
    pub(super) fn hands(&self) -> Hands {
        Hands {
            last: std::array::from_fn(|hand| self.count + hand as u32),
        }
    }

    /// Deals the list that begins with `first`: each point to the hand, at most [`LANES`], that `choose` tells.
    ///
    /// Which hand that is does not decide a branch, as the processor could not foresee it. The hands of a block are chosen before a
    /// link is written, so that it need not wait with reading links until it knows which are written.
    #[inline(always)]
    pub(super) fn deal(
        &mut self,
        first: u32,
        hands: &mut Hands,
        mut choose: impl FnMut(u32) -> usize,
    ) {
        let mut chosen = [(0, 0); BLOCK];
        let mut id = first;
        while id != NIL {
            let mut filled = 0;
            while id != NIL && filled < BLOCK {
                chosen[filled] = (id, choose(id) as u32);
                filled += 1;
                id = self.after(id);
            }
            for &(id, hand) in &chosen[..filled] {
                let last = &mut hands.last[hand as usize % HANDS];
                self.after[*last as usize] = id;
                *last = id;
            }
        }
    }

    /// The list in a hand (invariant 1).
    #[inline(always)]
    pub(super) fn closed(&mut self, hands: &Hands, hand: usize) -> List {
        let last = hands.last[hand];
        self.after[last as usize] = NIL;
        List {
            first: self.after[self.count as usize + hand],
            last,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(links: &Links, list: List) -> Vec<u32> {
        links.from(list.first).collect()
    }

    #[test]
    fn points_are_dealt_joined_and_taken() {
        let mut links = Links::of_all(200);
        let mut hands = links.hands();
        links.deal(0, &mut hands, |id| [8, 0, 3][id as usize % 3]);
        let [mut first, third, empty, rest] =
            [0, 3, 5, LANES].map(|hand| links.closed(&hands, hand));
        assert!(links.from(first.first).eq((1..200).step_by(3)));
        assert!(links.from(third.first).eq((2..200).step_by(3)));
        assert!(links.from(rest.first).eq((0..200).step_by(3)));
        assert_eq!(empty.first, NIL);

        assert_eq!(links.take_after(NIL, &mut first), 1);
        assert_eq!(links.take_after(4, &mut first), 7);
        assert_eq!(links.take_after(196, &mut first), 199);
        let all = [empty, first, empty, third, empty];
        let joined = links.joined(all.into_iter());
        let expected = (4..199).step_by(3).filter(|&id| id != 7);
        assert!(links.from(joined).eq(expected.chain((2..200).step_by(3))));
        assert_eq!(links.joined([empty, empty].into_iter()), NIL);
    }

    #[test]
    fn some_of_all_are_left_out() {
        let left = |ids: [u32; 3]| {
            let mut links = Links::of_all(6);
            let first = links.first_without(ids);
            links.from(first).collect::<Vec<u32>>()
        };
        assert_eq!(left([3, 1, 4]), [0, 2, 5]);
        assert_eq!(left([1, 0, 5]), [2, 3, 4]);
        assert_eq!(Links::of_all(3).first_without([2, 0, 1]), NIL);
    }

    #[test]
    fn a_list_of_one_can_be_emptied() {
        let mut links = Links::of_all(1);
        let mut hands = links.hands();
        links.deal(0, &mut hands, |_| 2);
        let mut list = links.closed(&hands, 2);
        assert_eq!(points(&links, list), [0]);
        assert_eq!(links.take_after(NIL, &mut list), 0);
        assert_eq!(list, List::EMPTY);
    }
}
