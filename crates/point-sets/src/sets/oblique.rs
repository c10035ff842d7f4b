//! Points of an oblique lattice, exact integers.
//!
//! ```text
//!              ·
//!           ·     ·          i (ax, ay) + j (bx, by)  for i < cols, j < rows
//!        ·     ·     ·       by default i (3, 1) + j (1, 2)
//!     b     ·     ·
//!        ·     ·
//!     0     a
//! ```
//!
//! No side is parallel to an axis, yet collinear points stay exactly collinear. The layers are those of the
//! square lattice; for 10 by 10 under Green and Silverman's convention 36, 28, 20, 12 and 4 points.

use super::lattice::{COLS, Grid, ROWS};
use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "oblique",
    summary: "an oblique lattice of exact integers, row by row",
    parameters: &[
        COLS,
        ROWS,
        basis("ax", "3", "x of the step from column to column"),
        basis("ay", "1", "y of the step from column to column"),
        basis("bx", "1", "x of the step from row to row"),
        basis("by", "2", "y of the step from row to row"),
    ],
    source: "Green and Silverman 1979, Fig. 2 (the paper prints no coordinates; the basis is ours)",
    generate: Generate::Plane(generate),
};

/// Steps below 2²⁰ times at most 2³² columns and rows stay below 2⁵³, so every coordinate is exact.
const fn basis(name: &'static str, default: &'static str, meaning: &'static str) -> Parameter {
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

fn generate(spec: &Spec, n: usize, _seed: u64) -> Result<Vec<[f64; 2]>, SpecError> {
    let [ax, ay, bx, by] = ["ax", "ay", "bx", "by"].map(|name| spec.integer(name));
    if ax * by == ay * bx {
        return Err(SpecError::Conflict {
            set: spec.name(),
            problem: format!(
                "the steps ({ax}, {ay}) and ({bx}, {by}) are parallel; use `collinear`"
            ),
        });
    }
    let cells = Grid::of(spec, n)?.cells();
    let points = cells.map(|(col, row)| {
        let (i, j) = (col as i64, row as i64);
        [(i * ax + j * bx) as f64, (i * ay + j * by) as f64]
    });
    Ok(points.collect())
}
