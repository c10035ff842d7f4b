//! Pieces of hulls as doubly linked lists of places.

/// A place in the lexicographic order of the points, from 1. Place 0 is no point.
pub(super) type Place = u32;

/// No point: the neighbour of an end, the ends of an empty chain.
pub(super) const NONE: Place = 0;

/// Which way along the x axis. A chain, a bridge and a pair of links are indexed by it.
pub(super) const LEFT: usize = 0;
/// The other way.
pub(super) const RIGHT: usize = 1;

/// The first and the last point of a piece of a hull; [`EMPTY`] if there is none.
pub(super) type Chain = [Place; 2];

/// The chain of no points.
pub(super) const EMPTY: Chain = [NONE; 2];

/// The neighbours of each point on the largest hull it lies on.
pub(super) struct Links(Vec<[Place; 2]>);

impl Links {
    /// Links for places up to `last`.
    pub(super) fn new(last: usize) -> Self {
        Self(vec![EMPTY; last + 1])
    }

    /// The neighbour of `place` in direction `way`.
    #[inline(always)]
    pub(super) fn next(&self, place: Place, way: usize) -> Place {
        self.0[place as usize][way]
    }

    /// Makes `neighbour` the neighbour of `place` in direction `way`.
    #[inline(always)]
    pub(super) fn set(&mut self, place: Place, way: usize, neighbour: Place) {
        self.0[place as usize][way] = neighbour;
    }

    /// The chain that starts with `first` and goes on with `second`, which lies to its right.
    #[inline(always)]
    pub(super) fn join(&mut self, first: Chain, second: Chain) -> Chain {
        if first == EMPTY {
            return second;
        }
        if second == EMPTY {
            return first;
        }
        self.set(first[RIGHT], RIGHT, second[LEFT]);
        self.set(second[LEFT], LEFT, first[RIGHT]);
        [first[LEFT], second[RIGHT]]
    }

    /// [`join`](Self::join) of `near` and `far`, where `far` lies in direction `way` of `near`.
    #[inline(always)]
    pub(super) fn join_towards(&mut self, way: usize, near: Chain, far: Chain) -> Chain {
        if way == RIGHT {
            self.join(near, far)
        } else {
            self.join(far, near)
        }
    }
}
