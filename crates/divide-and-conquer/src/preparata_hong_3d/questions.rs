//! What a merge asks about points.

use geometry_core::{Axis, Kernel3, Perturbed, Point3, Sign};

/// The edge that the wrap has reached, and what it left behind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bridge {
    /// The end in the first half.
    pub(crate) a: Point3,
    /// The end in the second half.
    pub(crate) b: Point3,
    /// The third corner of the facet before.
    pub(crate) behind: Point3,
}

/// Who answers a merge.
pub(crate) trait Questions {
    /// On which side of the line from the shadow of a to that of b on the x-y plane the shadow of c is.
    fn shadow(&self, a: Point3, b: Point3, c: Point3) -> Sign;

    /// Whether the half-plane from the bridge through y makes a larger angle with the facet behind than the one
    /// through x.
    fn is_beyond(&self, bridge: &Bridge, x: Point3, y: Point3) -> bool;
}

/// The answers of a kernel, perturbed: no angle is computed, and the facet behind is not needed.
pub(crate) struct Oriented<K>(pub(crate) Perturbed<K>);

impl<K: Kernel3> Questions for Oriented<K> {
    #[inline(always)]
    fn shadow(&self, a: Point3, b: Point3, c: Point3) -> Sign {
        self.0.shadow(Axis::Z, a, b, c)
    }

    /// All candidates are on the inner side of the facet behind, within a half-turn about the bridge, and there the
    /// one through y lies further exactly if y is outside the facet b a x.
    #[inline(always)]
    fn is_beyond(&self, bridge: &Bridge, x: Point3, y: Point3) -> bool {
        self.0.orient3(bridge.b, bridge.a, x, y).is_positive()
    }
}
