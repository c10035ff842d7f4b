//! The partition: points are dealt to the facets of a new cone, up to [`LANES`] at a time.
//!
//! All of it is compiled for each width of vectors that the machine may have, and is the same arithmetic in each.

use super::fan::{Fan, LANES};
use super::lists::{Links, List, NIL};
use super::plane::{Plane, Side, Span};
use crate::pending::Pending;
use geometry_core::mesh::{TriMesh, TriangleId};
use geometry_core::{Kernel3, Observer, Point3, Points, Step};
use pulp::{Simd, WithSimd};

/// What is dealt, to which facets, and where that is noted. Its output is the first point of the list of those not outside of any.
pub(super) struct Deal<'b, 'a, K, O> {
    /// The points to be dealt are the list that begins with this one.
    pub(super) first: u32,
    /// Facets side by side about the apex, new and without a plane or a list.
    pub(super) facets: &'b [TriangleId],
    pub(super) apex: Point3,
    /// The corners over whose edges the facets are, one more than these.
    pub(super) rim: &'b [Point3; LANES + 1],
    pub(super) points: Points<'a, 3>,
    pub(super) span: &'b Span,
    pub(super) kernel: &'b K,
    pub(super) observer: &'b mut O,
    pub(super) mesh: &'b TriMesh,
    pub(super) planes: &'b mut [Plane],
    pub(super) outside: &'b mut [List],
    pub(super) links: &'b mut Links,
    pub(super) pending: &'b mut Pending,
}

impl<K: Kernel3, O: Observer> WithSimd for Deal<'_, '_, K, O> {
    type Output = u32;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> u32 {
        let (facets, points) = (self.facets, self.points);
        let mut fan = Fan::about(self.apex);
        for (&facet, edge) in facets.iter().zip(self.rim.windows(2)) {
            let plane = Plane::through([self.apex, edge[0], edge[1]], self.span);
            fan.push(&plane);
            self.planes[facet.0 as usize] = plane;
        }
        if self.first == NIL {
            return NIL;
        }
        let mut hands = self.links.hands();
        self.links.deal(self.first, &mut hands, |id| {
            facets
                .iter()
                .for_each(|_| self.observer.step(|| Step::Visit(id)));
            let p = &points.as_slice()[id as usize];
            fan.first_outside(simd, p).unwrap_or_else(|| {
                first_exactly(facets, |facet| {
                    let plane = &self.planes[facet.0 as usize];
                    match plane.side(plane.height(*p)) {
                        Side::Outside => true,
                        Side::Within => false,
                        Side::Unsure => {
                            is_outside(points, self.kernel, self.mesh.corners(facet), *p)
                        }
                    }
                })
            })
        });
        for (lane, &facet) in facets.iter().enumerate() {
            let list = self.links.closed(&hands, lane);
            self.outside[facet.0 as usize] = list;
            if list.first != NIL {
                self.pending.put_off(facet);
            }
        }
        self.links.closed(&hands, LANES).first
    }
}

/// The lane of the first facet that a point is outside of, or [`LANES`], where that was not sure.
#[cold]
#[inline(never)]
fn first_exactly(facets: &[TriangleId], is_outside: impl Fn(TriangleId) -> bool) -> usize {
    let first = facets.iter().position(|&facet| is_outside(facet));
    first.unwrap_or(LANES)
}

/// Whether the kernel finds p outside the facet with these corners. A corner is not, and its copies are common.
pub(super) fn is_outside<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    corners: [u32; 3],
    p: Point3,
) -> bool {
    let [a, b, c] = corners.map(|id| points[id]);
    p != a && p != b && p != c && kernel.orient3(a, b, c, p).is_positive()
}
