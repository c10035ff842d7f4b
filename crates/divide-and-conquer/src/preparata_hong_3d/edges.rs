//! The edge records: an arena of edges, each with a record for either end.
//!
//! Day's `edge` points to two `vertexinfo` records, each with a vertex and the next edges round it, so that turning an
//! edge about (`rev_edge`) swaps two pointers. Here the two records of edge e are numbers 2e and 2e + 1 of one array,
//! and turning it about flips the last bit. A number names the edge directed away from one end: a [`Dart`].
//!
//! ```text
//!            left(d)   face on the left
//!               \     of d
//!                \
//!     origin(d)   o ─────── d ───────► o   target(d) = origin(d.reversed())
//!                /
//!               /     next_on_face(d.reversed())
//!            right(d)       = right(d)
//! ```
//!
//! Invariants, outside of a change to the links:
//!
//! 1. `left(right(d)) == d`, and the darts met by turning right from d all round are those with its origin.
//! 2. No living edge is linked to a freed one. Freed records are used again before new ones are made.

/// No place, no dart.
pub(crate) const NONE: u32 = u32::MAX;

/// An edge directed away from one of its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Dart(pub(crate) u32);

impl Dart {
    /// The same edge directed away from its other end.
    #[inline(always)]
    pub(crate) fn reversed(self) -> Self {
        Dart(self.0 ^ 1)
    }
}

/// One of the two hulls of a merge. Seen from outside, with the first hull up and the second down, the wrap runs to
/// the left; the edges of the first are then met clockwise round each vertex, those of the second anticlockwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Half {
    /// The one that comes first in the sorted order.
    First = 0,
    /// The other.
    Second = 1,
}

impl Half {
    pub(crate) const BOTH: [Half; 2] = [Half::First, Half::Second];

    /// The end of `bridge`, an edge directed from the first half to the second, that lies in this half.
    #[inline(always)]
    pub(crate) fn end_of(self, bridge: Dart) -> Dart {
        Dart(bridge.0 ^ self as u32)
    }
}

/// One end of an edge.
#[derive(Clone, Copy, Debug)]
struct End {
    /// The place of the vertex; [`NONE`] if the record is free.
    origin: u32,
    /// The next dart round the origin, anticlockwise seen from outside.
    left: u32,
    /// The next dart round the origin, clockwise.
    right: u32,
    /// What the merge of this number has noted; see [`Note`].
    stamp: u32,
}

/// What a merge notes about a dart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Note {
    /// The scan at its origin went past it.
    Passed = 0,
    /// The wrap took it as an edge of a new facet.
    Taken = 1,
    /// It is inside the merged hull.
    Hidden = 2,
}

/// The edges of all hulls under construction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Edges {
    ends: Vec<End>,
    /// The even darts of freed records.
    free: Vec<u32>,
}

impl Edges {
    pub(crate) fn with_capacity(edges: usize) -> Self {
        Self {
            ends: Vec::with_capacity(2 * edges),
            free: Vec::new(),
        }
    }

    /// A new edge, alone at both its ends.
    pub(crate) fn make(&mut self, from: u32, to: u32) -> Dart {
        let dart = self.free.pop().unwrap_or_else(|| {
            let unset = End {
                origin: NONE,
                left: NONE,
                right: NONE,
                stamp: NONE,
            };
            self.ends.extend([unset; 2]);
            self.ends.len() as u32 - 2
        });
        for (dart, origin) in [(dart, from), (dart + 1, to)] {
            self.ends[dart as usize] = End {
                origin,
                left: dart,
                right: dart,
                stamp: NONE,
            };
        }
        Dart(dart)
    }

    /// Gives the record back. Its neighbours must be freed or linked anew.
    pub(crate) fn free(&mut self, dart: Dart) {
        let even = dart.0 & !1;
        self.ends[even as usize].origin = NONE;
        self.ends[even as usize + 1].origin = NONE;
        self.free.push(even);
    }

    #[inline(always)]
    fn end(&self, dart: Dart) -> &End {
        &self.ends[dart.0 as usize]
    }

    /// The place it is directed away from.
    #[inline(always)]
    pub(crate) fn origin(&self, dart: Dart) -> u32 {
        self.end(dart).origin
    }

    /// The place it is directed to.
    #[inline(always)]
    pub(crate) fn target(&self, dart: Dart) -> u32 {
        self.origin(dart.reversed())
    }

    /// The next dart round the origin in the direction in which a wrap scans this half.
    #[inline(always)]
    pub(crate) fn onward(&self, half: Half, dart: Dart) -> Dart {
        let end = self.end(dart);
        Dart(match half {
            Half::First => end.right,
            Half::Second => end.left,
        })
    }

    /// Makes `next` the dart after `dart` in the direction in which a wrap scans this half.
    #[inline(always)]
    pub(crate) fn link(&mut self, half: Half, dart: Dart, next: Dart) {
        let (to_left, to_right) = match half {
            Half::First => (next, dart),
            Half::Second => (dart, next),
        };
        self.ends[to_right.0 as usize].right = to_left.0;
        self.ends[to_left.0 as usize].left = to_right.0;
    }

    /// The dart after `dart` round the face on its left, anticlockwise.
    #[inline(always)]
    pub(crate) fn next_on_face(&self, dart: Dart) -> Dart {
        self.onward(Half::First, dart.reversed())
    }

    /// The darts of the face on the left of `dart`, if it is a triangle.
    pub(crate) fn triangle(&self, dart: Dart) -> Option<[Dart; 3]> {
        let second = self.next_on_face(dart);
        let third = self.next_on_face(second);
        (third != dart && self.next_on_face(third) == dart).then_some([dart, second, third])
    }

    #[inline(always)]
    pub(crate) fn note(&mut self, merge: u32, dart: Dart, note: Note) {
        self.ends[dart.0 as usize].stamp = merge << 2 | note as u32;
    }

    #[inline(always)]
    pub(crate) fn is_noted(&self, merge: u32, dart: Dart, note: Note) -> bool {
        self.end(dart).stamp == merge << 2 | note as u32
    }

    /// How many edges there are.
    pub(crate) fn live(&self) -> usize {
        self.records() - self.free.len()
    }

    /// How many records were ever made: the most edges there have been at once.
    pub(crate) fn records(&self) -> usize {
        self.ends.len() / 2
    }

    /// The darts of all edges, by number.
    pub(crate) fn darts(&self) -> impl Iterator<Item = Dart> + '_ {
        let all = 0..self.ends.len() as u32;
        all.map(Dart).filter(|&dart| self.end(dart).origin != NONE)
    }

    /// Takes in the edges of hulls whose places are numbered from `places` on; returns what to add to their darts.
    pub(crate) fn absorb(&mut self, other: &Edges, places: u32) -> u32 {
        let shift = self.ends.len() as u32;
        self.ends.extend(other.ends.iter().map(|end| End {
            origin: if end.origin == NONE {
                NONE
            } else {
                end.origin + places
            },
            left: end.left + shift,
            right: end.right + shift,
            stamp: NONE,
        }));
        self.free.extend(other.free.iter().map(|even| even + shift));
        shift
    }
}
