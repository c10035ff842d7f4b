//! The certificate: a claimed hull is proved to be the hull, or what is wrong with it is listed.
//!
//! # The argument, for a hull
//!
//! Let v₀ … v₍ₕ₋₁₎ be the claimed vertices.
//!
//! 1. Every id names a point of the set, and no two vertices are equal.
//! 2. Every three consecutive vertices turn left (under [`Boundary::All`] they may also run straight on, never
//!    back).
//! 3. In the lexicographic order the cycle has one local maximum only. By 2 the direction of the edges only
//!    ever turns anticlockwise, by less than half a turn at a time, and each full revolution passes one local
//!    maximum; so it turns once round, and the polygon is simple and convex. A star that turns twice fails
//!    here.
//! 4. v₀ is the lexicographic minimum, so the cycle splits into a lower chain that ascends and an upper chain
//!    that descends.
//! 5. Every point lies above or on the lower chain and below or on the upper one: one binary search and one
//!    orientation for each (`outline`). By 3 that is to be inside.
//! 6. No point equal to a vertex has a smaller index than the vertex; under [`Boundary::All`] no point of the
//!    boundary is missing among the vertices.
//!
//! 1 and 5 make it the hull, 2 makes its vertices the corners (or the boundary points), 4 and 6 make it the one
//! value that stands for it. Dimensions below two need no care of their own: a polygon that passes 2 and 3 has
//! area, and a segment passes 5 only if all points lie on it.
//!
//! # The argument, for layers
//!
//! Each ring passes 1 to 4. The points of rank i are the vertices of ring i and copies of them, and the points
//! of rank i+1 pass 5 and 6 against ring i, none of them a copy of its vertices. The points of ranks beyond
//! i+1 need no check against ring i: ring i+1 is inside ring i, so what is inside ring i+1 is inside ring i, by
//! induction for all that remains; a copy of a corner of ring i would be a corner of ring i+1 too; and if no
//! point of rank i+1 is on the boundary of ring i, neither is anything inside ring i+1. So all layers together
//! cost no more than one pass over the points.
//!
//! The arguments for hulls in space and for Delaunay triangulations are at the top of [`space`] and
//! [`triangulation`].

mod cycle;
mod finding;
mod layers;
mod outline;
pub mod space;
pub mod triangulation;

pub use finding::Finding;
pub use layers::{LayersCertificate, layers};
pub use space::{Certificate3, Finding3, Order, hull3};
pub use triangulation::{DelaunayCertificate, DelaunayFinding, delaunay};

use crate::arithmetic::{Frame, Width};
use geometry_core::{Boundary, Hull2, Point2};
use outline::{Outline, Place};

/// What was established about a hull. The points are accounted for: `n = h + copies + on_edges + inside`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate2 {
    /// The number of points, each located against the hull.
    pub n: usize,
    /// The number of vertices, each found to be a point of the set and a corner (or boundary point).
    pub h: usize,
    /// The convention the hull was checked for.
    pub boundary: Boundary,
    /// The dimension of the set: `None` if empty, 0, 1 or 2.
    pub dimension: Option<usize>,
    /// Points that are copies of a vertex, the vertices themselves not counted.
    pub copies: usize,
    /// Points on an edge that are no vertices; none under [`Boundary::All`].
    pub on_edges: usize,
    /// Points strictly inside.
    pub inside: usize,
    /// How wide the integers were.
    pub width: Width,
}

/// Certifies that `hull` is the hull of `points`, as the canonical value that [`Hull2`] promises.
///
/// # Errors
///
/// Every [`Finding`] of the first step that fails (ids, then distinctness, then shape, then containment): a
/// later step presumes the earlier. Any value of `hull` whatever is accepted, and the list is never empty.
///
/// # Cost
///
/// O(n log h + h log h) time, O(h) space.
///
/// ```
/// use geometry_core::{Boundary, Hull2};
/// use hull_verify::check::{self, Finding};
/// let row = [[0.0, 0.0], [2.0, 2.0], [1.0, 1.0]];
/// assert!(check::hull2(&row, Boundary::Extreme, &Hull2::Segment(vec![0, 1])).is_ok());
/// assert!(check::hull2(&row, Boundary::All, &Hull2::Segment(vec![0, 2, 1])).is_ok());
/// let findings = check::hull2(&row, Boundary::All, &Hull2::Segment(vec![0, 1])).unwrap_err();
/// assert_eq!(findings, [Finding::MissingBoundaryPoint { point: 2, from: 0, to: 1 }]);
/// ```
pub fn hull2(
    points: &[Point2],
    boundary: Boundary,
    hull: &Hull2,
) -> Result<Certificate2, Vec<Finding>> {
    finding::reject_unusable(points)?;
    let frame = Frame::of(points);
    let outline = Outline::new(points, frame, boundary, hull)?;
    let mut certificate = Certificate2 {
        n: points.len(),
        h: hull.len(),
        boundary,
        dimension: hull.dimension(),
        copies: 0,
        on_edges: 0,
        inside: 0,
        width: frame.width(),
    };
    let mut findings = Vec::new();
    for (id, &point) in (0..).zip(points) {
        let place = outline.locate(point);
        match place {
            Place::Vertex(vertex) => certificate.copies += usize::from(vertex != id),
            Place::Edge(..) => certificate.on_edges += 1,
            Place::Inside => certificate.inside += 1,
            Place::Outside(..) | Place::Apart => {}
        }
        findings.extend(contradiction(boundary, hull, id, place));
    }
    if findings.is_empty() {
        Ok(certificate)
    } else {
        Err(findings)
    }
}

/// What is wrong, if anything, when `point` of the set has this place.
fn contradiction(boundary: Boundary, hull: &Hull2, point: u32, place: Place) -> Option<Finding> {
    match place {
        Place::Inside => None,
        Place::Vertex(vertex) => (point < vertex).then_some(Finding::LargerCopy {
            vertex,
            smaller: point,
        }),
        Place::Edge(from, to) => {
            (boundary == Boundary::All).then_some(Finding::MissingBoundaryPoint { point, from, to })
        }
        Place::Outside(from, to) => Some(Finding::Outside { point, from, to }),
        Place::Apart => Some(Finding::WrongDimension {
            claimed: hull.dimension(),
            witness: point,
        }),
    }
}
