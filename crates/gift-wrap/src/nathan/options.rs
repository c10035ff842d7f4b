//! What of the paper's text a run follows to the letter.

/// Which parts are as printed, and which corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NathanOptions {
    /// The first point.
    pub start: Start,
    /// What is marked so that work is not done twice.
    pub marks: Marks,
    /// How marks are found again.
    pub lookup: Lookup,
    /// Whether a candidate is tested against its own corners.
    pub own_corners: OwnCorners,
}

impl NathanOptions {
    /// The paper to the letter, with the better of its two first points.
    pub const PRINTED: Self = Self {
        start: Start::Furthest,
        marks: Marks::Edges,
        lookup: Lookup::List,
        own_corners: OwnCorners::Tested,
    };

    /// The registered method.
    pub const CORRECTED: Self = Self {
        start: Start::Lexicographic,
        marks: Marks::Sides,
        lookup: Lookup::Hash,
        own_corners: OwnCorners::Skipped,
    };
}

/// The first point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Start {
    /// As printed: the largest squared distance from the origin when flattened, computed in `f64`; the first of
    /// several. Extreme if there is only one, up to rounding.
    Furthest,
    /// As printed: the smallest squared distance. Extreme by accident only.
    Nearest,
    /// The lexicographically smallest point, which is always extreme.
    Lexicographic,
}

/// What is marked so that work is not done twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Marks {
    /// As printed: every edge that was ever on the stack, whatever its direction. Each edge is searched once, and a
    /// facet is found once for each of its edges that points its way.
    Edges,
    /// The sides of the accepted triangles. Each facet is found once.
    Sides,
}

/// How marks are found again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lookup {
    /// As printed: a list searched from the front.
    List,
    /// A hash table.
    Hash,
}

/// Whether a candidate is tested against its own corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OwnCorners {
    /// As printed.
    Tested,
    /// Skipped by their indices.
    Skipped,
}
