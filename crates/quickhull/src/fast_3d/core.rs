//! A body about the centre in which nearly all points lie, with a test cheaper still than that of the
//! [map](super::directions).
//!
//! The body is an ellipsoid or a box with its axes parallel to those of space, as large as the map allows: where the points of a cell w
//! from the centre satisfy n · w ≤ 1, the ellipsoid Σ (w_i / a_i)² ≤ t² lies below that plane if t |(n_i a_i)| ≤ 1, and
//! the box |w_i| ≤ t a_i if t Σ |n_i a_i| ≤ 1. The a_i are the extents of the points, as seen from the centre, and t the least
//! over all cells. Which of the two is taken depends on how many points of the sample they hold.
//!
//! Every point of the body is in some cell and below its top. With m, r, M and ε as there, planes are off by at most 32 ε M / r
//! of themselves, and so are the rounded w_i / a_i, as a_i ≥ r. Made smaller by the factor 1 - m, where m ≥ 2048 ε M / r,
//! the body lies in the interior with all that rounding takes for it.

use crate::blocks::BLOCK;
use geometry_core::Point3;

/// The kind of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    Ellipsoid,
    Box,
}

/// An ellipsoid or a box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Core {
    shape: Shape,
    centre: Point3,
    /// 1 / a_i.
    scales: Point3,
    /// t² for an ellipsoid, t for a box.
    most: f64,
}

impl Core {
    /// The largest body with these half axes, up to a factor, below all planes `normal · w ≤ 1`, made smaller by `margin`.
    pub(super) fn below(
        shape: Shape,
        centre: Point3,
        axes: Point3,
        margin: f64,
        normals: impl Iterator<Item = Point3>,
    ) -> Self {
        let heights = normals.map(|n| {
            let [x, y, z] = [0, 1, 2].map(|i| (n[i] * axes[i]).abs());
            match shape {
                Shape::Ellipsoid => x * x + y * y + z * z,
                Shape::Box => x + y + z,
            }
        });
        let highest = heights.fold(0.0, f64::max);
        Self {
            shape,
            centre,
            scales: axes.map(f64::recip),
            most: (1.0 - margin).powi(2) / highest,
        }
    }

    /// The points of a block that it does not hold, a bit for each. It never holds one with a coordinate that is not finite.
    #[inline(always)]
    pub(super) fn not_held(&self, block: &[Point3; BLOCK]) -> u64 {
        let most = self.most;
        match self.shape {
            Shape::Ellipsoid => self.beyond(block, |[x, y, z]| x * x + y * y + z * z <= most),
            Shape::Box => self.beyond(block, |[x, y, z]| {
                (x.abs() <= most) & (y.abs() <= most) & (z.abs() <= most)
            }),
        }
    }

    /// First the coordinates side by side, then the answers: the compiler computes several of each at a time.
    #[inline(always)]
    fn beyond(&self, block: &[Point3; BLOCK], holds: impl Fn(Point3) -> bool) -> u64 {
        let mut scaled = [[0.0; BLOCK]; 3];
        for (place, p) in block.iter().enumerate() {
            for axis in 0..3 {
                scaled[axis][place] = (p[axis] - self.centre[axis]) * self.scales[axis];
            }
        }
        let [x, y, z] = &scaled;
        let mut held = 0;
        for place in 0..BLOCK {
            held |= u64::from(holds([x[place], y[place], z[place]])) << place;
        }
        !held
    }
}
