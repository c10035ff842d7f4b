//! The order of points along a curve of space that an axis tells.
//!
//! Hilbert's curve is for surfaces. A row of points along a line is not in order along it: the halves of a cube are
//! entered and left where it suits the cube, so at every level some of them come the wrong way round, and with each the
//! walk goes along all the points between. Where points lie along one line, smooth enough, their order along an axis is
//! theirs along the line:
//!
//! ```text
//!     |              .--*--*         sorted by x, the ys go up and down once: along a line;
//!     |           .*'                of points of a surface they would go up and down as
//!     |   *--*--*'                   often as there are points
//!     '--------------------- x
//! ```

use super::hilbert::Grid;
use geometry_core::Point3;

/// Points that are looked at to tell a line from a surface, at most.
const SAMPLE: usize = 256;
/// Of fewer points, which are near each other in any order, nothing is told.
const FEWEST: usize = 32;
/// How often the line may go through the whole extent of each other axis.
const MOST_PASSES: f64 = 3.0;

/// An axis cut into equal parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    axis: usize,
    lowest: f64,
    /// Parts per unit of half a coordinate.
    scale: f64,
    bits: u32,
}

impl Line {
    /// The line along which the `len` points lie, if they do: the widest axis of the `grid` over them, in 2 to the power
    /// of `bits` parts.
    ///
    /// At most 32 bits.
    pub(super) fn along(
        len: usize,
        points: impl Fn(usize) -> Point3,
        grid: Grid,
        bits: u32,
    ) -> Option<Self> {
        if len < FEWEST {
            return None;
        }
        let axis = grid.widest_axis();
        let size = len.min(SAMPLE);
        let mut sample: Vec<Point3> = (0..size)
            .map(|i| points((i as u64 * len as u64 / size as u64) as usize).map(|x| x / 2.0))
            .collect();
        sample.sort_unstable_by(|p, q| p[axis].total_cmp(&q[axis]));
        let is_a_line = [(axis + 1) % 3, (axis + 2) % 3].into_iter().all(|other| {
            let steps = sample
                .windows(2)
                .map(|pair| (pair[1][other] - pair[0][other]).abs());
            let [low, high] = sample
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| {
                    [low.min(p[other]), high.max(p[other])]
                });
            steps.sum::<f64>() <= MOST_PASSES * (high - low)
        });
        is_a_line.then(|| {
            let (lowest, half_extent) = grid.side(axis);
            Self {
                axis,
                lowest,
                scale: (1_u64 << bits) as f64 / half_extent,
                bits,
            }
        })
    }

    /// The number of bits of a [`place`](Self::place).
    pub(super) fn bits(self) -> u32 {
        self.bits
    }

    /// The part of the axis that `p` is in.
    pub(super) fn place(self, p: Point3) -> u64 {
        let last = (1_u64 << self.bits) - 1;
        // As in a grid.
        (((p[self.axis] / 2.0 - self.lowest) * self.scale) as u64).min(last)
    }
}
