//! The Minkowski sum of two sets: every point of the one plus every point of the other.
//!
//! ```text
//!      · ·        .          ·: ·:
//!     ·   ·   +    .    =   ·:  ·:      a_i + b_j, i = 0, ..., ceil(n/parts) - 1, j = 0, ..., parts - 1,
//!      · ·                   ·: ·:      for each i all of the b_j, rounded
//! ```
//!
//! The hull of the sum is the sum of the hulls: every pair of edges that a plane can touch at once makes a
//! parallelogram, so the sum is full of coplanar points, exactly if the coordinates are integers, and otherwise but
//! for the last bit.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::error::SpecError;
use crate::seed::subseed;
use crate::spec::{Made, Spec};

pub(crate) const ENTRY: Entry = Entry {
    name: "minkowski",
    summary: "the sums of the points of two sets: parallelograms, coplanar but for the last bit",
    parameters: &[
        Parameter {
            name: "of",
            default: "ball",
            meaning: "the one set",
            kind: Kind::Set,
        },
        Parameter {
            name: "with",
            default: "sphere",
            meaning: "the other set, of the same dimension",
            kind: Kind::Set,
        },
        Parameter {
            name: "parts",
            default: "8",
            meaning: "how many points the other set has",
            kind: Kind::Integer {
                min: 1,
                max: u32::MAX as i64,
            },
        },
    ],
    source: "the configuration spaces of motion planning",
    generate: Generate::Either(generate, generate),
};

fn generate<const D: usize>(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; D]>, SpecError>
where
    [f64; D]: Made,
{
    let parts = (spec.integer("parts") as usize).min(n.max(1));
    let of: Vec<[f64; D]> = Made::made(spec.set("of"), n.div_ceil(parts), seed)?;
    let with: Vec<[f64; D]> = Made::made(spec.set("with"), parts, subseed(seed, "minkowski"))?;
    let sums = of.iter().flat_map(|a| {
        let plus = |b: &[f64; D]| std::array::from_fn(|axis| a[axis] + b[axis]);
        with.iter().map(plus)
    });
    Ok(sums.take(n).collect())
}
