//! The edges of a planar triangulation, in rings around their vertices.

/// No edge.
pub(super) const NONE: u32 = u32::MAX;

/// An edge seen from one end: [`NEXT`], [`PREV`] and [`ORIGIN`]. The two halves of an edge are neighbours in memory:
/// `e ^ 1` is the other one. An array rather than a struct, so that memory comes zeroed from the system and is only
/// touched where edges are.
pub(super) type Half = [u32; 3];

/// The next half with the same origin, anticlockwise.
const NEXT: usize = 0;
/// The previous one; [`NONE`] for halves that are not in use.
const PREV: usize = 1;
/// Where it starts.
const ORIGIN: usize = 2;

/// Edges with room for a triangulation of a third as many vertices, and a list of the places that are free again.
#[derive(Debug)]
pub(super) struct Rings<'a> {
    halves: &'a mut [Half],
    /// The first half of the last edge that was removed, whose `next` leads to the one before.
    removed: u32,
    /// Halves from here on were never in use.
    fresh: u32,
}

impl<'a> Rings<'a> {
    pub(super) fn new(halves: &'a mut [Half]) -> Self {
        Self {
            halves,
            removed: NONE,
            fresh: 0,
        }
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

    /// A place for a new edge. Its halves are in no ring yet.
    #[inline(always)]
    pub(super) fn allocate(&mut self) -> u32 {
        if self.removed == NONE {
            let e = self.fresh;
            self.fresh += 2;
            e
        } else {
            let e = self.removed;
            self.removed = self.halves[e as usize][NEXT];
            e
        }
    }

    /// Makes `e` the only half around `origin`.
    #[inline(always)]
    pub(super) fn put_alone(&mut self, e: u32, origin: u32) {
        self.halves[e as usize] = [e, e, origin];
    }

    /// Puts `e` into the ring around `origin`, just clockwise of `after`.
    #[inline(always)]
    pub(super) fn put_before(&mut self, e: u32, after: u32, origin: u32) {
        let prev = self.halves[after as usize][PREV];
        self.halves[e as usize] = [after, prev, origin];
        self.halves[after as usize][PREV] = e;
        self.halves[prev as usize][NEXT] = e;
    }

    /// Puts `e` into the ring around `origin`, just anticlockwise of `before`.
    #[inline(always)]
    pub(super) fn put_after(&mut self, e: u32, before: u32, origin: u32) {
        let next = self.halves[before as usize][NEXT];
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
        self.halves[first as usize][NEXT] = self.removed;
        self.removed = first;
    }

    /// Forgets the side of the outline: halves with nothing on their left are as if not in use. `out` is an edge of the
    /// hull, anticlockwise. To be done once, at the end: rings are broken by it.
    pub(super) fn drop_outside(&mut self, out: u32) {
        let mut e = out;
        loop {
            let back = e ^ 1;
            e = self.halves[back as usize][NEXT];
            self.halves[back as usize][PREV] = NONE;
            if e == out {
                break;
            }
        }
    }

    /// The triangles, each from its corner of least name. Presumes [`drop_outside`](Self::drop_outside).
    pub(super) fn triangles(&self, most: usize, name: impl Fn(u32) -> u32) -> Vec<[u32; 3]> {
        // An edge can be the first one of one triangle only, on the left of its half with the lesser origin. Written down
        // for every edge, and over again if it is not: cheaper than branches that nothing could predict.
        let mut triangles = vec![[0; 3]; most + 1];
        let mut found = 0;
        for edge in self.halves[..self.fresh as usize].as_chunks::<2>().0 {
            let (there, back) = (edge[0], edge[1]);
            if there[PREV] == NONE && back[PREV] == NONE {
                continue;
            }
            let (a, b) = (name(there[ORIGIN]), name(back[ORIGIN]));
            let half = if a < b { there } else { back };
            let (from, to) = (a.min(b), a.max(b));
            let apex = name(self.target(half[NEXT]));
            triangles[found] = [from, to, apex];
            found += usize::from((half[PREV] != NONE) & (from < apex));
        }
        triangles.truncate(found);
        triangles
    }
}
