//! Points of a cubic lattice, exact integers.
//!
//! ```text
//!           ·   ·   ·
//!         ·   ·   ·  ·
//!       ·   ·   ·  ·         row by row and layer by layer from the origin;
//!    2  ·   ·   · ·  ·       the last row may be short, and so may the last layer
//!    1  ·   ·   ·  ·
//!    0  ·   ·   ·
//!       0   1   2
//! ```
//!
//! Full of equal coordinates, collinear and coplanar points. Eight points are extreme.

use super::lattice::{COLS, ROWS};
use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "cubic-lattice",
    summary: "a cubic lattice of exact integers, layer by layer",
    parameters: &[
        Parameter {
            meaning: "points in a row; auto: as many as makes the sides not given most alike",
            ..COLS
        },
        Parameter {
            meaning: "rows in a layer; auto: likewise",
            ..ROWS
        },
        Parameter {
            name: "layers",
            default: "auto",
            meaning: "layers; auto: as many as n needs, the last one perhaps short",
            kind: Kind::Integer {
                min: 1,
                max: u32::MAX as i64,
            },
        },
    ],
    source: "a standard degenerate case",
    generate: Generate::Space(generate),
};

fn generate(spec: &Spec, n: usize, _seed: u64) -> Result<Vec<[f64; 3]>, SpecError> {
    let [cols, rows, _] = sides(spec, n)?;
    let points = (0..n).map(|index| {
        let (row, layer) = (index / cols, index / cols / rows);
        [index % cols, row % rows, layer].map(|coordinate| coordinate as f64)
    });
    Ok(points.collect())
}

/// Columns, rows and layers of a lattice that holds n points.
fn sides(spec: &Spec, n: usize) -> Result<[usize; 3], SpecError> {
    let given =
        ["cols", "rows", "layers"].map(|name| spec.open_integer(name).map(|side| side as u128));
    let known: u128 = given.iter().flatten().product();
    let mut open = given.iter().filter(|side| side.is_none()).count() as u32;
    if open == 0 && known != n as u128 {
        let [cols, rows, layers] = given.map(|side| side.unwrap_or(1));
        return Err(SpecError::Conflict {
            set: spec.name(),
            problem: format!(
                "{layers} layers of {rows} rows of {cols} are {known} points and {n} are asked; ask for as many, \
                 or leave out cols, rows or layers"
            ),
        });
    }
    let mut needed = (n as u128).div_ceil(known).max(1);
    Ok(given.map(|side| {
        let side = side.unwrap_or_else(|| {
            let root = root_up(needed, open);
            needed = needed.div_ceil(root);
            open -= 1;
            root
        });
        side as usize
    }))
}

/// The smallest whole number whose power is at least `value`, which is at most 2³².
fn root_up(value: u128, power: u32) -> u128 {
    let near = libm::pow(value as f64, 1.0 / f64::from(power)) as u128;
    let is_enough = |root: &u128| root.pow(power) >= value;
    (near.saturating_sub(1).max(1)..)
        .find(is_enough)
        .unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_rounded_up() {
        for (value, power, root) in [
            (1, 3, 1),
            (8, 3, 2),
            (9, 3, 3),
            (27, 3, 3),
            (1_000_000, 3, 100),
            (1_000_001, 3, 101),
            (26, 2, 6),
            (7, 1, 7),
        ] {
            assert_eq!(root_up(value, power), root, "{value} {power}");
        }
    }

    #[test]
    fn sides_hold_the_points() {
        for (text, n, expected) in [
            ("cubic-lattice", 27, [3, 3, 3]),
            ("cubic-lattice", 28, [4, 3, 3]),
            ("cubic-lattice", 0, [1, 1, 1]),
            ("cubic-lattice:layers=2", 18, [3, 3, 2]),
            ("cubic-lattice:cols=10", 31, [10, 2, 2]),
            ("cubic-lattice:cols=2,rows=3", 25, [2, 3, 5]),
            ("cubic-lattice:cols=2,rows=3,layers=4", 24, [2, 3, 4]),
        ] {
            let spec: Spec = text.parse().unwrap();
            assert_eq!(sides(&spec, n).unwrap(), expected, "{text} {n}");
        }
    }
}
