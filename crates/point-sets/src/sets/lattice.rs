//! Points of a square lattice, exact integers.
//!
//! ```text
//!    2  ·  ·  ·  ·
//!    1  ·  ·  ·  ·           row by row from the origin; the last row may be short
//!    0  ·  ·  ·  ·
//!       0  1  2  3
//! ```
//!
//! Full of equal coordinates, collinear points and equal distances. Four points are extreme; on the boundary
//! of `cols` by `rows` lie 2(cols + rows) - 4.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "lattice",
    summary: "a square lattice of exact integers, row by row",
    parameters: &[COLS, ROWS],
    source: "a standard degenerate case; the lattice of Green and Silverman is `oblique`",
    generate: Generate::Plane(|spec, n, _| {
        let grid = Grid::of(spec, n)?;
        Ok(grid
            .cells()
            .map(|(col, row)| [col as f64, row as f64])
            .collect())
    }),
};

pub(crate) const COLS: Parameter = Parameter {
    name: "cols",
    default: "auto",
    meaning: "points in a row; auto: rows if given, else the squarest lattice that holds n",
    kind: Kind::Integer {
        min: 1,
        max: u32::MAX as i64,
    },
};

pub(crate) const ROWS: Parameter = Parameter {
    name: "rows",
    default: "auto",
    meaning: "rows; auto: as many as n needs, the last one perhaps short",
    kind: Kind::Integer {
        min: 1,
        max: u32::MAX as i64,
    },
};

/// The cells of a lattice that hold its n points.
pub(crate) struct Grid {
    pub(crate) cols: usize,
    pub(crate) rows: usize,
    n: usize,
}

impl Grid {
    /// The lattice that `spec` describes by its parameters `cols` and `rows`.
    pub(crate) fn of(spec: &Spec, n: usize) -> Result<Self, SpecError> {
        let given = |name| spec.open_integer(name).map(|value| value as usize);
        let (cols, rows) = match (given("cols"), given("rows")) {
            (Some(cols), Some(rows)) if cols * rows == n => (cols, rows),
            (Some(cols), Some(rows)) => return Err(conflict(spec, n, cols, rows)),
            (Some(cols), None) => (cols, n.div_ceil(cols)),
            (None, Some(rows)) => (n.div_ceil(rows).max(1), rows),
            (None, None) => {
                let cols = squarest(n);
                (cols, n.div_ceil(cols))
            }
        };
        Ok(Grid { cols, rows, n })
    }

    /// `(col, row)` of each point, row by row.
    pub(crate) fn cells(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let cols = self.cols;
        (0..self.n).map(move |index| (index % cols, index / cols))
    }
}

/// The smallest side of a square that holds n points, and 1 for none.
fn squarest(n: usize) -> usize {
    let root = n.isqrt();
    (root + usize::from(root * root < n)).max(1)
}

fn conflict(spec: &Spec, n: usize, cols: usize, rows: usize) -> SpecError {
    SpecError::Conflict {
        set: spec.name(),
        problem: format!(
            "{cols} columns of {rows} rows are {} points and {n} are asked; ask for as many, or leave out \
             cols or rows",
            cols as u128 * rows as u128
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squarest_sides() {
        for (n, side) in [
            (0, 1),
            (1, 1),
            (2, 2),
            (4, 2),
            (5, 3),
            (99, 10),
            (100, 10),
            (101, 11),
        ] {
            assert_eq!(squarest(n), side, "{n}");
        }
    }
}
