//! An octagon inside the polygon that is cheap to test: its sides are level, upright, and along two diagonals.
//!
//! ```text
//!          ______                 least[0] < x          < most[0]
//!        /        \               least[1] < y          < most[1]
//!       |          |              least[2] < s x + y    < most[2]
//!       |          |              least[3] < s x - y    < most[3]
//!        \ ______ /               s a power of two near height / width
//! ```
//!
//! Eight comparisons and three operations a point, where a polygon needs five operations for each edge. Most points
//! need no other test.
//!
//! # Why it is inside
//!
//! x, y and s x are exact (but for an underflow of 2⁻¹⁰⁷⁵), and a computed s x ± y is off by at most u times its magnitude.
//! So every point that passes lies in the exact octagon with its diagonal bounds moved out by 4 u times the larger
//! bound's magnitude, rounding included. If each level and upright side of that octagon is a segment, the octagon is the
//! convex hull of their eight ends: a corner of two diagonals would be extreme in x or y, and so lie on a side. The
//! ends are found with an error below u M a coordinate, one rounded difference each, and the polygon contains all points
//! so near to them ([`Polygon::contains_about`]), hence the octagon. What is infinite or NaN fails a comparison.

use super::polygon::{Corners, Polygon};
use super::region::{BLOCK, Block, Region, lesser};
use geometry_core::Point2;

/// Axes: x, y and the two diagonals.
const AXES: usize = 4;

/// Sets longer than 2²⁰ times their width have none.
const LONGEST: i32 = 20;

/// The octagon.
#[derive(Debug)]
pub(super) struct Octagon {
    s: f64,
    least: [f64; AXES],
    most: [f64; AXES],
}

impl Octagon {
    /// The octagon around the corners, shrunk about the centre until it lies inside their polygon; none if that fails.
    pub(super) fn inside(polygon: &Polygon, corners: &Corners, centre: Point2) -> Option<Self> {
        let around = Self::around(corners)?;
        let room = polygon.room(centre, &around.ends()) * (1.0 - f64::EPSILON.sqrt());
        if room.is_nan() || room <= 0.0 {
            return None;
        }
        let along = values(around.s, centre);
        let shrink = |bounds: [f64; AXES]| -> [f64; AXES] {
            std::array::from_fn(|axis| along[axis] + room * (bounds[axis] - along[axis]))
        };
        let octagon = Self {
            s: around.s,
            least: shrink(around.least),
            most: shrink(around.most),
        };
        octagon.is_inside(polygon).then_some(octagon)
    }

    pub(super) fn around(corners: &Corners) -> Option<Self> {
        let [width, height] = corners.extents();
        let exponent = |x: f64| (x.to_bits() >> 52) as i32;
        let slope = exponent(height) - exponent(width);
        if slope.abs() > LONGEST {
            return None;
        }
        let s = f64::from_bits(((1023 + slope) as u64) << 52);
        let mut around = Self {
            s,
            least: [f64::INFINITY; AXES],
            most: [f64::NEG_INFINITY; AXES],
        };
        for &corner in corners.as_slice() {
            for (axis, value) in values(s, corner).into_iter().enumerate() {
                around.least[axis] = around.least[axis].min(value);
                around.most[axis] = around.most[axis].max(value);
            }
        }
        Some(around)
    }

    /// Whether every point that passes the test is strictly inside the polygon.
    pub(super) fn is_inside(&self, polygon: &Polygon) -> bool {
        let mut outer = Self { ..*self };
        for axis in [2, 3] {
            let slack = 2.0 * f64::EPSILON * self.least[axis].abs().max(self.most[axis].abs());
            outer.least[axis] -= slack;
            outer.most[axis] += slack;
        }
        let ends = outer.ends();
        let (pairs, _) = ends.as_chunks::<2>();
        let is_segment = |&[a, b]: &[Point2; 2]| {
            let magnitude = ends
                .as_flattened()
                .iter()
                .fold(0.0, |most: f64, x| most.max(x.abs()));
            b[0] - a[0] + (b[1] - a[1]) > 8.0 * f64::EPSILON * magnitude
        };
        pairs.iter().all(is_segment) && polygon.contains_about(&ends)
    }

    /// The ends of the two upright sides, each from below, and of the two level ones, each from the left.
    pub(super) fn ends(&self) -> [Point2; 8] {
        let Self { s, least, most } = *self;
        let upright = |x: f64| {
            let low = least[1].max(least[2] - s * x).max(s * x - most[3]);
            let high = most[1].min(most[2] - s * x).min(s * x - least[3]);
            [[x, low], [x, high]]
        };
        let level = |y: f64| {
            let low = least[0].max((least[2] - y) / s).max((least[3] + y) / s);
            let high = most[0].min((most[2] - y) / s).min((most[3] + y) / s);
            [[low, y], [high, y]]
        };
        let [[a, b], [c, d]] = [least[0], most[0]].map(upright);
        let [[e, f], [g, h]] = [least[1], most[1]].map(level);
        [a, b, c, d, e, f, g, h]
    }
}

/// The values of a point along the four axes.
#[inline(always)]
fn values(s: f64, [x, y]: Point2) -> [f64; AXES] {
    [x, y, s * x + y, s * x - y]
}

impl Region for Octagon {
    /// The least of the differences that the comparisons are about. Their signs are exact. The sum of the coordinates
    /// comes first, as it is not finite if one of them is not, and a NaN stays the least.
    #[inline(always)]
    #[allow(clippy::needless_range_loop)] // three arrays side by side
    fn measure(&self, block: &Block) -> [f64; BLOCK] {
        let Self { s, least, most } = self;
        let mut measures = [0.0; BLOCK];
        for i in 0..BLOCK {
            let [x, y, sum, difference] = values(*s, [block.x[i], block.y[i]]);
            let mut measure = sum - least[2];
            measure = lesser(most[2] - sum, measure);
            measure = lesser(difference - least[3], measure);
            measure = lesser(most[3] - difference, measure);
            measure = lesser(x - least[0], measure);
            measure = lesser(most[0] - x, measure);
            measure = lesser(y - least[1], measure);
            measures[i] = lesser(most[1] - y, measure);
        }
        measures
    }

    fn bound(&self) -> f64 {
        0.0
    }
}
