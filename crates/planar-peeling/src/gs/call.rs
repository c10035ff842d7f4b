//! One call of the routine: what it works with, and what its scans have in common.

use super::arrays::{Arrays, Label};
use geometry_core::{Boundary, Points};

/// Points asked about a line before the furthest of those listed is sought: few enough that the coordinates are
/// still in the nearest cache.
pub(super) const BLOCK: usize = 128;

/// What one call works with, besides the arrays.
pub(super) struct Call<'a, K, O, B> {
    pub(super) points: Points<'a, 2>,
    pub(super) boundary: Boundary,
    pub(super) kernel: &'a K,
    pub(super) observer: &'a mut O,
    pub(super) bookkeeping: &'a mut B,
}

/// A test list whose points are in place in NWK, but not yet its length.
pub(super) struct Draft {
    pub(super) at: usize,
    pub(super) len: usize,
    pub(super) furthest: Option<usize>,
}

impl Draft {
    /// Completes the test list of from→to and puts its label on the stack.
    pub(super) fn push(self, arrays: &mut Arrays, from: u32, to: u32) {
        let at = arrays.complete(self.at, self.len, self.furthest);
        arrays.open.push(Label { from, to, at });
    }
}
