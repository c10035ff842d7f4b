//! Another set's points in random order.
//!
//! ```text
//!     a b c d e f  -->  d a f c b e
//! ```
//!
//! Lattices, parabolas and nested triangles come in an order that some methods profit or suffer from.

use crate::catalogue::{Entry, Kind, Parameter};
use crate::draw::Draw;
use crate::seed::subseed;

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
    generate: |spec, n, seed| {
        let mut points = spec.set("of").generate(n, seed)?;
        Draw::new(subseed(seed, "shuffled")).shuffle(&mut points);
        Ok(points)
    },
};
