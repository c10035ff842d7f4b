//! Another set's points in random order.
//!
//! ```text
//!     a b c d e f  -->  d a f c b e
//! ```
//!
//! Lattices, parabolas and nested triangles come in an order that some methods profit or suffer from.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;
use crate::error::SpecError;
use crate::seed::subseed;
use crate::spec::{Made, Spec};

pub(crate) const ENTRY: Entry = Entry {
    name: "shuffled",
    summary: "another set's points in random order",
    parameters: &[Parameter {
        name: "of",
        default: "lattice",
        meaning: "the set whose points are shuffled",
        kind: Kind::Set,
    }],
    source: "to separate what a method does from the order of its input",
    generate: Generate::Either(generate, generate),
};

fn generate<P: Made>(spec: &Spec, n: usize, seed: u64) -> Result<Vec<P>, SpecError> {
    let mut points = P::made(spec.set("of"), n, seed)?;
    Draw::new(subseed(seed, "shuffled")).shuffle(&mut points);
    Ok(points)
}
