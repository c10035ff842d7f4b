//! Whether four points were found coplanar on the way.
//!
//! An edge of the surface was once on the rim of what an inserted point sees, unless both its triangles belong to the
//! cone of one point. There the point was asked about the triangle beyond; if it was not in its plane, the edge is
//! bent, and need not be asked about again when coplanar triangles are merged.

use geometry_core::{Axis, Basis, Edges, Kernel3, Point3, Sign, Stage};
use std::cell::Cell;
use std::cmp::Ordering;

/// Answers as `K` does, and notes whether an orientation was ever zero.
pub(super) struct Noting<'a, K> {
    pub(super) kernel: &'a K,
    met_zero: Cell<bool>,
}

impl<'a, K> Noting<'a, K> {
    pub(super) fn new(kernel: &'a K) -> Self {
        Self {
            kernel,
            met_zero: Cell::new(false),
        }
    }

    /// What the answers tell of the edges of the surface.
    pub(super) fn edges(&self) -> Edges {
        if self.met_zero.get() {
            Edges::Unknown
        } else {
            Edges::BentAtRims
        }
    }
}

impl<K: Kernel3> Kernel3 for Noting<'_, K> {
    fn basis(&self) -> Basis {
        self.kernel.basis()
    }

    #[inline(always)]
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        let (sign, stage) = self.kernel.orient3_staged(a, b, c, d);
        if sign.is_zero() {
            self.met_zero.set(true);
        }
        (sign, stage)
    }

    #[inline(always)]
    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        self.kernel.compare_height_staged(plane, p, q)
    }

    #[inline(always)]
    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        self.kernel.shadow_staged(axis, a, b, c)
    }

    #[inline(always)]
    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        self.kernel.lexicographic3(a, b)
    }
}
