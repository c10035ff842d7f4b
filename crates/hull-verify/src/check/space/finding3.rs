//! What can be wrong with a claimed hull in space.

use crate::check::Finding;
use geometry_core::{Axis, Point3};
use std::fmt;

/// One thing that is wrong with a claimed hull in space. Points are indices into the slice of points, facets
/// numbers in the order of the hull.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Finding3 {
    /// The set cannot be judged: a coordinate of this point is NaN or infinite.
    NotFinite {
        /// The point.
        point: usize,
    },
    /// The set cannot be judged: more points than `u32` can name.
    TooManyPoints {
        /// How many.
        count: usize,
    },
    /// A vertex names no point.
    NoSuchPoint {
        /// The id given.
        id: u32,
        /// How many points there are.
        count: usize,
    },
    /// Two vertices are copies of one point.
    EqualVertices {
        /// The one with the smaller index.
        first: u32,
        /// The other.
        second: u32,
    },
    /// A vertex has a copy with a smaller index, which should stand for both.
    LargerCopy {
        /// The vertex listed.
        vertex: u32,
        /// The copy that should be.
        smaller: u32,
    },
    /// The points have a higher dimension than the hull: this one is off its plane or line, or is a second point.
    WrongDimension {
        /// The dimension of the hull given.
        claimed: Option<usize>,
        /// The point that shows it.
        witness: u32,
    },
    /// A flat hull is not listed from its lexicographically smallest vertex towards the smaller neighbour.
    WrongStart {
        /// The vertex listed first.
        first: u32,
        /// The vertex listed second.
        second: u32,
    },
    /// The corners of a planar hull are fewer than three, or the first three are on one line.
    FlatPolygon,
    /// A planar hull is not the hull of its shadow along an axis, which is a true picture of it.
    InShadow {
        /// The axis.
        axis: Axis,
        /// What is wrong with the shadow.
        finding: Finding,
    },
    /// A solid is not in the order that makes it the one value that stands for it.
    NotCanonical {
        /// What is out of order.
        what: Order,
    },
    /// A facet has fewer than three corners.
    FewCorners {
        /// The facet.
        facet: u32,
        /// How many.
        count: usize,
    },
    /// Two facets have this edge in the same direction, or one has it twice.
    SharedEdge {
        /// From this vertex …
        from: u32,
        /// … to this one.
        to: u32,
        /// The facets.
        facets: [u32; 2],
    },
    /// An edge of a facet has no facet on its other side.
    OpenEdge {
        /// From this vertex …
        from: u32,
        /// … to this one.
        to: u32,
        /// The facet.
        facet: u32,
    },
    /// The facets at a vertex form more than one cycle round it.
    PinchedVertex {
        /// The vertex.
        vertex: u32,
        /// How many.
        cycles: u32,
    },
    /// The surface is in several pieces.
    Disconnected {
        /// A facet that cannot be reached from facet 0.
        facet: u32,
    },
    /// The surface is not a sphere: V - E + F is not 2.
    Euler {
        /// V.
        vertices: usize,
        /// E.
        edges: usize,
        /// F.
        facets: usize,
    },
    /// The first three corners of a facet are on one line.
    FlatFacet {
        /// The facet.
        facet: u32,
    },
    /// A corner is not in the plane of the first three corners of its facet.
    OffPlane {
        /// The facet.
        facet: u32,
        /// The corner.
        corner: u32,
    },
    /// The boundary of a facet runs straight on at a corner, which is therefore none, or turns back.
    NoCorner {
        /// The facet.
        facet: u32,
        /// The corner.
        corner: u32,
    },
    /// The boundary of a facet turns the wrong way at a corner.
    ReflexCorner {
        /// The facet.
        facet: u32,
        /// The corner.
        corner: u32,
    },
    /// The boundary of a facet turns the right way everywhere but goes round more than once.
    FacetWinding {
        /// The facet.
        facet: u32,
        /// How many times.
        revolutions: usize,
    },
    /// Every edge is reflex: the facets run clockwise as seen from outside.
    InsideOut,
    /// Two neighbouring facets meet in a reflex edge.
    ReflexEdge {
        /// From this vertex …
        from: u32,
        /// … to this one.
        to: u32,
        /// The facets, the first of which has the edge in this direction.
        facets: [u32; 2],
    },
    /// Two neighbouring facets are in one plane, so that neither is maximal.
    CoplanarFacets {
        /// From this vertex …
        from: u32,
        /// … to this one.
        to: u32,
        /// The facets, the first of which has the edge in this direction.
        facets: [u32; 2],
    },
    /// Every edge is convex, but the surface goes round itself several times: the outline of its upper side, seen
    /// from above, branches or turns right at this vertex.
    OutlineBreaks {
        /// The vertex.
        vertex: u32,
    },
    /// Every edge is convex, but the surface goes round itself several times: so many revolutions does the outline
    /// of its upper side make, seen from above.
    OutlineWinding {
        /// How many.
        revolutions: usize,
    },
    /// A point lies outside.
    Outside {
        /// The point.
        point: u32,
        /// The facet above whose plane it is.
        facet: u32,
    },
    /// A point is on the line of a segment beyond one of its ends.
    BeyondEnd {
        /// The point.
        point: u32,
        /// The end.
        end: u32,
    },
}

/// A part of the canonical order of a solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Order {
    /// The vertices, which must be exactly the corners of the facets, ascending.
    Vertices,
    /// The corners of this facet, which must start with the smallest.
    Corners(u32),
    /// This facet, which must follow the one before it in lexicographic order.
    Facet(u32),
}

impl fmt::Display for Finding3 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use Finding3::*;
        match self {
            NotFinite { point } => write!(f, "point {point} has a coordinate that is not finite"),
            TooManyPoints { count } => write!(f, "{count} points are more than u32 can index"),
            NoSuchPoint { id, count } => write!(f, "vertex {id} is none of the {count} points"),
            EqualVertices { first, second } => {
                write!(f, "vertices {first} and {second} are copies of one point")
            }
            LargerCopy { vertex, smaller } => {
                write!(
                    f,
                    "vertex {vertex} is a copy of point {smaller}, which should stand for it"
                )
            }
            WrongDimension { claimed, witness } => {
                let claimed = claimed.map_or("empty".into(), |d| format!("of dimension {d}"));
                write!(
                    f,
                    "the hull is given as {claimed}, but point {witness} is not on it"
                )
            }
            WrongStart { first, second } => {
                write!(f, "the hull is not to be listed as {first}, {second}, …")
            }
            FlatPolygon => write!(
                f,
                "the first three corners of the planar hull span no plane"
            ),
            InShadow { axis, finding } => write!(f, "in the shadow along {axis:?}: {finding}"),
            NotCanonical {
                what: Order::Vertices,
            } => {
                write!(
                    f,
                    "the vertices are not the corners of the facets in ascending order"
                )
            }
            NotCanonical {
                what: Order::Corners(facet),
            } => {
                write!(f, "facet {facet} does not start with its smallest corner")
            }
            NotCanonical {
                what: Order::Facet(facet),
            } => {
                write!(f, "facet {facet} should not follow the one before it")
            }
            FewCorners { facet, count } => write!(f, "facet {facet} has {count} corners"),
            SharedEdge {
                from,
                to,
                facets: [one, two],
            } => {
                write!(
                    f,
                    "facets {one} and {two} both have the edge {from} -> {to}"
                )
            }
            OpenEdge { from, to, facet } => {
                write!(
                    f,
                    "no facet has the reverse of the edge {from} -> {to} of facet {facet}"
                )
            }
            PinchedVertex { vertex, cycles } => {
                write!(f, "the facets at vertex {vertex} form {cycles} cycles")
            }
            Disconnected { facet } => write!(f, "facet {facet} is on another piece than facet 0"),
            Euler {
                vertices,
                edges,
                facets,
            } => {
                write!(
                    f,
                    "{vertices} vertices - {edges} edges + {facets} facets is not 2"
                )
            }
            FlatFacet { facet } => {
                write!(
                    f,
                    "the first three corners of facet {facet} are on one line"
                )
            }
            OffPlane { facet, corner } => {
                write!(f, "corner {corner} is not in the plane of facet {facet}")
            }
            NoCorner { facet, corner } => {
                write!(
                    f,
                    "facet {facet} runs straight on or back at {corner}, which is no corner"
                )
            }
            ReflexCorner { facet, corner } => write!(f, "facet {facet} is reflex at {corner}"),
            FacetWinding { facet, revolutions } => {
                write!(
                    f,
                    "the boundary of facet {facet} goes round {revolutions} times"
                )
            }
            InsideOut => write!(f, "all facets run clockwise as seen from outside"),
            ReflexEdge {
                from,
                to,
                facets: [one, two],
            } => {
                write!(
                    f,
                    "the edge {from} -> {to} between facets {one} and {two} is reflex"
                )
            }
            CoplanarFacets {
                from,
                to,
                facets: [one, two],
            } => {
                write!(
                    f,
                    "facets {one} and {two}, which share {from} -> {to}, are in one plane"
                )
            }
            OutlineBreaks { vertex } => {
                write!(f, "the outline seen from above is not convex at {vertex}")
            }
            OutlineWinding { revolutions } => {
                write!(
                    f,
                    "the outline seen from above goes round {revolutions} times"
                )
            }
            Outside { point, facet } => write!(f, "point {point} lies outside facet {facet}"),
            BeyondEnd { point, end } => write!(f, "point {point} lies beyond the end {end}"),
        }
    }
}

impl std::error::Error for Finding3 {}

/// Findings about the set itself: a coordinate that is not finite, too many points.
pub(super) fn reject_unusable(points: &[Point3]) -> Result<(), Vec<Finding3>> {
    if u32::try_from(points.len()).is_err() {
        return Err(vec![Finding3::TooManyPoints {
            count: points.len(),
        }]);
    }
    let not_finite = |(point, p): (usize, &Point3)| {
        (!p.iter().all(|x| x.is_finite())).then_some(Finding3::NotFinite { point })
    };
    verdict(points.iter().enumerate().filter_map(not_finite).collect())
}

/// `Err` if there are findings.
pub(super) fn verdict(findings: Vec<Finding3>) -> Result<(), Vec<Finding3>> {
    if findings.is_empty() {
        Ok(())
    } else {
        Err(findings)
    }
}
