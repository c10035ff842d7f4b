//! Another set's points, rounded to decimals.
//!
//! ```text
//!    ·            .  .  ·  .
//!      · ·   -->  .  ·  ·  .      every point goes to the nearest point of a decimal grid;
//!     ·   ·       .  ·  .  ·      some meet there, many become collinear
//! ```
//!
//! What writing measurements down does to them.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::error::SpecError;
use crate::spec::{Made, Spec};

pub(crate) const ENTRY: Entry = Entry {
    name: "rounded",
    summary: "another set's points, rounded to decimals",
    parameters: &[
        Parameter {
            name: "of",
            default: "normal",
            meaning: "the set",
            kind: Kind::Set,
        },
        DECIMALS,
    ],
    source: "how measured data is printed",
    generate: Generate::Either(generate, generate),
};

fn generate<const D: usize>(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; D]>, SpecError>
where
    [f64; D]: Made,
{
    let decimals = spec.integer("decimals");
    let mut points = Made::made(spec.set("of"), n, seed)?;
    for point in &mut points {
        *point = to_decimals(*point, decimals);
    }
    Ok(points)
}

pub(crate) const DECIMALS: Parameter = Parameter {
    name: "decimals",
    default: "2",
    meaning: "decimals to which coordinates are rounded",
    kind: Kind::Integer { min: 0, max: 30 },
};

/// The doubles nearest to the coordinates' exact values written with so many decimals.
pub(crate) fn to_decimals<const D: usize>(point: [f64; D], decimals: i64) -> [f64; D] {
    // Printing and reading are both correctly rounded. Adding zero turns -0 into 0.
    point.map(|coordinate| {
        let printed = format!("{coordinate:.*}", decimals as usize);
        let read: f64 = printed.parse().expect("a printed number can be read");
        read + 0.0
    })
}
