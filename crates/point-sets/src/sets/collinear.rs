//! Points of one line, exact integers in random order.
//!
//! ```text
//!                  ·
//!              ·             t (dx, dy) for t = 0, 1, ..., n - 1, shuffled
//!          ·
//!      ·
//! ```
//!
//! The hull is a segment. Random order, because methods that sort by x see nothing special in sorted input.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "collinear",
    summary: "on one line, exact integers in random order",
    parameters: &[
        step("dx", "2", "x of the step from point to point"),
        step("dy", "1", "y of the step from point to point"),
    ],
    source: "a standard degenerate case",
    generate: Generate::Plane(generate),
};

/// Steps up to 2²⁰ times fewer than 2³² points stay below 2⁵³, so every coordinate is exact.
const fn step(name: &'static str, default: &'static str, meaning: &'static str) -> Parameter {
    let limit = 1 << 20;
    Parameter {
        name,
        default,
        meaning,
        kind: Kind::Integer {
            min: -limit,
            max: limit,
        },
    }
}

fn generate(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; 2]>, SpecError> {
    let (dx, dy) = (spec.integer("dx"), spec.integer("dy"));
    if dx == 0 && dy == 0 {
        return Err(SpecError::Conflict {
            set: spec.name(),
            problem: "dx and dy are both 0; for copies of one point use `duplicated`".to_owned(),
        });
    }
    let mut points: Vec<_> = (0..n as i64)
        .map(|t| [(t * dx) as f64, (t * dy) as f64])
        .collect();
    Draw::new(seed).shuffle(&mut points);
    Ok(points)
}
