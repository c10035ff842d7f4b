//! The edges of a planar triangulation, in rings around their vertices.

/// No edge.
pub(super) const NONE: u32 = u32::MAX;

/// An edge seen from one end. The two halves of an edge are neighbours in memory: `e ^ 1` is the other one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Half {
    /// The next half with the same origin, anticlockwise.
    next: u32,
    /// The previous one; [`NONE`] for halves that are not in use.
    prev: u32,
    /// Where it starts.
    origin: u32,
}

impl Half {
    pub(super) const UNUSED: Self = Self {
        next: NONE,
        prev: NONE,
        origin: NONE,
    };
}

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
        self.halves[e as usize].next
    }

    #[inline(always)]
    pub(super) fn prev(&self, e: u32) -> u32 {
        self.halves[e as usize].prev
    }

    #[inline(always)]
    pub(super) fn origin(&self, e: u32) -> u32 {
        self.halves[e as usize].origin
    }

    #[inline(always)]
    pub(super) fn target(&self, e: u32) -> u32 {
        self.halves[(e ^ 1) as usize].origin
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
            self.removed = self.halves[e as usize].next;
            e
        }
    }

    /// Makes `e` the only half around `origin`.
    #[inline(always)]
    pub(super) fn put_alone(&mut self, e: u32, origin: u32) {
        self.halves[e as usize] = Half {
            next: e,
            prev: e,
            origin,
        };
    }

    /// Puts `e` into the ring around `origin`, just clockwise of `after`.
    #[inline(always)]
    pub(super) fn put_before(&mut self, e: u32, after: u32, origin: u32) {
        let prev = self.halves[after as usize].prev;
        self.halves[e as usize] = Half {
            next: after,
            prev,
            origin,
        };
        self.halves[after as usize].prev = e;
        self.halves[prev as usize].next = e;
    }

    /// Puts `e` into the ring around `origin`, just anticlockwise of `before`.
    #[inline(always)]
    pub(super) fn put_after(&mut self, e: u32, before: u32, origin: u32) {
        let next = self.halves[before as usize].next;
        self.halves[e as usize] = Half {
            next,
            prev: before,
            origin,
        };
        self.halves[before as usize].next = e;
        self.halves[next as usize].prev = e;
    }

    /// Takes an edge out of both its rings.
    #[inline(always)]
    pub(super) fn remove(&mut self, e: u32) {
        for half in [e, e ^ 1] {
            let Half { next, prev, .. } = self.halves[half as usize];
            self.halves[prev as usize].next = next;
            self.halves[next as usize].prev = prev;
            self.halves[half as usize].prev = NONE;
        }
        let first = e & !1;
        self.halves[first as usize].next = self.removed;
        self.removed = first;
    }

    /// Forgets the side of the outline: halves with nothing on their left are as if not in use. `out` is an edge of the
    /// hull, anticlockwise. To be done once, at the end: rings are broken by it.
    pub(super) fn drop_outside(&mut self, out: u32) {
        let mut e = out;
        loop {
            let back = e ^ 1;
            e = self.halves[back as usize].next;
            self.halves[back as usize].prev = NONE;
            if e == out {
                break;
            }
        }
    }

    /// The triangles, each once: where its corner of least name is the origin. Presumes `drop_outside`.
    pub(super) fn triangles(&self, name: impl Fn(u32) -> u32, mut found: impl FnMut([u32; 3])) {
        for pair in self.halves[..self.fresh as usize].as_chunks::<2>().0 {
            let names = [
                name_of(&name, pair[0].origin),
                name_of(&name, pair[1].origin),
            ];
            let _ = names;
            for (half, from, to) in [(&pair[0], 0, 1), (&pair[1], 1, 0)] {
                if half.prev == NONE {
                    continue;
                }
                if names[from] < names[to] {
                    let apex = name(self.target(half.next));
                    if names[from] < apex {
                        found([names[from], names[to], apex]);
                    }
                }
            }
        }
    }
}

#[inline(always)]
fn name_of(name: &impl Fn(u32) -> u32, vertex: u32) -> u32 {
    if vertex == NONE { NONE } else { name(vertex) }
}
