//! The smallest box around sites.

use super::part::Across;
use geometry_core::Point2;

#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Extent {
    pub(super) fn of(places: impl Iterator<Item = Point2>) -> Self {
        let mut extent = Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        };
        for place in places {
            for axis in [0, 1] {
                let x = place[axis];
                extent.low[axis] = if x < extent.low[axis] {
                    x
                } else {
                    extent.low[axis]
                };
                extent.high[axis] = if x > extent.high[axis] {
                    x
                } else {
                    extent.high[axis]
                };
            }
        }
        extent
    }

    /// Whether it is one point.
    pub(super) fn is_point(&self) -> bool {
        self.low == self.high
    }

    /// Half the width and half the height, which do not overflow.
    pub(super) fn half_sides(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.high[axis] / 2.0 - self.low[axis] / 2.0)
    }

    /// The axis to divide across: that of the longer side.
    pub(super) fn longer(&self) -> Across {
        let [w, h] = self.half_sides();
        // A side of one unit in the last place of a subnormal may have no half.
        if w > h || (w == h && self.low[0] < self.high[0]) {
            Across::X
        } else {
            Across::Y
        }
    }

    /// A number that the lowest coordinate does not exceed, and the highest does.
    pub(super) fn middle(&self, across: Across) -> f64 {
        let (low, high) = (self.low[across as usize], self.high[across as usize]);
        let middle = low / 2.0 + high / 2.0;
        if low <= middle && middle < high {
            middle
        } else {
            low
        }
    }
}
