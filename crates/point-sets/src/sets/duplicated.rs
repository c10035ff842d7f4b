//! Copies of another set's points.
//!
//! ```text
//!     a b c  -->  a b c a b c a b     m = ceil(n/copies) points, taken in turn until there are n
//! ```
//!
//! Of equal points the smallest index stands for all, so the hull names only the first m points.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::error::SpecError;
use crate::spec::{Made, Spec};

pub(crate) const ENTRY: Entry = Entry {
    name: "duplicated",
    summary: "copies of another set's points",
    parameters: &[
        Parameter {
            name: "of",
            default: "disc",
            meaning: "the set whose points are copied",
            kind: Kind::Set,
        },
        Parameter {
            name: "copies",
            default: "2",
            meaning: "how often each point occurs (the last ones perhaps less often)",
            kind: Kind::Integer {
                min: 1,
                max: u32::MAX as i64,
            },
        },
    ],
    source: "a standard degenerate case",
    generate: Generate::Either(generate, generate),
};

fn generate<P: Made>(spec: &Spec, n: usize, seed: u64) -> Result<Vec<P>, SpecError> {
    let copies = spec.integer("copies") as usize;
    let mut points = P::made(spec.set("of"), n.div_ceil(copies), seed)?;
    let distinct = points.len();
    points.reserve_exact(n - distinct);
    for index in distinct..n {
        points.push(points[index - distinct]);
    }
    Ok(points)
}
