//! The walk to a facet that a point sees, or to the one that covers it.

use super::{EYE, Surface};
use geometry_core::mesh::{SideId, TriangleId};
use geometry_core::{HullError, Kernel3, Observer, Step};

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Outside: it sees this facet.
    SeenFacet(TriangleId),
    /// In the hull: in the cone of the eye over this facet, which it does not see.
    CoveredBy(TriangleId),
}

impl<K: Kernel3, O: Observer> Surface<'_, K, O> {
    /// Step 2: walks from the latest facet to where the point `p` is.
    pub(super) fn locate(&mut self, p: u32) -> Result<Place, HullError> {
        let mut facet = self.latest;
        // The side by which the facet was entered: the point is on this side of it.
        let mut entered = None;
        // No facet comes twice (invariant 3).
        for _ in 0..self.mesh.slots() {
            if self.sees(p, facet) {
                return Ok(Place::SeenFacet(facet));
            }
            let Some(next) = self.side_towards(p, facet, entered) else {
                return Ok(Place::CoveredBy(facet));
            };
            facet = next.triangle();
            entered = Some(next);
        }
        Err(HullError::Contradiction {
            what: "a walk to a point goes in circles",
        })
    }

    /// The side, of a neighbour of `facet`, that is next on the way to `p`, which does not see the facet; `None` if the
    /// facet covers `p`.
    #[inline(always)]
    fn side_towards(
        &mut self,
        p: u32,
        facet: TriangleId,
        entered: Option<SideId>,
    ) -> Option<SideId> {
        let corners = self.mesh.corners(facet);
        if let Some(eye) = corners.iter().position(|&corner| corner == EYE) {
            // A facet at the eye, met only at the start.
            return Some(self.mesh.twins(facet)[(eye + 1) % 3]);
        }
        let sides = match entered {
            Some(side) => [Some(side.next()), Some(side.previous()), None],
            None => facet.sides().map(Some),
        };
        let mut sides = sides.into_iter().flatten();
        let next = sides.find(|&side| self.is_beyond(p, side))?;
        Some(self.mesh.twin(next))
    }

    /// Whether `p` is beyond the plane through the eye and a side.
    #[inline(always)]
    fn is_beyond(&mut self, p: u32, side: SideId) -> bool {
        let [from, to] = [self.mesh.origin(side), self.mesh.target(side)];
        let names = &self.names;
        self.observer
            .step(|| Step::Line(names[from as usize], names[to as usize]));
        let [p, a, b, eye] = [p, from, to, EYE].map(|id| self.points[id]);
        self.kernel.orient3(p, eye, b, a).is_negative()
    }
}
