//! The certificate of a hull in space.
//!
//! # The argument
//!
//! *Up* is along z. A facet is *upper* if its corners run anticlockwise as seen from above, *lower* if clockwise,
//! *vertical* if its shadow is flat.
//!
//! 1. Every id names a point, no two vertices are equal, the lists are in canonical order.
//! 2. Every edge of a facet is, in the other direction, an edge of exactly one other; the facets at each vertex form
//!    one cycle; the surface is in one piece; V - E + F = 2.
//! 3. Every facet is planar, strictly convex at every corner, and its boundary goes round once. So it is a strictly
//!    convex polygon.
//! 4. At every edge the facet beyond lies strictly below the plane of the facet on this side.
//! 5. The outline of the upper facets, seen from above (their edges to other facets), turns left or runs straight on
//!    everywhere and goes round once: it bounds a convex polygon D.
//! 6. Every point is below or on the upper facet over its shadow and above or on the lower facet under it.
//!
//! Why this makes it the hull. By 5 the outline winds once round every point inside D and not at all round points
//! outside. The shadows of the upper facets all run anticlockwise, so as many of them cover a point as the outline
//! winds round it: inside D one, outside none. They are the facets of the graph of a function u on D; by 4 it is
//! concave across every edge, so it is concave. By 2 the edges of all facets together cancel, those of a vertical
//! facet cancel in the shadow, and so the outlines of the upper and of the lower facets are the same up to
//! direction: by the same reasoning the lower facets are the graph of a convex function l on the same D.
//!
//! No vertical facet shares an edge that is not vertical with another, since the two would be in one plane, against
//! 4. So its upper and lower chains are edges of upper and lower facets, on the outline of D. By 4 a facet beyond one
//! of them, whose shadow is in D, is strictly below its plane; so it faces away from D, its upper chain belongs to u
//! and its lower one to l. Therefore l ≤ u on the boundary of D, and in D because u - l is concave: the surface is
//! the whole boundary of the convex body between l and u.
//!
//! By 6 every point is in the body, whose corners are points of the set by 1: it is the hull. By 3 and 4 its facets
//! are whole faces and its vertices are corners. (Local convexity alone would not do: a star-shaped bipyramid over a
//! pentagram satisfies 2, 3 and 4, and goes round twice. It fails at 5.)

mod finding3;
mod flat;
mod picture;
mod shape;
mod surface;

pub use finding3::{Finding3, Order};

use crate::arithmetic::scale::{Scale, Side};
use finding3::{reject_unusable, verdict};
use geometry_core::hull3::Solid;
use geometry_core::{Hull3, Point3};
use picture::{Half, Picture, Stab};
use shape::{Facing, Shape};
use surface::Surface;

/// What was established about a hull in space. The points are accounted for:
/// `n = h + copies + on_boundary + inside`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate3 {
    /// The number of points, each located against the hull.
    pub n: usize,
    /// The number of vertices, each found to be a point of the set and an extreme one.
    pub h: usize,
    /// The number of edges of a solid, each found to be convex; 0 below dimension three.
    pub edges: usize,
    /// The number of facets of a solid, each found to be whole; 0 below dimension three.
    pub facets: usize,
    /// The dimension of the set: `None` if empty, 0 to 3.
    pub dimension: Option<usize>,
    /// Points that are copies of a vertex, the vertices themselves not counted.
    pub copies: usize,
    /// Points on the boundary (relative to the plane of a planar hull) that are no vertices nor copies of one.
    pub on_boundary: usize,
    /// Points strictly inside (relative to the plane or line of a flat hull).
    pub inside: usize,
    /// How many bits the integers had to which the coordinates were scaled.
    pub bits: u32,
}

/// Where the points were found.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    copies: usize,
    on_boundary: usize,
    inside: usize,
}

impl Tally {
    /// Counts `point`, which is equal to `vertex`; or says that it should stand for both.
    fn copy(&mut self, vertex: u32, point: u32) -> Option<Finding3> {
        self.copies += usize::from(point != vertex);
        let smaller = point;
        (smaller < vertex).then_some(Finding3::LargerCopy { vertex, smaller })
    }
}

/// Certifies that `hull` is the hull of `points`, as the canonical value that [`Hull3`] promises.
///
/// # Errors
///
/// Every [`Finding3`] of the first step that fails: a later step presumes the earlier. Any value of `hull` whatever
/// is accepted, and the list is never empty.
///
/// # Cost
///
/// O(m log m) time for m edges, and a walk for each point that is no vertex: on average O(1) facets long for points
/// spread evenly, O(m) at most. O(n + m) space.
///
/// ```
/// use geometry_core::{Hull3, hull3::Solid};
/// use hull_verify::check::{self, Finding3};
/// let points = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0], [1.0; 3]];
/// let facets = vec![vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![2, 0, 3]];
/// let hull = Hull3::Solid(Solid::from_loops(facets));
/// let certificate = check::hull3(&points, &hull).unwrap();
/// assert_eq!((certificate.h, certificate.edges, certificate.facets, certificate.inside), (4, 6, 4, 1));
///
/// let mut more = points.to_vec();
/// more.push([-1.0, 1.0, 1.0]);
/// let findings = check::hull3(&more, &hull).unwrap_err();
/// assert_eq!(findings, [Finding3::Outside { point: 5, facet: 2 }]);
/// assert_eq!(findings[0].to_string(), "point 5 lies outside facet 2");
/// ```
pub fn hull3(points: &[Point3], hull: &Hull3) -> Result<Certificate3, Vec<Finding3>> {
    reject_unusable(points)?;
    let scale = Scale::of(points);
    let (tally, edges, facets) = match hull {
        Hull3::Empty => (flat::empty(points)?, 0, 0),
        Hull3::Point(id) => (flat::point(points, *id)?, 0, 0),
        Hull3::Segment(ends) => (flat::segment(points, scale, *ends)?, 0, 0),
        Hull3::Planar(ids) => (flat::planar(points, scale, ids)?, 0, 0),
        Hull3::Solid(claim) => {
            let tally = solid(points, scale, claim)?;
            (tally, claim.edge_count(), claim.facet_count())
        }
    };
    Ok(Certificate3 {
        n: points.len(),
        h: hull.len(),
        edges,
        facets,
        dimension: hull.dimension(),
        copies: tally.copies,
        on_boundary: tally.on_boundary,
        inside: tally.inside,
        bits: scale.bits(),
    })
}

fn solid(points: &[Point3], scale: Scale, claim: &Solid) -> Result<Tally, Vec<Finding3>> {
    let facets: Vec<&[u32]> = claim.facets().collect();
    let surface = Surface::new(points, claim.vertices(), &facets)?;
    let shape = Shape {
        points,
        scale,
        surface: &surface,
    };
    let facing = shape.facing_if_convex()?;
    let mut body = Body::new(shape, &facing);
    let mut is_vertex = vec![false; points.len()];
    for &id in claim.vertices() {
        is_vertex[id as usize] = true;
    }
    let mut tally = Tally::default();
    let mut findings = Vec::new();
    for (point, &p) in (0..).zip(points) {
        if is_vertex[point as usize] {
            continue;
        }
        match body.locate(p) {
            Place::Vertex(vertex) => findings.extend(tally.copy(vertex, point)),
            Place::Boundary => tally.on_boundary += 1,
            Place::Inside => tally.inside += 1,
            Place::Outside(facet) => findings.push(Finding3::Outside { point, facet }),
        }
    }
    verdict(findings).map(|()| tally)
}

/// Where a point lies against a solid.
enum Place {
    /// Equal to this vertex.
    Vertex(u32),
    /// On the boundary, other than at a vertex.
    Boundary,
    Inside,
    /// Above the plane of this facet.
    Outside(u32),
}

/// A surface that passed steps 1 to 5.
struct Body<'a> {
    shape: Shape<'a>,
    upper: Picture<'a>,
    lower: Picture<'a>,
}

impl<'a> Body<'a> {
    fn new(shape: Shape<'a>, facing: &'a Facing) -> Self {
        Self {
            shape,
            upper: Picture::new(shape, facing, Half::Upper),
            lower: Picture::new(shape, facing, Half::Lower),
        }
    }

    /// Step 6.
    fn locate(&mut self, p: Point3) -> Place {
        let over = match self.upper.stab(p) {
            Ok(stab) => stab,
            Err(rim) => return Place::Outside(self.beyond(rim, p)),
        };
        match self.side_of(over.facet, p) {
            Side::Above => return Place::Outside(over.facet),
            Side::On => return on_facet(&over),
            Side::Below => {}
        }
        let under = match self.lower.stab(p) {
            Ok(stab) => stab,
            Err(rim) => return Place::Outside(self.beyond(rim, p)),
        };
        match self.side_of(under.facet, p) {
            Side::Above => Place::Outside(under.facet),
            Side::On => on_facet(&under),
            // On a vertical facet or edge.
            Side::Below if over.on_rim => Place::Boundary,
            Side::Below => Place::Inside,
        }
    }

    fn side_of(&self, facet: u32, p: Point3) -> Side {
        let [a, b, c] = self.shape.plane(self.shape.surface.first_side(facet));
        self.shape.scale.side(a, b, c, p)
    }

    /// A facet outside of which p is, whose shadow is strictly beyond a side on the rim of a picture: what is inside
    /// both facets at that edge has its shadow on the near side.
    fn beyond(&self, rim: u32, p: Point3) -> u32 {
        let here = self.shape.surface.facets[rim as usize];
        if self.side_of(here, p) == Side::Above {
            here
        } else {
            self.shape.surface.facet_beyond(rim)
        }
    }
}

/// The place of a point on the facet over or under it.
fn on_facet(stab: &Stab) -> Place {
    stab.corner.map_or(Place::Boundary, Place::Vertex)
}
