//! Every point set there is.

use crate::error::SpecError;
use crate::sets;
use crate::spec::Spec;

/// A named point set: what it is and what can be chosen about it.
#[derive(Debug)]
pub struct Entry {
    /// The name it is called by on the command line, in definitions and in tables.
    pub name: &'static str,
    /// What it is, in one line.
    pub summary: &'static str,
    /// What can be chosen, in canonical order.
    pub parameters: &'static [Parameter],
    /// Where it comes from: who used it, and for what.
    pub source: &'static str,
    pub(crate) generate: Generate,
}

/// Makes n points with the parameters of a spec and a seed.
pub(crate) type Generate = fn(&Spec, usize, u64) -> Result<Vec<[f64; 2]>, SpecError>;

/// One choice about a point set, written `name=value`.
#[derive(Debug)]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// The value taken when none is given; it may also be given.
    pub default: &'static str,
    /// What it means, in one line.
    pub meaning: &'static str,
    pub(crate) kind: Kind,
}

/// Which values a parameter takes.
#[derive(Debug)]
pub(crate) enum Kind {
    /// A whole number in this range, both ends included.
    Integer { min: i64, max: i64 },
    /// A finite number.
    Number,
    /// One of these words.
    Word(&'static [&'static str]),
    /// The name of another set.
    Set,
}

/// Every point set there is, in the order to list them.
///
/// ```
/// let names: Vec<_> = point_sets::catalogue().iter().map(|entry| entry.name).collect();
/// assert!(names.starts_with(&["disc", "square", "normal", "cauchy", "circle"]));
/// ```
pub fn catalogue() -> &'static [Entry] {
    CATALOGUE
}

static CATALOGUE: &[Entry] = &[
    sets::disc::ENTRY,
    sets::square::ENTRY,
    sets::normal::ENTRY,
    sets::cauchy::ENTRY,
    sets::circle::ENTRY,
    sets::lattice::ENTRY,
    sets::oblique::ENTRY,
    sets::rotated::ENTRY,
    sets::collinear::ENTRY,
    sets::near_collinear::ENTRY,
    sets::parabola::ENTRY,
    sets::nested_triangles::ENTRY,
    sets::killer::ENTRY,
    sets::duplicated::ENTRY,
    sets::shuffled::ENTRY,
    sets::rounded::ENTRY,
];
