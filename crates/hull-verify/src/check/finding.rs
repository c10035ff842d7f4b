//! What can be wrong with a claimed hull.

use geometry_core::Point2;
use std::fmt;

/// One thing that is wrong with a claimed hull or claimed layers. Numbers are indices into the slice of points.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Finding {
    /// The set cannot be judged: this coordinate is NaN or infinite.
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
    /// The variant needs more vertices, or fewer.
    WrongCount {
        /// The dimension that the variant stands for.
        claimed: Option<usize>,
        /// How many vertices it has.
        count: usize,
    },
    /// A point is listed as a vertex more than once.
    Repeated {
        /// The point.
        id: u32,
    },
    /// Two equal points are both listed as vertices.
    EqualVertices {
        /// The one with the smaller index.
        first: u32,
        /// The other.
        second: u32,
    },
    /// The points have a higher dimension than the hull: this one is outside its line, or is a second point.
    WrongDimension {
        /// The dimension of the hull given.
        claimed: Option<usize>,
        /// The point that shows it.
        witness: u32,
    },
    /// The polygon runs clockwise.
    Clockwise,
    /// The outline turns right.
    RightTurn {
        /// The vertex before.
        before: u32,
        /// The vertex of the turn.
        at: u32,
        /// The vertex after.
        after: u32,
    },
    /// The outline runs straight on at a vertex, which is therefore no corner.
    NoCorner {
        /// The vertex before.
        before: u32,
        /// The vertex that is no corner.
        at: u32,
        /// The vertex after.
        after: u32,
    },
    /// The outline turns back on itself.
    TurnsBack {
        /// The vertex before.
        before: u32,
        /// The vertex of the turn.
        at: u32,
        /// The vertex after.
        after: u32,
    },
    /// The outline turns left everywhere but goes round more than once.
    Winding {
        /// How many times.
        revolutions: usize,
    },
    /// The list does not start at the lexicographically smallest vertex, or a segment runs the wrong way.
    WrongStart {
        /// Where it starts.
        start: u32,
        /// Where it should.
        smallest: u32,
    },
    /// The points of a segment are not in lexicographic order.
    WrongOrder {
        /// The point listed first.
        before: u32,
        /// The one after it, which should precede it.
        after: u32,
    },
    /// A point lies outside.
    Outside {
        /// The point.
        point: u32,
        /// The edge it lies outside: from this vertex …
        from: u32,
        /// … to this one.
        to: u32,
    },
    /// A vertex has a copy with a smaller index, which should stand for both.
    LargerCopy {
        /// The vertex listed.
        vertex: u32,
        /// The copy that should be.
        smaller: u32,
    },
    /// A point on the boundary is not listed, under `Boundary::All`.
    MissingBoundaryPoint {
        /// The point.
        point: u32,
        /// The edge it lies on: from this vertex …
        from: u32,
        /// … to this one.
        to: u32,
    },
    /// There are not as many c-ranks as points.
    RankCount {
        /// How many c-ranks are given.
        ranks: usize,
        /// How many points there are.
        count: usize,
    },
    /// A c-rank is not the number of a ring.
    NoSuchRing {
        /// The point.
        point: u32,
        /// Its c-rank.
        rank: u32,
        /// How many rings there are.
        rings: usize,
    },
    /// A ring has no vertices.
    EmptyRing {
        /// Its number, from 1.
        ring: u32,
    },
    /// A vertex of a ring has the c-rank of another.
    WrongRank {
        /// The ring, from 1.
        ring: u32,
        /// The vertex.
        vertex: u32,
        /// Its c-rank.
        rank: u32,
    },
    /// A point has the c-rank of a ring but is not a copy of one of its vertices.
    NotOnRing {
        /// The ring, from 1.
        ring: u32,
        /// The point.
        point: u32,
    },
    /// A copy of a vertex was not removed with it.
    CopyLeft {
        /// The ring that removed the vertex, from 1.
        ring: u32,
        /// The vertex.
        vertex: u32,
        /// The copy, whose c-rank is larger.
        copy: u32,
    },
    /// A ring is not the hull of what remained.
    InRing {
        /// The ring, from 1.
        ring: u32,
        /// What is wrong with it.
        finding: Box<Finding>,
    },
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Finding::NotFinite { point } => {
                write!(f, "point {point} has a coordinate that is not finite")
            }
            Finding::TooManyPoints { count } => {
                write!(f, "{count} points are more than u32 can index")
            }
            Finding::NoSuchPoint { id, count } => {
                write!(f, "vertex {id} is none of the {count} points")
            }
            Finding::WrongCount { claimed, count } => {
                write!(f, "{} cannot have {count} vertices", variant(*claimed))
            }
            Finding::Repeated { id } => write!(f, "vertex {id} is listed more than once"),
            Finding::EqualVertices { first, second } => {
                write!(f, "vertices {first} and {second} are copies of one point")
            }
            Finding::WrongDimension { claimed, witness } => {
                write!(
                    f,
                    "the hull is given as {}, but point {witness} is not on it",
                    variant(*claimed)
                )
            }
            Finding::Clockwise => write!(f, "the polygon runs clockwise"),
            Finding::RightTurn { before, at, after } => {
                write!(f, "{before} -> {at} -> {after} turns right")
            }
            Finding::NoCorner { before, at, after } => {
                write!(
                    f,
                    "{before} -> {at} -> {after} runs straight on: {at} is no corner"
                )
            }
            Finding::TurnsBack { before, at, after } => {
                write!(f, "{before} -> {at} -> {after} turns back on itself")
            }
            Finding::Winding { revolutions } => {
                write!(f, "the outline goes round {revolutions} times")
            }
            Finding::WrongStart { start, smallest } => {
                write!(
                    f,
                    "the list starts at {start}, but {smallest} is lexicographically smaller"
                )
            }
            Finding::WrongOrder { before, after } => {
                write!(
                    f,
                    "{before} is listed before {after}, but follows it lexicographically"
                )
            }
            Finding::Outside { point, from, to } => {
                write!(f, "point {point} lies outside edge {from} -> {to}")
            }
            Finding::LargerCopy { vertex, smaller } => {
                write!(
                    f,
                    "vertex {vertex} is a copy of point {smaller}, which should stand for it"
                )
            }
            Finding::MissingBoundaryPoint { point, from, to } => {
                write!(
                    f,
                    "point {point} lies on edge {from} -> {to} and is not listed"
                )
            }
            Finding::RankCount { ranks, count } => {
                write!(f, "{ranks} c-ranks are given for {count} points")
            }
            Finding::NoSuchRing { point, rank, rings } => {
                write!(
                    f,
                    "point {point} has c-rank {rank}, but there are {rings} rings"
                )
            }
            Finding::EmptyRing { ring } => write!(f, "ring {ring} has no vertices"),
            Finding::WrongRank { ring, vertex, rank } => {
                write!(f, "vertex {vertex} of ring {ring} has c-rank {rank}")
            }
            Finding::NotOnRing { ring, point } => {
                write!(
                    f,
                    "point {point} has c-rank {ring}, but is no vertex of that ring nor a copy of one"
                )
            }
            Finding::CopyLeft { ring, vertex, copy } => {
                write!(
                    f,
                    "point {copy} is a copy of vertex {vertex} of ring {ring}, but was not removed with it"
                )
            }
            Finding::InRing { ring, finding } => write!(f, "ring {ring}: {finding}"),
        }
    }
}

/// The variant of a hull by its dimension, in words.
fn variant(dimension: Option<usize>) -> &'static str {
    match dimension {
        None => "the empty hull",
        Some(0) => "a point",
        Some(1) => "a segment",
        Some(_) => "a polygon",
    }
}

/// The findings about the set itself: a coordinate that is not finite, too many points.
pub(super) fn reject_unusable(points: &[Point2]) -> Result<(), Vec<Finding>> {
    if u32::try_from(points.len()).is_err() {
        return Err(vec![Finding::TooManyPoints {
            count: points.len(),
        }]);
    }
    let findings: Vec<Finding> = points
        .iter()
        .enumerate()
        .filter(|(_, p)| !p.iter().all(|x| x.is_finite()))
        .map(|(point, _)| Finding::NotFinite { point })
        .collect();
    if findings.is_empty() {
        Ok(())
    } else {
        Err(findings)
    }
}
