//! What the algorithm asks, for the upper and for the lower hull.

use super::chain::Place;
use super::sorted::Sorted;
use crate::monotone_chain::keeps;
use geometry_core::{Boundary, Kernel2, Observer, Point2, Sign, Step};

/// Which half of the hull a tree keeps.
pub(super) trait Side {
    /// The turn at b from a to c, which lie in lexicographic order: positive at a corner of this half.
    fn turn<K: Kernel2>(kernel: &K, a: Point2, b: Point2, c: Point2) -> Sign;
}

/// The half below, which is walked anticlockwise from left to right.
pub(super) struct Lower;

/// The half above, which is walked anticlockwise from right to left.
pub(super) struct Upper;

impl Side for Lower {
    #[inline(always)]
    fn turn<K: Kernel2>(kernel: &K, a: Point2, b: Point2, c: Point2) -> Sign {
        kernel.orient(a, b, c)
    }
}

impl Side for Upper {
    #[inline(always)]
    fn turn<K: Kernel2>(kernel: &K, a: Point2, b: Point2, c: Point2) -> Sign {
        kernel.orient(c, b, a)
    }
}

/// The points, who answers questions about them, and who listens.
pub(super) struct Context<'a, K, O> {
    pub(super) sorted: &'a Sorted,
    pub(super) boundary: Boundary,
    pub(super) kernel: &'a K,
    pub(super) observer: &'a mut O,
}

impl<K: Kernel2, O: Observer> Context<'_, K, O> {
    /// Whether b is a vertex between a on its left and c on its right.
    #[inline(always)]
    pub(super) fn keeps<S: Side>(&mut self, a: Place, b: Place, c: Place) -> bool {
        let ids = &self.sorted.ids;
        self.observer.step(|| Step::Candidate(ids[b as usize]));
        let [a, b, c] = [a, b, c].map(|place| self.sorted.points[place as usize]);
        keeps(self.boundary, S::turn(self.kernel, a, b, c))
    }

    /// Tells of the bridge from l to r.
    #[inline(always)]
    pub(super) fn bridged(&mut self, l: Place, r: Place) {
        let ids = &self.sorted.ids;
        self.observer
            .step(|| Step::Bridge(ids[l as usize], ids[r as usize]));
    }
}
