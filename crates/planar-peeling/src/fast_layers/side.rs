//! What the algorithm asks, for the upper and for the lower hull.

use super::chain::Place;
use super::sorted::Entry;
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
    /// By place; that at place 0 stands for no point.
    pub(super) entries: Vec<Entry>,
    /// The least turn that makes a vertex.
    pub(super) least: Sign,
    pub(super) kernel: &'a K,
    pub(super) observer: &'a mut O,
    /// Room for the hull of a leaf.
    pub(super) arc: Vec<Place>,
}

impl<'a, K: Kernel2, O: Observer> Context<'a, K, O> {
    /// No points yet.
    pub(super) fn new(boundary: Boundary, kernel: &'a K, observer: &'a mut O) -> Self {
        let least = match boundary {
            Boundary::Extreme => Sign::Positive,
            Boundary::All => Sign::Zero,
        };
        Self {
            entries: vec![Entry::default()],
            least,
            kernel,
            observer,
            arc: Vec::new(),
        }
    }

    /// The coordinates of the point at `place`.
    #[inline(always)]
    pub(super) fn point(&self, place: Place) -> Point2 {
        self.entries[place as usize].point
    }

    /// Whether b is a vertex between a on its left and c on its right.
    #[inline(always)]
    pub(super) fn keeps<S: Side>(&self, a: Point2, b: Point2, c: Point2) -> bool {
        S::turn(self.kernel, a, b, c) >= self.least
    }

    /// Tells of the bridge from l to r.
    #[inline(always)]
    pub(super) fn bridged(&mut self, l: Place, r: Place) {
        let id = |place: Place| self.entries[place as usize].id;
        self.observer.step(|| Step::Bridge(id(l), id(r)));
    }
}
