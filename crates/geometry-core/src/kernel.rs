//! The questions an algorithm may ask, and who may answer them.
//!
//! Each method of [`Kernel2`] is one question. An implementation writes the `_staged` form, which also says
//! how hard the question was ([`Stage`]); the plain form drops that, and after inlining costs nothing for it.
//!
//! | question | answer |
//! |---|---|
//! | [`orient`](Kernel2::orient) | which side of the directed line a→b is c on |
//! | [`compare_distance`](Kernel2::compare_distance) | which of p, q lies further to the left of a→b |
//! | [`compare_along`](Kernel2::compare_along) | which of p, q on the line a→b comes first |
//! | [`lexicographic`](Kernel2::lexicographic) | which of a, b comes first by x, then y |
//! | [`compare_angle`](Kernel2::compare_angle) | which of a, b has the smaller polar angle about a centre |

pub mod counted;
pub mod lifted;
pub mod perturbed;
mod perturbed_space;
pub mod space;

use crate::points::Point2;
use crate::sign::Sign;
use std::cmp::Ordering;

/// How far a kernel had to go for an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// The first evaluation, in plain floating point, was certain (or the kernel has no other).
    Filter,
    /// Adaptive multi-term arithmetic was needed.
    Adaptive,
    /// Integers scaled to one common exponent were needed.
    Integer,
}

/// The questions about points of the plane.
///
/// All points passed are finite. An exact kernel's answers are consistent with each other; a rounded
/// kernel's need not be, and an algorithm must still stop and must not panic on them.
pub trait Kernel2 {
    /// [`orient`](Self::orient), with the stage that settled it.
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage);

    /// [`compare_distance`](Self::compare_distance), with the stage that settled it.
    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage);

    /// The orientation of the triangle abc: `Positive` if c lies left of the directed line a→b.
    #[inline(always)]
    fn orient(&self, a: Point2, b: Point2, c: Point2) -> Sign {
        self.orient_staged(a, b, c).0
    }

    /// Compares the signed distances of p and q from the directed line a→b, positive to the left.
    ///
    /// `Greater` means that p lies further to the left (or less far to the right) than q; `Equal` that pq is
    /// parallel to ab.
    #[inline(always)]
    fn compare_distance(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        self.compare_distance_staged(a, b, p, q).0
    }

    /// [`compare_distance`](Self::compare_distance) with ties broken along the line: of two points equally
    /// far, the one met first when going from a to b counts as the further.
    ///
    /// The maximum over a set is therefore an extreme point of it, not merely a boundary point. `Equal` is
    /// left for copies of one point.
    #[inline(always)]
    fn compare_distance_then_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        self.compare_distance(a, b, p, q)
            .then_with(|| self.compare_along(a, b, q, p))
    }

    /// Compares the places of p and q along the direction a→b, for p and q on one line parallel to ab.
    ///
    /// `Less` means that p comes before q. a and b must differ.
    #[inline]
    fn compare_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        match self.lexicographic(a, b) {
            Ordering::Greater => self.lexicographic(q, p),
            _ => self.lexicographic(p, q),
        }
    }

    /// Compares by x, then by y. `Equal` exactly for copies of one point (0.0 and -0.0 are the same).
    #[inline(always)]
    fn lexicographic(&self, a: Point2, b: Point2) -> Ordering {
        lexicographic(a, b)
    }

    /// Compares the polar angles of a and b about `center`, from the direction of the negative y axis
    /// (exclusive) anticlockwise once round: right half-plane first, then straight up, then the left
    /// half-plane, then straight down. Points in one direction are `Equal`; `center` itself precedes all.
    #[inline]
    fn compare_angle(&self, center: Point2, a: Point2, b: Point2) -> Ordering {
        let half = |p: Point2| match self.lexicographic(p, center) {
            Ordering::Equal => 0,
            Ordering::Greater => 1,
            Ordering::Less => 2,
        };
        half(a).cmp(&half(b)).then_with(|| {
            if half(a) == 0 {
                Ordering::Equal
            } else {
                self.orient(center, b, a).ordering()
            }
        })
    }
}

/// The order by x, then y, with the two zeros equal. Total on finite points.
#[inline(always)]
pub fn lexicographic(a: Point2, b: Point2) -> Ordering {
    if a[0] < b[0] {
        Ordering::Less
    } else if a[0] > b[0] {
        Ordering::Greater
    } else if a[1] < b[1] {
        Ordering::Less
    } else if a[1] > b[1] {
        Ordering::Greater
    } else {
        Ordering::Equal
    }
}

/// The in-circle question.
pub trait InCircle {
    /// [`in_circle`](Self::in_circle), with the stage that settled it.
    fn in_circle_staged(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage);

    /// `Positive` if d lies inside the circle through a, b, c taken anticlockwise, `Negative` outside,
    /// `Zero` on it (or if a, b, c, d are collinear). The sign flips if abc is clockwise.
    #[inline(always)]
    fn in_circle(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> Sign {
        self.in_circle_staged(a, b, c, d).0
    }
}

impl<K: InCircle + ?Sized> InCircle for &K {
    #[inline(always)]
    fn in_circle_staged(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> (Sign, Stage) {
        (**self).in_circle_staged(a, b, c, d)
    }
}

impl<K: Kernel2 + ?Sized> Kernel2 for &K {
    #[inline(always)]
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        (**self).orient_staged(a, b, c)
    }
    #[inline(always)]
    fn orient(&self, a: Point2, b: Point2, c: Point2) -> Sign {
        (**self).orient(a, b, c)
    }
    #[inline(always)]
    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        (**self).compare_distance_staged(a, b, p, q)
    }
    #[inline(always)]
    fn compare_distance(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        (**self).compare_distance(a, b, p, q)
    }
    #[inline(always)]
    fn compare_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        (**self).compare_along(a, b, p, q)
    }
    #[inline(always)]
    fn lexicographic(&self, a: Point2, b: Point2) -> Ordering {
        (**self).lexicographic(a, b)
    }
    #[inline(always)]
    fn compare_angle(&self, center: Point2, a: Point2, b: Point2) -> Ordering {
        (**self).compare_angle(center, a, b)
    }
}
