//! What a point sees, and the cone over its rim.
//!
//! The facets seen are found by depth-first search from one of them. A facet is left by its sides in order, entered by
//! one, and left by the two others in order, so that the sides at which the search turns back come in order round the
//! rim:
//!
//! ```text
//!            z
//!          /   \         entered by x -> y, the search goes on over y -> z, then z -> x, in
//!         /     \        place of the side y -> x of the facet it came from
//!        x ----- y
//! ```
//!
//! A side between two facets that are both seen but that the search did not cross is met from both, and dropped: the
//! region is a disc, so what is between the two meetings has been closed.

use super::Surface;
use geometry_core::mesh::{SideId, TriangleId};
use geometry_core::{HullError, Kernel3, Observer, Step};

/// What a walk knows of the facet that it came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Known {
    /// The walk began where it ended.
    Nothing,
    /// The point does not see it.
    NotSeen,
}

/// Storage for one insertion, kept for the next.
#[derive(Debug, Default)]
pub(super) struct Region {
    /// Sides of facets that the search has not reached, which border facets that are seen; and whether they are seen.
    ahead: Vec<(SideId, bool)>,
    /// The facets seen, taken out of the surface.
    seen: Vec<TriangleId>,
    /// The sides beyond the rim, in order round it.
    rim: Vec<SideId>,
}

impl<K: Kernel3, O: Observer> Surface<'_, K, O> {
    /// Step 3: replaces what `p` sees, the facet of the side `seen` among it, by the cone from `p`. Of the facet at the
    /// twin of `seen` it may be known that `p` does not see it.
    pub(super) fn insert(
        &mut self,
        p: u32,
        seen: SideId,
        behind: Known,
        region: &mut Region,
    ) -> Result<(), HullError> {
        region.rim.clear();
        region.seen.clear();
        let facet = seen.triangle();
        let [first, second, third] =
            [seen, seen.next(), seen.previous()].map(|side| self.mesh.twin(side));
        // Neighbours are looked at together, before any is branched on: the processor computes them side by side.
        let [second, third] = [second, third].map(|side| (side, self.sees(p, side.triangle())));
        let first = match behind {
            Known::NotSeen => (first, false),
            Known::Nothing => (first, self.sees(p, first.triangle())),
        };
        region.ahead.extend([third, second, first]);
        self.take_out(facet, &mut region.seen);
        while let Some((side, is_seen)) = region.ahead.pop() {
            let facet = side.triangle();
            if !is_seen {
                region.rim.push(side);
            } else if self.mesh.is_alive(facet) {
                let beyond = [side.previous(), side.next()].map(|side| self.mesh.twin(side));
                let [second, first] = beyond.map(|side| self.look_at(p, side));
                region.ahead.extend(second);
                region.ahead.extend(first);
                self.take_out(facet, &mut region.seen);
            }
        }
        let made = self.mesh.replace(&mut region.seen, &region.rim, p);
        made.ok_or(HullError::Contradiction {
            what: "the facets that a point sees are not one region with one rim",
        })?;
        self.latest = self.towards_next(p, &region.rim);
        let names = &self.names;
        self.observer.step(|| Step::Insert(names[p as usize]));
        for &side in &region.rim {
            let corners = [self.mesh.target(side), self.mesh.origin(side), p];
            self.observer.step(|| {
                let [a, b, c] = corners.map(|id| names[id as usize]);
                Step::Facet(a, b, c)
            });
        }
        Ok(())
    }

    /// The facet of the cone just made whose two corners on the rim are nearest to the point after `p`, where its walk begins.
    fn towards_next(&self, p: u32, rim: &[SideId]) -> TriangleId {
        let next = self.points.as_slice().get(p as usize + 1);
        let next = *next.unwrap_or(&self.points[p]);
        let distance = |id: u32| {
            let [x, y, z] = [0, 1, 2].map(|i| self.points[id][i] - next[i]);
            x * x + y * y + z * z
        };
        let mut nearest = rim[0];
        let mut least = f64::INFINITY;
        let mut before = distance(self.mesh.target(rim[0]));
        for &side in rim {
            let after = distance(self.mesh.origin(side));
            let both = before + after;
            nearest = if both < least { side } else { nearest };
            least = if both < least { both } else { least };
            before = after;
        }
        self.mesh.twin(nearest).triangle()
    }

    /// Whether the facet of `side` is seen, or `None` if it has been taken out already.
    #[inline(always)]
    fn look_at(&mut self, p: u32, side: SideId) -> Option<(SideId, bool)> {
        let facet = side.triangle();
        self.mesh
            .is_alive(facet)
            .then(|| (side, self.sees(p, facet)))
    }

    fn take_out(&mut self, facet: TriangleId, seen: &mut Vec<TriangleId>) {
        let [a, b, c] = self.mesh.corners(facet);
        let names = &self.names;
        self.observer
            .step(|| Step::Drop(names[a as usize], names[b as usize], names[c as usize]));
        self.mesh.take_out(facet);
        seen.push(facet);
    }
}
