//! The place of a point along Hilbert's curve through a box.
//!
//! C. H. Hamilton, A. Rau-Chaplin, "Compact Hilbert indices: space-filling curves for domains with unequal side lengths",
//! *Information Processing Letters* 105, 155–163, 2008, section 2: a cube is cut into eight, which the curve visits in
//! the order of a Gray code, turned and mirrored to suit where it enters and leaves. A turn and a mirroring are one of 24
//! states, and a table tells for each state and eighth its number on the curve and the state inside it. Here one look-up
//! takes two levels at once.
//!
//! Neighbours on the curve are neighbours in space; nothing but speed depends on it.

use geometry_core::Point3;

/// Levels that one look-up takes.
const STRIDE: u32 = 2;
/// Cells of that many levels.
const CELLS: usize = 1 << (3 * STRIDE);
/// Eight corners to enter at, times three axes to leave along.
const STATES: usize = 24;

/// For `CELLS · state + cell`: the number of the cell on the curve, and the state inside, as `CELLS · state + number`.
static CURVE: [u16; CELLS * STATES] = curve();

/// A box of cells, and how to tell which of them a point is in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    lowest: Point3,
    /// Halves of the extents.
    extents: Point3,
    /// Cells per unit of half a coordinate.
    scale: Point3,
    /// Cells along an axis are two to this power.
    levels: u32,
}

impl Grid {
    /// The grid over the bounding box of `points`, with `levels` rounded up to a multiple of [`STRIDE`].
    ///
    /// At most 20 levels.
    pub(super) fn over(points: impl Iterator<Item = Point3>, levels: u32) -> Self {
        let levels = levels.min(20).next_multiple_of(STRIDE);
        let mut lowest = [f64::INFINITY; 3];
        let mut highest = [f64::NEG_INFINITY; 3];
        for p in points {
            for axis in 0..3 {
                let x = p[axis];
                lowest[axis] = if x < lowest[axis] { x } else { lowest[axis] };
                highest[axis] = if x > highest[axis] { x } else { highest[axis] };
            }
        }
        let cells = f64::from(1_u32 << levels);
        // Halves, because the extent of finite coordinates may be infinite.
        let extents = [0, 1, 2].map(|i| highest[i] / 2.0 - lowest[i] / 2.0);
        Self {
            lowest: lowest.map(|x| x / 2.0),
            extents,
            scale: extents.map(|extent| cells / extent),
            levels,
        }
    }

    /// The axis along which the box is longest.
    pub(super) fn widest_axis(self) -> usize {
        let wider = |widest, axis| {
            if self.extents[axis] > self.extents[widest] {
                axis
            } else {
                widest
            }
        };
        (1..3).fold(0, wider)
    }

    /// Along an axis, half the least coordinate of the box, and half its extent.
    pub(super) fn side(self, axis: usize) -> (f64, f64) {
        (self.lowest[axis], self.extents[axis])
    }

    /// The number of bits of a [`place`](Self::place).
    pub(super) fn bits(self) -> u32 {
        3 * self.levels
    }

    /// The place on the curve of the cell that `p` is in.
    pub(super) fn place(self, p: Point3) -> u64 {
        let last = (1_u32 << self.levels) - 1;
        let cell = [0, 1, 2].map(|i| {
            // Conversion saturates, and turns the NaN of an axis without extent into 0.
            let cell = (p[i] / 2.0 - self.lowest[i]) * self.scale[i];
            spread((cell as u32).min(last))
        });
        let cell = (cell[0] << 2) | (cell[1] << 1) | cell[2];
        let mut place = 0;
        // The state, times `CELLS`.
        let mut state = 0;
        let mut shift = 3 * self.levels;
        while shift > 0 {
            shift -= 3 * STRIDE;
            let inner = (cell >> shift) as usize % CELLS;
            let step = CURVE[state + inner] as usize;
            place = (place << (3 * STRIDE)) | (step % CELLS) as u64;
            state = step - step % CELLS;
        }
        place
    }
}

/// The lowest 21 bits of `x`, each followed by two zeros.
fn spread(x: u32) -> u64 {
    let mut x = u64::from(x);
    x = (x | (x << 32)) & 0x001f_0000_0000_ffff;
    x = (x | (x << 16)) & 0x001f_0000_ff00_00ff;
    x = (x | (x << 8)) & 0x100f_00f0_0f00_f00f;
    x = (x | (x << 4)) & 0x10c3_0c30_c30c_30c3;
    (x | (x << 2)) & 0x1249_2492_4924_9249
}

const fn curve() -> [u16; CELLS * STATES] {
    let mut table = [0; CELLS * STATES];
    let mut state = 0;
    while state < STATES {
        let mut cell = 0;
        while cell < CELLS {
            let (outer, inside) = eighth(state, cell >> 3);
            let (inner, inside) = eighth(inside, cell & 7);
            table[CELLS * state + cell] = ((outer << 3) | inner | (inside << (3 * STRIDE))) as u16;
            cell += 1;
        }
        state += 1;
    }
    table
}

/// The number on the curve of an eighth of a cube in `state = entry + 8 · axis`, and the state inside it.
const fn eighth(state: usize, eighth: usize) -> (usize, usize) {
    let (entry, axis) = (state % 8, state / 8);
    let code = rotate_right(eighth ^ entry, axis + 1);
    // The inverse of the Gray code n ^ (n >> 1).
    let number = code ^ (code >> 1) ^ (code >> 2);
    let first = if number == 0 {
        0
    } else {
        gray((number - 1) / 2 * 2)
    };
    let along = match number {
        0 => 0,
        n if n % 2 == 0 => (n - 1).trailing_ones() as usize,
        n => n.trailing_ones() as usize,
    };
    let entry = entry ^ rotate_left(first, axis + 1);
    (number, entry + 8 * ((axis + along + 1) % 3))
}

const fn gray(n: usize) -> usize {
    n ^ (n >> 1)
}

const fn rotate_left(bits: usize, by: usize) -> usize {
    let by = by % 3;
    ((bits << by) | (bits >> (3 - by))) & 7
}

const fn rotate_right(bits: usize, by: usize) -> usize {
    rotate_left(bits, 3 - by % 3)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The curve goes through every cell once, each step to a cell that shares a side.
    #[test]
    fn every_step_goes_to_a_neighbour() {
        const SIDE: usize = 16;
        let corners = [[0.0; 3], [SIDE as f64; 3]];
        let grid = Grid::over(corners.into_iter(), 4);
        assert_eq!(grid.bits(), 12);
        let mut visited = vec![None; SIDE.pow(3)];
        for cell in 0..SIDE.pow(3) {
            let cell = [cell / SIDE / SIDE, cell / SIDE % SIDE, cell % SIDE];
            let place = grid.place(cell.map(|x| x as f64 + 0.5));
            assert_eq!(visited[place as usize].replace(cell), None);
        }
        for step in visited.windows(2) {
            let [from, to] = [step[0], step[1]].map(|cell| cell.expect("all are visited"));
            let distance: usize = (0..3).map(|i| from[i].abs_diff(to[i])).sum();
            assert_eq!(distance, 1, "{from:?} {to:?}");
        }
    }

    #[test]
    fn any_finite_box_has_a_grid() {
        for extremes in [
            [[f64::MIN; 3], [f64::MAX; 3]],
            [[1.0; 3]; 2],
            [[0.0; 3], [5e-324; 3]],
        ] {
            let grid = Grid::over(extremes.into_iter(), 11);
            assert_eq!(grid.bits(), 36);
            assert!(extremes.iter().all(|&p| grid.place(p) < 1 << 36));
        }
    }
}
