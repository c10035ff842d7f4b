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

    /// How many of the points it holds.
    pub(super) fn count(&self, points: &[Point3]) -> usize {
        let mut outside = [0; BLOCK];
        let blocks = points.chunks(BLOCK);
        let kept: usize = blocks.map(|block| self.outside(block, &mut outside)).sum();
        points.len() - kept
    }

    /// Writes the places of the points of a block that it does not hold, and returns how many these are.
    #[inline(always)]
    pub(super) fn outside(&self, block: &[Point3], places: &mut [u8; BLOCK]) -> usize {
        match self.shape {
            Shape::Ellipsoid => self.beyond(block, places, |[x, y, z]| x * x + y * y + z * z),
            Shape::Box => self.beyond(block, places, |w| {
                let [x, y, z] = w.map(f64::abs);
                let larger = if x > y { x } else { y };
                if larger > z { larger } else { z }
            }),
        }
    }

    /// First the measures, which the compiler computes several at a time, then the places, without a branch.
    #[inline(always)]
    fn beyond(
        &self,
        block: &[Point3],
        places: &mut [u8; BLOCK],
        measure: impl Fn(Point3) -> f64,
    ) -> usize {
        let mut measures = [0.0; BLOCK];
        for (slot, p) in measures.iter_mut().zip(block) {
            *slot = measure([0, 1, 2].map(|i| (p[i] - self.centre[i]) * self.scales[i]));
        }
        let mut kept = 0;
        for (place, &measure) in (0..).zip(&measures[..block.len().min(BLOCK)]) {
            places[kept] = place;
            // Not `measure > most`: an overflow may have made it NaN.
            let is_held = measure <= self.most;
            kept += usize::from(!is_held);
        }
        kept
    }
}

/// The number of points looked at together.
pub(super) const BLOCK: usize = 64;

/// The places of all points of a block.
pub(super) fn all_places() -> [u8; BLOCK] {
    std::array::from_fn(|place| place as u8)
}
