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

impl Entry {
    /// The dimensions of which the set can be: 2 for the plane, 3 for space, and both for a set made of another,
    /// which is of the dimension of that one.
    pub fn dimensions(&self) -> &'static [usize] {
        match self.generate {
            Generate::Plane(_) => &[2],
            Generate::Space(_) => &[3],
            Generate::Either(..) => &[2, 3],
        }
    }
}

/// Makes n points of dimension D with the parameters of a spec and a seed.
type Maker<const D: usize> = fn(&Spec, usize, u64) -> Result<Vec<[f64; D]>, SpecError>;

/// How the points of a set are made, by its dimension.
#[derive(Debug)]
pub(crate) enum Generate {
    /// A set of the plane.
    Plane(Maker<2>),
    /// A set of space.
    Space(Maker<3>),
    /// A set made of the set `of`, in the dimension of that one.
    Either(Maker<2>, Maker<3>),
}

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

/// Every point set there is, in the order to list them: those of the plane, those of space, those made of others.
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
    sets::flattened_sphere::ENTRY,
    sets::ball::ENTRY,
    sets::cube::ENTRY,
    sets::normal3::ENTRY,
    sets::cauchy3::ENTRY,
    sets::sphere::ENTRY,
    sets::paraboloid::ENTRY,
    sets::moment_curve::ENTRY,
    sets::cube_faces::ENTRY,
    sets::cubic_lattice::ENTRY,
    sets::prism::ENTRY,
    sets::antiprism::ENTRY,
    sets::near_coplanar::ENTRY,
    sets::circle_and_axis::ENTRY,
    sets::fan::ENTRY,
    sets::cone::ENTRY,
    sets::duplicated::ENTRY,
    sets::shuffled::ENTRY,
    sets::rounded::ENTRY,
    sets::minkowski::ENTRY,
];
