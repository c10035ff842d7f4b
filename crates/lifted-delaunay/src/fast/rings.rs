//! The edges of a planar triangulation, in rings around their vertices.
//!
//! ```text
//!            next of e
//!               \        e          e ^ 1
//!                v ------------>  <------------ w
//!               /
//!            prev of e          e leaves v for w, e ^ 1 leaves w for v
//! ```
//!
//! **Room.** Straight edges that do not cross number at most 3 m - 3 on m ≥ 2 points, and in a merge an edge is removed before
//! one that would cross it is made. Removed edges are used again before fresh ones, so 3 m places are always enough.

use rayon::prelude::*;
use std::ops::Range;

/// Halves that one thread takes at a time.
const STRETCH: usize = 1 << 16;

/// No edge.
pub(super) const NONE: u32 = u32::MAX;

/// Places for halves, for each vertex.
pub(super) const HALVES_PER_VERTEX: usize = 6;

/// An edge seen from one end: [`NEXT`], [`PREV`] and [`ORIGIN`]. The two halves of an edge are neighbours in memory:
/// `e ^ 1` is the other one. An array rather than a struct, so that memory comes zeroed from the system and is only
/// touched where edges are.
pub(super) type Half = [u32; 3];

/// The next half with the same origin, anticlockwise.
const NEXT: usize = 0;
/// The previous one; [`NONE`] for halves that are not in use any more, or not on the left of any triangle.
const PREV: usize = 1;
/// Where it starts.
const ORIGIN: usize = 2;

/// The edges, and which places are free.
#[derive(Debug)]
pub(super) struct Rings<'a> {
    halves: &'a mut [Half],
    room: Room,
}

/// Which places are free.
#[derive(Debug)]
pub(super) struct Room {
    /// The first half of the edge that was removed last, whose [`NEXT`] leads to the one before.
    removed: u32,
    /// Halves from here up to `end` were never in use.
    fresh: u32,
    end: u32,
    /// Other stretches that were never in use.
    spare: Vec<(u32, u32)>,
}

impl Room {
    /// All of `halves`, which are zeros.
    pub(super) fn all(halves: &[Half]) -> Self {
        Self {
            removed: NONE,
            fresh: 0,
            end: halves.len() as u32,
            spare: Vec::new(),
        }
    }
}

impl Room {
    /// How many of the first `len` halves may be in use.
    fn used(&self, len: usize) -> usize {
        let stretches = self.spare.iter().copied();
        let mut stretches = stretches.chain([(self.fresh, self.end)]);
        let last = stretches.find(|&(_, end)| end as usize == len);
        last.map_or(len, |(fresh, _)| fresh as usize)
    }

    #[cold]
    fn take_spare(&mut self) {
        if let Some((fresh, end)) = self.spare.pop() {
            (self.fresh, self.end) = (fresh, end);
        }
    }
}

impl<'a> Rings<'a> {
    /// The edges among `halves` so far.
    pub(super) fn new(halves: &'a mut [Half], room: Room) -> Self {
        Self { halves, room }
    }

    /// Lets the halves go.
    pub(super) fn into_room(self) -> Room {
        self.room
    }

    /// Takes the halves from `base` on, which so far were numbered from zero and had `room`, for those of the vertices from
    /// `first` on.
    pub(super) fn adopt(&mut self, base: usize, first: u32, room: Room) {
        let by = base as u32;
        let moved = |e: u32| if e == NONE { NONE } else { e + by };
        let shift = |stretch: &mut [Half]| {
            for half in stretch {
                *half = [moved(half[NEXT]), moved(half[PREV]), half[ORIGIN] + first];
            }
        };
        let used = room.used(self.halves.len() - base);
        let used = &mut self.halves[base..base + used];
        used.par_chunks_mut(STRETCH).for_each(shift);
        if room.removed != NONE {
            let mut last = moved(room.removed);
            while self.next(last) != NONE {
                last = self.next(last);
            }
            self.halves[last as usize][NEXT] = self.room.removed;
            self.room.removed = moved(room.removed);
        }
        let stretches = room.spare.into_iter().chain([(room.fresh, room.end)]);
        let stretches = stretches.map(|(fresh, end)| (moved(fresh), moved(end)));
        self.room.spare.extend(stretches);
    }

    #[inline(always)]
    pub(super) fn next(&self, e: u32) -> u32 {
        self.halves[e as usize][NEXT]
    }

    #[inline(always)]
    pub(super) fn prev(&self, e: u32) -> u32 {
        self.halves[e as usize][PREV]
    }

    #[inline(always)]
    pub(super) fn origin(&self, e: u32) -> u32 {
        self.halves[e as usize][ORIGIN]
    }

    #[inline(always)]
    pub(super) fn target(&self, e: u32) -> u32 {
        self.halves[(e ^ 1) as usize][ORIGIN]
    }

    /// A place for a new edge, whose halves are in no ring yet.
    #[inline(always)]
    pub(super) fn allocate(&mut self) -> u32 {
        let room = &mut self.room;
        if room.removed != NONE {
            let e = room.removed;
            room.removed = self.halves[e as usize][NEXT];
            return e;
        }
        if room.fresh == room.end {
            room.take_spare();
        }
        let e = room.fresh;
        room.fresh += 2;
        e
    }

    /// Makes `e` the only half around `origin`.
    #[inline(always)]
    pub(super) fn put_alone(&mut self, e: u32, origin: u32) {
        self.halves[e as usize] = [e, e, origin];
    }

    /// Puts `e` into the ring around `origin`, just clockwise of `after`.
    #[inline(always)]
    pub(super) fn put_before(&mut self, e: u32, after: u32, origin: u32) {
        let prev = self.prev(after);
        self.halves[e as usize] = [after, prev, origin];
        self.halves[after as usize][PREV] = e;
        self.halves[prev as usize][NEXT] = e;
    }

    /// Puts `e` into the ring around `origin`, just anticlockwise of `before`.
    #[inline(always)]
    pub(super) fn put_after(&mut self, e: u32, before: u32, origin: u32) {
        let next = self.next(before);
        self.halves[e as usize] = [next, before, origin];
        self.halves[before as usize][NEXT] = e;
        self.halves[next as usize][PREV] = e;
    }

    /// Takes an edge out of both its rings.
    #[inline(always)]
    pub(super) fn remove(&mut self, e: u32) {
        for half in [e, e ^ 1] {
            let [next, prev, _] = self.halves[half as usize];
            self.halves[prev as usize][NEXT] = next;
            self.halves[next as usize][PREV] = prev;
            self.halves[half as usize][PREV] = NONE;
        }
        let first = e & !1;
        self.halves[first as usize][NEXT] = self.room.removed;
        self.room.removed = first;
    }

    /// Marks the halves with the outside on their left, where `out` is an edge of the hull, anticlockwise. To be done once,
    /// at the end: rings cannot be walked backwards any more.
    pub(super) fn mark_outside(&mut self, out: u32) {
        let mut e = out;
        loop {
            let back = e ^ 1;
            e = self.next(back);
            self.halves[back as usize][PREV] = NONE;
            if e == out {
                break;
            }
        }
    }

    /// All halves that were ever in use, to be searched for triangles.
    pub(super) fn finished(&self) -> Finished<'_> {
        Finished {
            halves: &self.halves[..self.room.used(self.halves.len())],
        }
    }
}

/// Edges that will not change any more, with the outside marked.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finished<'a> {
    halves: &'a [Half],
}

impl Finished<'_> {
    /// The number of places for edges.
    pub(super) fn len(self) -> usize {
        self.halves.len() / 2
    }

    /// Puts the triangles found at the edges of these places, each from its corner of least name, into `triangles`, in no
    /// order, and returns how many there are.
    ///
    /// Each is found at one edge, that of its two lesser names, on the left of the half that runs upwards. Every
    /// edge's is written down, and the next one over it if there was none: cheaper than branches that nothing could
    /// predict. So there must be room for one more than there are triangles. Places never in use are edges from a vertex to itself.
    pub(super) fn triangles(
        self,
        edges: Range<usize>,
        names: &[u32],
        triangles: &mut [[u32; 3]],
    ) -> usize {
        let name = |vertex: u32| names[vertex as usize];
        let edges = &self.halves.as_chunks::<2>().0[edges];
        let mut found = 0;
        for &[there, back] in edges {
            if there[PREV] == NONE && back[PREV] == NONE {
                continue;
            }
            let (a, b) = (name(there[ORIGIN]), name(back[ORIGIN]));
            let half = if a < b { there } else { back };
            let (from, to) = (a.min(b), a.max(b));
            let apex = name(self.halves[(half[NEXT] ^ 1) as usize][ORIGIN]);
            triangles[found] = [from, to, apex];
            found += usize::from((half[PREV] != NONE) & (from < to) & (from < apex));
        }
        found
    }
}
