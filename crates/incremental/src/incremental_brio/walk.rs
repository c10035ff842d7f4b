//! The walk to the facet over which a point is, seen from a vertex.

use super::Surface;
use geometry_core::mesh::TriangleId;
use geometry_core::{HullError, Kernel3, Observer, Sign, Step};

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Outside: it sees this facet.
    Sees(TriangleId),
    /// In the hull, behind this facet as seen from the eye, or a copy of one of its corners.
    Behind(TriangleId),
}

impl<K: Kernel3, O: Observer> Surface<'_, K, O> {
    /// Walks from the latest facet to one that the point `p` sees, or to the one that covers it.
    pub(super) fn locate(&mut self, p: u32) -> Result<Place, HullError> {
        let mut facet = self.latest;
        // Each step leads to a facet further on (invariant 3), so there are no more steps than facets.
        for _ in 0..self.mesh.slots() {
            if self.sees(p, facet) {
                return Ok(Place::Sees(facet));
            }
            let Some(next) = self.step_towards(p, facet) else {
                return Ok(Place::Behind(facet));
            };
            facet = next;
        }
        Err(HullError::Contradiction {
            what: "a walk to a point goes in circles",
        })
    }

    /// The neighbour of `facet`, which `p` does not see, beyond a plane through the eye and an edge; `None` if `p` is
    /// behind the facet.
    #[inline(always)]
    fn step_towards(&mut self, p: u32, facet: TriangleId) -> Option<TriangleId> {
        let [a, b, c] = self.mesh.corners(facet);
        let twins = self.mesh.twins(facet);
        if let Some(eye) = [a, b, c].iter().position(|&corner| corner == EYE) {
            return Some(twins[(eye + 1) % 3].triangle());
        }
        for ((from, to), twin) in [(a, b), (b, c), (c, a)].into_iter().zip(twins) {
            if self.is_across(p, from, to) {
                return Some(twin.triangle());
            }
        }
        None
    }

    /// Whether `p` is on the right of the edge as seen from outside, from the plane through it and the eye.
    #[inline(always)]
    fn is_across(&mut self, p: u32, from: u32, to: u32) -> bool {
        let names = &self.names;
        self.observer
            .step(|| Step::Line(names[from as usize], names[to as usize]));
        let [p, a, b, eye] = [p, from, to, EYE].map(|id| self.points[id]);
        self.kernel.orient3(p, b, a, eye) == Sign::Negative
    }
}

/// The vertex from which all is seen: the first.
const EYE: u32 = 0;
