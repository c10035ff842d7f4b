//! What can be wrong with a claimed Delaunay triangulation.

use std::fmt;

/// One thing that is wrong with a claimed Delaunay triangulation. Points are indices into the slice of points,
/// triangles numbers in the order of the triangulation.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DelaunayFinding {
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
    /// A corner names no point.
    NoSuchPoint {
        /// The id given.
        id: u32,
        /// How many points there are.
        count: usize,
    },
    /// A corner has a copy with a smaller index, which should stand for both.
    LargerCopy {
        /// The corner listed.
        vertex: u32,
        /// The copy that should be.
        smaller: u32,
    },
    /// There are no triangles, but these points are not collinear.
    NoTriangles {
        /// The points.
        witnesses: [u32; 3],
    },
    /// A point is no corner of a triangle, and no copy of one.
    MissingVertex {
        /// The point.
        point: u32,
    },
    /// The corners of a triangle are on one line.
    FlatTriangle {
        /// The triangle.
        triangle: u32,
    },
    /// A triangle runs clockwise.
    Clockwise {
        /// The triangle.
        triangle: u32,
    },
    /// Two triangles have this edge in the same direction: they overlap.
    SharedEdge {
        /// From this vertex …
        from: u32,
        /// … to this one.
        to: u32,
        /// The triangles.
        triangles: [u32; 2],
    },
    /// The outline of all triangles branches at this vertex, or is not convex there.
    OutlineBreaks {
        /// The vertex.
        vertex: u32,
    },
    /// The outline is convex everywhere but goes round more than once: triangles overlap, or lie apart.
    OutlineWinding {
        /// How many times.
        revolutions: usize,
    },
    /// A point lies inside the circle through the corners of a triangle.
    InCircle {
        /// The triangle.
        triangle: u32,
        /// The point, a corner of the triangle beyond one of its edges.
        point: u32,
    },
}

impl fmt::Display for DelaunayFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use DelaunayFinding::*;
        match self {
            NotFinite { point } => write!(f, "point {point} has a coordinate that is not finite"),
            TooManyPoints { count } => write!(f, "{count} points are more than u32 can index"),
            NoSuchPoint { id, count } => write!(f, "corner {id} is none of the {count} points"),
            LargerCopy { vertex, smaller } => {
                write!(
                    f,
                    "corner {vertex} is a copy of point {smaller}, which should stand for it"
                )
            }
            NoTriangles {
                witnesses: [a, b, c],
            } => write!(
                f,
                "there are no triangles, but points {a}, {b}, {c} are not collinear"
            ),
            MissingVertex { point } => write!(f, "point {point} is no corner of a triangle"),
            FlatTriangle { triangle } => {
                write!(f, "the corners of triangle {triangle} are on one line")
            }
            Clockwise { triangle } => write!(f, "triangle {triangle} runs clockwise"),
            SharedEdge {
                from,
                to,
                triangles: [one, two],
            } => write!(
                f,
                "triangles {one} and {two} both have the edge {from} -> {to}"
            ),
            OutlineBreaks { vertex } => write!(f, "the outline is not convex at {vertex}"),
            OutlineWinding { revolutions } => {
                write!(f, "the outline goes round {revolutions} times")
            }
            InCircle { triangle, point } => {
                write!(
                    f,
                    "point {point} is inside the circle round triangle {triangle}"
                )
            }
        }
    }
}

impl std::error::Error for DelaunayFinding {}
