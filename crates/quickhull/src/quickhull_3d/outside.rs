//! The outside sets of all facets, in one vector.
//!
//! A set is a slice of `ids`. A set made anew goes to the end; one taken away leaves a gap. When the gaps outweigh the
//! sets, all sets are moved together, at a cost that what was written since the last time pays for.
//!
//! ```text
//!     ids   | facet 0 |  gap  | facet 7 | facet 8 |  gap  | facet 3 |   <- new sets
//! ```
//!
//! Invariant: the sets are disjoint, and `live` is the sum of their lengths.

use geometry_core::mesh::TriangleId;

/// The set of one facet: `ids[start..start + len]`, and its furthest point if it is not empty.
#[derive(Clone, Copy, Debug, Default)]
struct Set {
    start: usize,
    len: u32,
    furthest: u32,
}

/// The outside sets of the facets of a surface, by facet.
#[derive(Debug, Default)]
pub(super) struct OutsideSets {
    ids: Vec<u32>,
    sets: Vec<Set>,
    live: usize,
    /// The other vector for moving the sets together.
    moved: Vec<u32>,
}

/// Gaps of this length in all are not worth moving sets for.
const SMALL: usize = 1024;

impl OutsideSets {
    /// Makes `ids`, not empty, the set of `facet`, which has none.
    pub(super) fn put(&mut self, facet: TriangleId, ids: &[u32], furthest: u32) {
        if self.ids.len() + ids.len() > 2 * (self.live + ids.len()) + self.sets.len() + SMALL {
            self.move_together();
        }
        let slot = facet.0 as usize;
        if slot >= self.sets.len() {
            self.sets.resize(slot + 1, Set::default());
        }
        self.sets[slot] = Set {
            start: self.ids.len(),
            len: ids.len() as u32,
            furthest,
        };
        self.ids.extend_from_slice(ids);
        self.live += ids.len();
    }

    /// The furthest point of the set of `facet`, unless it is empty.
    pub(super) fn furthest(&self, facet: TriangleId) -> Option<u32> {
        let set = self.sets.get(facet.0 as usize)?;
        (set.len > 0).then_some(set.furthest)
    }

    /// Takes the set of `facet` away and puts its points at the end of `pool`.
    pub(super) fn take(&mut self, facet: TriangleId, pool: &mut Vec<u32>) {
        let Some(set) = self.sets.get_mut(facet.0 as usize) else {
            return;
        };
        let Set { start, len, .. } = std::mem::take(set);
        let end = start + len as usize;
        // Where an empty set starts means nothing: there may be no such place any more.
        if len == 0 {
            return;
        }
        pool.extend_from_slice(&self.ids[start..end]);
        self.live -= len as usize;
        if end == self.ids.len() {
            self.ids.truncate(start);
        }
    }

    /// How many ids are stored, gaps included.
    pub(super) fn stored(&self) -> usize {
        self.ids.len()
    }

    /// Numbers the points anew, in the order of the sets, and returns their old numbers in the new order.
    pub(super) fn renumber(&mut self) -> Vec<u32> {
        self.move_together();
        let order = std::mem::replace(&mut self.ids, (0..self.live as u32).collect());
        for set in &mut self.sets {
            let old = &order[set.start..set.start + set.len as usize];
            if let Some(place) = old.iter().position(|&id| id == set.furthest) {
                set.furthest = (set.start + place) as u32;
            }
        }
        order
    }

    fn move_together(&mut self) {
        self.moved.clear();
        for set in &mut self.sets {
            let start = self.moved.len();
            self.moved
                .extend_from_slice(&self.ids[set.start..set.start + set.len as usize]);
            set.start = start;
        }
        std::mem::swap(&mut self.ids, &mut self.moved);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_survive_being_moved_together() {
        let mut outside = OutsideSets::default();
        let kept: Vec<u32> = (0..10).collect();
        outside.put(TriangleId(3), &kept, 4);
        for round in 0..1000 {
            // Each set is taken only after the next one was put behind it, so that each leaves a gap.
            outside.put(TriangleId(4 + round % 2), &[round; 50], round);
            outside.take(TriangleId(5 - round % 2), &mut Vec::new());
        }
        assert!(outside.stored() < 2 * (10 + 100) + SMALL + 100);
        assert_eq!(outside.furthest(TriangleId(3)), Some(4));
        assert_eq!(outside.furthest(TriangleId(9)), None);
        let stored = outside.renumber();
        let furthest = outside
            .furthest(TriangleId(3))
            .expect("a set that is not empty");
        assert_eq!(stored[furthest as usize], 4);
        let mut pool = Vec::new();
        outside.take(TriangleId(3), &mut pool);
        assert!(pool.iter().map(|&place| stored[place as usize]).eq(kept));
        assert_eq!(outside.furthest(TriangleId(3)), None);
    }
    #[test]
    fn an_empty_set_may_be_taken_at_any_time() {
        let mut outside = OutsideSets::default();
        let mut pool = Vec::new();
        outside.put(TriangleId(0), &[0, 1, 2], 0);
        outside.put(TriangleId(1), &[3], 3);
        outside.take(TriangleId(1), &mut pool);
        assert_eq!(outside.renumber(), [0, 1, 2]);
        outside.take(TriangleId(0), &mut pool);
        outside.take(TriangleId(1), &mut pool);
        outside.take(TriangleId(2), &mut pool);
        assert_eq!((pool, outside.stored()), (vec![3, 0, 1, 2], 0));
    }
}
