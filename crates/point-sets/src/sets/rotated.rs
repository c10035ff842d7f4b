//! Points of a lattice of the unit square, rotated and so rounded.
//!
//! ```text
//!            ·
//!         ·     ·            (i/(cols - 1), j/(rows - 1)) turned about (0, 0);
//!      ·     ·     ·         what was collinear is now collinear but for rounding
//!         ·     ·
//!            ·
//! ```
//!
//! Near degeneracy as measured data has it: coordinates rounded to double precision, or to a given number of
//! decimals as a printed table is.

use super::lattice::{COLS, Grid, ROWS};
use super::rounded::{DECIMALS, to_decimals};
use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;
use crate::error::SpecError;
use crate::spec::Spec;
use std::f64::consts::PI;

pub(crate) const ENTRY: Entry = Entry {
    name: "rotated",
    summary: "a lattice of the unit square, rotated: collinear but for rounding",
    parameters: &[
        COLS,
        ROWS,
        Parameter {
            name: "angle",
            default: "random",
            meaning: "degrees anticlockwise; random: uniform on [0, 90), from the seed",
            kind: Kind::Number,
        },
        Parameter {
            default: "all",
            meaning: "decimals to which coordinates are rounded; all: double precision",
            ..DECIMALS
        },
    ],
    source: "after Green and Silverman 1979, Table 1, lattice data",
    generate: Generate::Plane(generate),
};

fn generate(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; 2]>, SpecError> {
    let grid = Grid::of(spec, n)?;
    let degrees = match spec.open_number("angle") {
        Some(degrees) => degrees,
        None => 90.0 * Draw::new(seed).unit(),
    };
    let (sine, cosine) = libm::sincos(degrees * (PI / 180.0));
    let points = grid.cells().map(|(col, row)| {
        let (x, y) = (fraction(col, grid.cols), fraction(row, grid.rows));
        [cosine * x - sine * y, sine * x + cosine * y]
    });
    Ok(match spec.open_integer("decimals") {
        Some(decimals) => points.map(|point| to_decimals(point, decimals)).collect(),
        None => points.collect(),
    })
}

/// Where `index` of `count` lies between 0 and 1.
fn fraction(index: usize, count: usize) -> f64 {
    index as f64 / count.saturating_sub(1).max(1) as f64
}
