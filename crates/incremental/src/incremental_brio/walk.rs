//! The walk to a facet that a point sees, or to the one that covers it.

use super::region::Known;
use super::{EYE, Surface};
use geometry_core::mesh::{SideId, TriangleId};
use geometry_core::{HullError, Kernel3, Observer, Step};

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Outside: it sees the facet of this side, by which the walk entered if something is known of the one behind.
    Outside(SideId, Known),
    /// In the hull: in the cone of the eye over this facet, which it does not see.
    CoveredBy(TriangleId),
}

impl<K: Kernel3, O: Observer> Surface<'_, K, O> {
    /// Step 2: walks from the latest facet to where the point `p` is.
    pub(super) fn locate(&mut self, p: u32) -> Result<Place, HullError> {
        let facet = self.latest;
        if self.sees(p, facet) {
            return Ok(Place::Outside(facet.side(0), Known::Nothing));
        }
        let Some(mut side) = self.first_towards(p, facet) else {
            return Ok(Place::CoveredBy(facet));
        };
        // No facet comes twice (invariant 3).
        for _ in 0..self.mesh.slots() {
            if self.sees(p, side.triangle()) {
                return Ok(Place::Outside(side, Known::NotSeen));
            }
            // The point is on this side of the side by which the walk came.
            side = if self.is_beyond(p, side.next()) {
                self.mesh.twin(side.next())
            } else if self.is_beyond(p, side.previous()) {
                self.mesh.twin(side.previous())
            } else {
                return Ok(Place::CoveredBy(side.triangle()));
            };
        }
        Err(HullError::Contradiction {
            what: "a walk to a point goes in circles",
        })
    }

    /// The first side on the way from `facet`, which `p` does not see; `None` if it covers `p`.
    #[inline(always)]
    fn first_towards(&mut self, p: u32, facet: TriangleId) -> Option<SideId> {
        let corners = self.mesh.corners(facet);
        let sides = facet.sides();
        if let Some(eye) = corners.iter().position(|&corner| corner == EYE) {
            return Some(self.mesh.twin(sides[(eye + 1) % 3]));
        }
        let side = sides.into_iter().find(|&side| self.is_beyond(p, side))?;
        Some(self.mesh.twin(side))
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
