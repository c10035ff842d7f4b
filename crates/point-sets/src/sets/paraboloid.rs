//! Points of a set of the plane, lifted to the paraboloid.
//!
//! ```text
//!       ·           ·
//!        ·         ·         (x, y, x² + y²), the height rounded
//!         ·  ·   ·
//!            · ·             every point is extreme, but for rounding
//! ```
//!
//! Seen from below, the hull is the Delaunay triangulation of the set of the plane. Heights of integers are exact:
//! lifted from a lattice, every facet below lies over a square.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "paraboloid",
    summary: "a set of the plane, lifted to z = x² + y²",
    parameters: &[Parameter {
        name: "of",
        default: "disc",
        meaning: "the set of the plane",
        kind: Kind::Set,
    }],
    source: "the link from Delaunay triangulations to hulls (Brown 1979, Voronoi diagrams from convex hulls, \
             Information Processing Letters 9, 223-228)",
    generate: Generate::Space(generate),
};

fn generate(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; 3]>, SpecError> {
    let points = spec.set("of").generate(n, seed)?;
    let lifted = points.into_iter().map(|[x, y]| [x, y, x * x + y * y]);
    let lifted: Vec<_> = lifted.collect();
    if lifted.iter().any(|[.., height]| !height.is_finite()) {
        return Err(SpecError::Conflict {
            set: spec.name(),
            problem: format!("squares of {} overflow; lift another set", spec.set("of")),
        });
    }
    Ok(lifted)
}
