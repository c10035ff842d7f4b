//! A triangulation of some of the points, seen from outside: its extremes, from which others are joined to it.
//!
//! ```text
//!                 last by y
//!             .---*-----.
//!            /           '*  last by x          each with the edge to the outside in the
//!  first    *             |                     ghost of the edge that leaves it anticlockwise
//!   by x     '.____*_____.'
//!              first by y
//! ```
//!
//! Extremes, with ties broken by the other coordinate, are corners: the hull turns there. So it passes each once, also where all
//! points are collinear.

use super::faces::{EDGES_PER_FACE, FACES_PER_VERTEX, NONE, edge_of, next};
use super::site::{Site, Sited};

/// The axis across which a set is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Across {
    /// Into left and right.
    X = 0,
    /// Into lower and upper.
    Y = 1,
}

/// A vertex of the hull, and the edge from it to the outside in the ghost of the edge of the hull that leaves it anticlockwise.
/// There is none, [`NONE`], if there is no other vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    pub(super) out: u32,
}

impl Corner {
    /// Those of a hull whose [ghosts](super::faces::Faces::surround) begin at this face.
    #[inline(always)]
    pub(super) fn around<const N: usize>(hull: [u32; N], ghosts: u32) -> [Self; N] {
        let mut out = next(edge_of(ghosts));
        hull.map(|vertex| {
            let corner = Self { vertex, out };
            out += EDGES_PER_FACE;
            corner
        })
    }
}

/// The extremes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// First by x, then y; and first by y, then x.
    pub(super) first: [Corner; 2],
    /// Last by x, then y; and last by y, then x.
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

    /// The part with these corners.
    #[inline(always)]
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

    /// The extremes of the union with `other`, which is to the right of `self`, or above it. Of two that are equally far
    /// along the dividing line, the one of `self` comes first.
    #[inline(always)]
    pub(super) fn joined(&self, other: &Self, sites: &[Site], across: Across) -> Self {
        let mut joined = Self {
            first: self.first,
            last: other.last,
        };
        let along = 1 - across as usize;
        let coordinate = |corner: Corner| sites[corner.vertex as usize].at()[along];
        if coordinate(other.first[along]) < coordinate(self.first[along]) {
            joined.first[along] = other.first[along];
        }
        if coordinate(other.last[along]) < coordinate(self.last[along]) {
            joined.last[along] = self.last[along];
        }
        joined
    }

    /// The same part, [adopted](super::faces::Faces::adopt) by those of the vertices up to `first`.
    pub(super) fn moved(mut self, first: u32) -> Self {
        for corner in self.first.iter_mut().chain(&mut self.last) {
            corner.vertex += first;
            if corner.out != NONE {
                corner.out += edge_of(FACES_PER_VERTEX as u32 * first);
            }
        }
        self
    }

    /// Notes that the edge from `vertex` to the outside is now `out`.
    #[inline(always)]
    pub(super) fn turn(&mut self, vertex: u32, out: u32) {
        for corner in self.first.iter_mut().chain(&mut self.last) {
            if corner.vertex == vertex {
                corner.out = out;
            }
        }
    }

    /// The width and height, rounded.
    #[inline(always)]
    pub(super) fn sides(&self, sites: &[Site]) -> [f64; 2] {
        let coordinate = |corner: Corner, axis: usize| sites[corner.vertex as usize].at()[axis];
        [0, 1].map(|axis| coordinate(self.last[axis], axis) - coordinate(self.first[axis], axis))
    }
}

#[inline(always)]
fn comes_before(sites: &[Site], a: Corner, b: Corner, axis: usize) -> bool {
    let [p, q] = [a, b].map(|corner| sites[corner.vertex as usize].at());
    p[axis] < q[axis] || (p[axis] == q[axis] && p[1 - axis] < q[1 - axis])
}
