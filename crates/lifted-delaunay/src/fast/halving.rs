//! Dividing sites in two by one coordinate, so that a line of the other axis separates them strictly.
//!
//! Copies of a point have the same coordinates and are never divided.

use super::part::Across;
use super::site::{Site, Sited};
use geometry_core::Point2;

/// Sets of more sites than this are divided at the median if the middle of their box leaves too few on one side.
const UNEVEN: usize = 32;

/// The smallest box around points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Extent {
    #[inline(always)]
    pub(super) fn of(places: impl Iterator<Item = Point2>) -> Self {
        let mut extent = Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        };
        for place in places {
            for axis in [0, 1] {
                let (x, low, high) = (place[axis], extent.low[axis], extent.high[axis]);
                extent.low[axis] = if x < low { x } else { low };
                extent.high[axis] = if x > high { x } else { high };
            }
        }
        extent
    }

    /// Whether all are copies of one point.
    pub(super) fn is_point(&self) -> bool {
        self.low == self.high
    }

    /// The width and height, rounded.
    pub(super) fn sides(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.high[axis] - self.low[axis])
    }

    /// Half the width and half the height, which do not overflow.
    pub(super) fn half_sides(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.high[axis] / 2.0 - self.low[axis] / 2.0)
    }

    /// The axis of the longer side, or of a side that is not zero.
    pub(super) fn longer(&self) -> Across {
        let [width, height] = self.half_sides();
        // A side of the smallest number there is has no half.
        if width > height || (width == height && self.low[0] < self.high[0]) {
            Across::X
        } else {
            Across::Y
        }
    }

    /// About the middle of a side that is not zero: at least its low end, and less than its high end.
    fn middle(&self, across: Across) -> f64 {
        let (low, high) = (self.low[across as usize], self.high[across as usize]);
        let middle = low / 2.0 + high / 2.0;
        if low <= middle && middle < high {
            middle
        } else {
            low
        }
    }
}

/// Divides sites that are not all copies of one point: returns how many are in the first half, and across which axis it
/// lies. Each half has at least one site; of many sites, at least an eighth, unless more share a coordinate.
#[inline(always)]
pub(super) fn halve(sites: &mut [Site], extent: &Extent) -> (usize, Across) {
    let across = extent.longer();
    let first = partition(sites, across, extent.middle(across));
    let smaller = first.min(sites.len() - first);
    if sites.len() > UNEVEN && smaller < sites.len() / 8 {
        return halve_at_median(sites, extent);
    }
    (first, across)
}

/// As [`halve`], at the median of the coordinates.
pub(super) fn halve_at_median(sites: &mut [Site], extent: &Extent) -> (usize, Across) {
    let across = extent.longer();
    let axis = across as usize;
    let by_axis = |a: &Site, b: &Site| a.at()[axis].total_cmp(&b.at()[axis]);
    let half = sites.len() / 2;
    let (_, median, _) = sites.select_nth_unstable_by(half, by_axis);
    let median = median.at()[axis];
    let most = if median < extent.high[axis] {
        median
    } else {
        median.next_down()
    };
    (partition(sites, across, most), across)
}

/// Moves the sites whose coordinate is at most `most` to the front, and returns how many. Without branches.
#[allow(clippy::manual_swap)] // the site is looked at in between, from a register
#[inline(always)]
fn partition(sites: &mut [Site], across: Across, most: f64) -> usize {
    let mut front = 0;
    for i in 0..sites.len() {
        let site = sites[i];
        sites[i] = sites[front];
        sites[front] = site;
        front += usize::from(site.at()[across as usize] <= most);
    }
    front
}
