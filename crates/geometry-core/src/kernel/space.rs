//! The questions about points of space.
//!
//! | question | answer |
//! |---|---|
//! | [`orient3`](Kernel3::orient3) | which side of the plane abc is d on |
//! | [`compare_height`](Kernel3::compare_height) | which of p, q lies higher over the plane abc |
//! | [`shadow`](Kernel3::shadow) | the orientation of the triangle abc seen along an axis |
//! | [`lexicographic3`](Kernel3::lexicographic3) | which of a, b comes first by x, then y, then z |

use super::{Stage, lexicographic};
use crate::points::{Point2, Point3};
use crate::sign::Sign;
use std::cmp::Ordering;

/// An axis of space, along which points cast shadows on the plane of the other two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Axis {
    /// Shadows are (y, z).
    X,
    /// Shadows are (z, x).
    Y,
    /// Shadows are (x, y).
    Z,
}

impl Axis {
    /// The three axes.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// The shadow of `p`, as it is seen from the far positive end of this axis: its plane has the next axis to
    /// the right and the one after that up, so that the three orientations of the shadows of a triangle abc are
    /// the signs of the three coordinates of (b-a) × (c-a).
    #[inline(always)]
    pub fn shadow_of(self, p: Point3) -> Point2 {
        match self {
            Axis::X => [p[1], p[2]],
            Axis::Y => [p[2], p[0]],
            Axis::Z => [p[0], p[1]],
        }
    }
}

/// What a kernel's answers are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Basis {
    /// The coordinates as they are, exactly: an algorithm may answer by arithmetic of its own where it has a proof.
    Coordinates,
    /// Something else, such as lifted points or rounded arithmetic: an algorithm must ask.
    Other,
}

/// The questions about points of space. All points passed are finite.
pub trait Kernel3 {
    /// What the answers are about.
    fn basis(&self) -> Basis {
        Basis::Other
    }

    /// [`orient3`](Self::orient3), with the stage that settled it.
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage);

    /// [`compare_height`](Self::compare_height), with the stage that settled it.
    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage);

    /// [`shadow`](Self::shadow), with the stage that settled it.
    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage);

    /// The orientation of the tetrahedron abcd: the sign of (b-a) × (c-a) · (d-a). `Positive` if, seen from
    /// d, the triangle abc runs anticlockwise.
    #[inline(always)]
    fn orient3(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> Sign {
        self.orient3_staged(a, b, c, d).0
    }

    /// Compares the signed heights of p and q over the plane abc, positive on the side from which abc runs
    /// anticlockwise. `Equal` means that pq is parallel to the plane.
    #[inline(always)]
    fn compare_height(&self, plane: [Point3; 3], p: Point3, q: Point3) -> Ordering {
        self.compare_height_staged(plane, p, q).0
    }

    /// The orientation of the shadows of a, b, c along an axis: the sign of that coordinate of (b-a) × (c-a).
    #[inline(always)]
    fn shadow(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> Sign {
        self.shadow_staged(axis, a, b, c).0
    }

    /// Whether a, b, c lie on one line: all three shadows are flat.
    fn collinear3(&self, a: Point3, b: Point3, c: Point3) -> bool {
        Axis::ALL
            .iter()
            .all(|&axis| self.shadow(axis, a, b, c).is_zero())
    }

    /// Compares by x, then y, then z. `Equal` exactly for copies of one point.
    #[inline(always)]
    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        lexicographic3(a, b)
    }
}

/// The order by x, then y, then z, with the two zeros equal. Total on finite points.
#[inline(always)]
pub fn lexicographic3(a: Point3, b: Point3) -> Ordering {
    lexicographic([a[0], a[1]], [b[0], b[1]])
        .then_with(|| a[2].partial_cmp(&b[2]).unwrap_or(Ordering::Equal))
}

impl<K: Kernel3 + ?Sized> Kernel3 for &K {
    fn basis(&self) -> Basis {
        (**self).basis()
    }
    #[inline(always)]
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        (**self).orient3_staged(a, b, c, d)
    }
    #[inline(always)]
    fn orient3(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> Sign {
        (**self).orient3(a, b, c, d)
    }
    #[inline(always)]
    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        (**self).compare_height_staged(plane, p, q)
    }
    #[inline(always)]
    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        (**self).shadow_staged(axis, a, b, c)
    }
    #[inline(always)]
    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        (**self).lexicographic3(a, b)
    }
}
