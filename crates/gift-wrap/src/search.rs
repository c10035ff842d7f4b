//! The search for the next vertex, common to the methods of this family.
//!
//! Standing at a vertex `from` of the hull, the next one anticlockwise is the point that leaves no other on its
//! right. A search holds the best candidate so far and replaces it by every point found to its right:
//!
//! ```text
//!                  .  best so far
//!                .'
//!     from     .'        p lies to the right of from -> best: p is better
//!         *  .' . . . . . . . p
//!        /
//!       / before
//! ```
//!
//! Where `from`, the best and p are collinear (a *tie*):
//!
//! - copies of `from` are never taken;
//! - of two points on opposite sides of `from`, the one ahead wins: the other lies back along an edge with several
//!   points on it, of which `from` is one;
//! - of two points in the same direction, [`Boundary::Extreme`] takes the further, so that the next vertex is a
//!   corner, and [`Boundary::All`] the nearer, so that no boundary point is left out;
//! - of copies, the one with the smallest index.

use geometry_core::{Boundary, HullError, Kernel2, Observer, Points, Sign, Step};
use std::cmp::Ordering;

/// A search for next vertices.
pub(crate) struct Search<'a, K> {
    pub(crate) points: Points<'a, 2>,
    pub(crate) boundary: Boundary,
    pub(crate) kernel: &'a K,
}

impl<K: Kernel2> Search<'_, K> {
    /// The vertex after the last of `walk` among `candidates`, with its place among them; `None` if all candidates
    /// are copies of that last vertex.
    ///
    /// Asks one orientation a candidate after the first.
    pub(crate) fn next_vertex<O: Observer>(
        &self,
        walk: &[u32],
        candidates: impl Iterator<Item = u32>,
        observer: &mut O,
    ) -> Option<(usize, u32)> {
        let (&from, before) = walk.split_last()?;
        let before = before.last().copied();
        let mut candidates = (0..).zip(candidates);
        let mut best = candidates.find(|&(_, id)| {
            observer.step(|| Step::Visit(id));
            !self.are_copies(from, id)
        })?;
        observer.step(|| Step::Apex(best.1));
        for (place, id) in candidates {
            observer.step(|| Step::Visit(id));
            if self.is_better(before, from, best.1, id) {
                observer.step(|| Step::Apex(id));
                best = (place, id);
            }
        }
        Some(best)
    }

    fn are_copies(&self, a: u32, b: u32) -> bool {
        self.kernel.lexicographic(self.points[a], self.points[b]) == Ordering::Equal
    }

    fn is_better(&self, before: Option<u32>, from: u32, best: u32, id: u32) -> bool {
        let [v, b, p] = [from, best, id].map(|id| self.points[id]);
        match self.kernel.orient(v, b, p) {
            Sign::Negative => true,
            Sign::Positive => false,
            Sign::Zero => self.wins_tie(before, from, best, id),
        }
    }

    /// Whether `id` is better than `best`, `from` being collinear with both and no copy of `best`.
    fn wins_tie(&self, before: Option<u32>, from: u32, best: u32, id: u32) -> bool {
        let [v, b, p] = [from, best, id].map(|id| self.points[id]);
        match self.kernel.compare_along(v, b, v, p) {
            Ordering::Equal => false,
            Ordering::Greater => before.is_some_and(|before| {
                let start = self.points[before];
                self.kernel.compare_along(start, v, v, p) == Ordering::Less
            }),
            Ordering::Less => match (self.kernel.compare_along(v, b, b, p), self.boundary) {
                (Ordering::Equal, _) => id < best,
                (order, Boundary::Extreme) => order == Ordering::Less,
                (order, Boundary::All) => order == Ordering::Greater,
            },
        }
    }
}

/// What a step to the next vertex means for the walk so far.
pub(crate) enum Arrival {
    /// At a vertex not met before: the walk goes on from there.
    New,
    /// Back at the first vertex: the walk is the hull.
    Closed,
    /// Back at the vertex before the last. A walk turns round only if all points are collinear; it then went
    /// along them from end to end.
    TurnedBack,
}

/// Where `walk`, which is not empty, arrives by stepping to `next`.
///
/// # Errors
///
/// [`HullError::Contradiction`] if `next` is any other vertex of the walk. So a walk has at most n vertices,
/// whatever the kernel answers.
pub(crate) fn arrive(walk: &[u32], next: u32) -> Result<Arrival, HullError> {
    if next == walk[0] {
        Ok(Arrival::Closed)
    } else if walk.len() > 1 && next == walk[walk.len() - 2] {
        Ok(Arrival::TurnedBack)
    } else if walk.contains(&next) {
        Err(HullError::Contradiction {
            what: "the walk round the hull meets a vertex again that is not the first",
        })
    } else {
        Ok(Arrival::New)
    }
}

/// The lexicographically smallest point, of copies the one with the smallest index; `None` of no points.
pub(crate) fn leftmost<K: Kernel2>(points: Points<'_, 2>, kernel: &K) -> Option<u32> {
    points.ids().reduce(
        |first, id| match kernel.lexicographic(points[id], points[first]) {
            Ordering::Less => id,
            _ => first,
        },
    )
}
