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
        let mut pool = Vec::new();
        outside.take(TriangleId(3), &mut pool);
        assert_eq!(pool, kept);
        assert_eq!(outside.furthest(TriangleId(3)), None);
    }
}
