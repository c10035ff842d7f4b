//! A triangulation of some of the points, seen from outside: its extremes.

use super::Site;
use super::rings::NONE;
use std::cmp::Ordering;

/// The axis across which a set is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Across {
    /// Into left and right.
    X = 0,
    /// Into lower and upper.
    Y = 1,
}

/// A vertex of the hull, and the edge of the hull that leaves it anticlockwise; [`NONE`] where there is no edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    pub(super) out: u32,
}

/// The corners that come first and last by x, then y; and first and last by y, then x.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) first: [Corner; 2],
    pub(super) last: [Corner; 2],
}

impl Part {
    /// One vertex.
    pub(super) fn point(vertex: u32) -> Self {
        let corner = Corner { vertex, out: NONE };
        Self {
            first: [corner; 2],
            last: [corner; 2],
        }
    }

    /// The part whose extremes are among `corners`.
    pub(super) fn of(sites: &[Site], corners: &[Corner]) -> Self {
        let mut part = Self {
            first: [corners[0]; 2],
            last: [corners[0]; 2],
        };
        for &corner in &corners[1..] {
            for axis in [0, 1] {
                if comes_before(sites, corner, part.first[axis], axis) {
                    part.first[axis] = corner;
                }
                if comes_before(sites, part.last[axis], corner, axis) {
                    part.last[axis] = corner;
                }
            }
        }
        part
    }

    /// The extremes of the union of two parts, `self` being the left or lower one.
    #[inline(always)]
    pub(super) fn joined(&self, other: &Self, sites: &[Site], across: Across) -> Self {
        let mut joined = Self {
            first: self.first,
            last: other.last,
        };
        let along = 1 - across as usize;
        // Of two that are equally far along, the one of `self` comes first.
        let value = |corner: Corner| sites[corner.vertex as usize].at[along];
        if value(other.first[along]) < value(self.first[along]) {
            joined.first[along] = other.first[along];
        }
        if value(other.last[along]) < value(self.last[along]) {
            joined.last[along] = self.last[along];
        }
        joined
    }

    /// The edge that leaves `vertex` on the hull is now `out`.
    #[inline(always)]
    pub(super) fn turn(&mut self, vertex: u32, out: u32) {
        for corner in self.first.iter_mut().chain(&mut self.last) {
            if corner.vertex == vertex {
                corner.out = out;
            }
        }
    }

    /// The width or height.
    #[inline(always)]
    pub(super) fn extent(&self, sites: &[Site], axis: usize) -> f64 {
        let value = |corner: Corner| sites[corner.vertex as usize].at[axis];
        value(self.last[axis]) - value(self.first[axis])
    }
}

fn comes_before(sites: &[Site], a: Corner, b: Corner, axis: usize) -> bool {
    let [p, q] = [a, b].map(|corner| sites[corner.vertex as usize].at);
    let ordering = p[axis].partial_cmp(&q[axis]);
    ordering == Some(Ordering::Less)
        || (ordering == Some(Ordering::Equal) && p[1 - axis] < q[1 - axis])
}
