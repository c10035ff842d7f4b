//! The outside sets of all facets, the points themselves and not their numbers, in one vector.
//!
//! A set is a stretch of `sites`. A set made anew goes to the end; one taken away leaves a gap. When there is no more
//! room at the end, all sets are moved together, and if that does not free a third of the vector, it grows.
//!
//! ```text
//!     sites   | facet 0 |  gap  | facet 7 | facet 8 |  gap  | facet 3 | room |
//!                                                                     ^ end
//! ```
//!
//! Invariant: the sets are disjoint, all before `end`, and `live` is the sum of their lengths.

use geometry_core::Point3;
use geometry_core::mesh::TriangleId;

/// A point and its index.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Site {
    pub(super) at: Point3,
    pub(super) id: u32,
}

/// The set of one facet: `sites[start..start + len]`.
#[derive(Clone, Copy, Debug, Default)]
struct Set {
    start: usize,
    len: u32,
}

/// The outside sets of the facets of a surface, by facet.
#[derive(Debug, Default)]
pub(super) struct OutsideSets {
    sites: Vec<Site>,
    sets: Vec<Set>,
    end: usize,
    live: usize,
    /// The facets in the order of their sets.
    order: Vec<u32>,
}

impl OutsideSets {
    /// Room for a new set of up to `len` points, to be written and then claimed by [`put`](Self::put).
    pub(super) fn room(&mut self, len: usize) -> &mut [Site] {
        if self.end + len > self.sites.len() {
            self.make_room(len);
        }
        &mut self.sites[self.end..]
    }

    /// Makes the first `len` points written to the room, at least one, the set of `facet`, which has none.
    pub(super) fn put(&mut self, facet: TriangleId, len: usize) {
        let slot = facet.0 as usize;
        if slot >= self.sets.len() {
            self.sets.resize(slot + 1, Set::default());
        }
        self.sets[slot] = Set {
            start: self.end,
            len: len as u32,
        };
        self.end += len;
        self.live += len;
    }

    /// Takes the set of `facet` away and gives its points to `pool`.
    pub(super) fn take(&mut self, facet: TriangleId, pool: &mut Vec<Site>) {
        let Some(set) = self.sets.get_mut(facet.0 as usize) else {
            return;
        };
        let Set { start, len } = std::mem::take(set);
        let end = start + len as usize;
        if len == 0 {
            return;
        }
        pool.extend_from_slice(&self.sites[start..end]);
        self.live -= len as usize;
        if end == self.end {
            self.end = start;
        }
    }

    /// Takes a point of the set of `facet` out of it, the one that `choose` finds the place of; none if the set has none.
    pub(super) fn take_by(
        &mut self,
        facet: TriangleId,
        choose: impl FnOnce(&[Site]) -> usize,
    ) -> Option<Site> {
        let set = self.sets.get_mut(facet.0 as usize)?;
        if set.len == 0 {
            return None;
        }
        let sites = &mut self.sites[set.start..set.start + set.len as usize];
        let place = choose(sites);
        let chosen = &mut sites[place..];
        let site = chosen[0];
        // The others stay in order.
        chosen.copy_within(1.., 0);
        self.end -= usize::from(set.start + set.len as usize == self.end);
        set.len -= 1;
        self.live -= 1;
        Some(site)
    }

    /// How many points can be stored.
    pub(super) fn stored(&self) -> usize {
        self.sites.len()
    }

    #[cold]
    fn make_room(&mut self, len: usize) {
        self.close_gaps();
        let needed = self.live + len;
        let enough = needed + needed / 2;
        if enough > self.sites.len() {
            self.sites.reserve_exact(enough - self.sites.len());
            self.sites.resize(enough, Site::default());
        }
    }

    /// Moves all sets to the front, in the order in which they lie.
    fn close_gaps(&mut self) {
        let is_there = |slot: &u32| self.sets[*slot as usize].len > 0;
        self.order.clear();
        self.order
            .extend((0..self.sets.len() as u32).filter(is_there));
        self.order
            .sort_unstable_by_key(|&slot| self.sets[slot as usize].start);
        self.end = 0;
        for &slot in &self.order {
            let Set { start, len } = &mut self.sets[slot as usize];
            let sites = *start..*start + *len as usize;
            *start = self.end;
            self.end += sites.len();
            self.sites.copy_within(sites, *start);
        }
    }
}
