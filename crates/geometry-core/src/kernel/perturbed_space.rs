//! [`Perturbed`] in space. The point of rank r moves by (-αᵣ, +βᵣ, +γᵣ) with
//!
//! ```text
//!     γ₀ ≫ β₀ ≫ α₀ ≫ γ₁ ≫ β₁ ≫ α₁ ≫ …  > 0,   each much smaller than every product of those before it
//! ```
//!
//! which is the perturbation of the plane in the shadows along z. A determinant that vanishes takes the sign of its
//! first derivative, in that order, that does not; the derivative in a coordinate of one point is the shadow of the
//! other three, and the second derivatives are differences of coordinates.

use super::Stage;
use super::perturbed::Perturbed;
use super::space::{Axis, Kernel3};
use crate::points::{Point2, Point3};
use crate::sign::Sign;
use std::cmp::Ordering;

impl<K: Kernel3> Kernel3 for Perturbed<K> {
    #[inline(always)]
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        let (sign, stage) = self.0.orient3_staged(a, b, c, d);
        if sign.is_zero() {
            (orient_moved(&self.0, [a, b, c, d]), stage)
        } else {
            (sign, stage)
        }
    }

    /// Heights are compared as they are: which of two equally high points counts as higher changes no hull.
    #[inline(always)]
    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        self.0.compare_height_staged(plane, p, q)
    }

    #[inline(always)]
    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let (sign, stage) = self.0.shadow_staged(axis, a, b, c);
        if sign.is_zero() {
            (shadow_moved(&self.0, axis, [a, b, c]), stage)
        } else {
            (sign, stage)
        }
    }

    #[inline(always)]
    fn lexicographic3(&self, a: Point3, b: Point3) -> Ordering {
        self.0.lexicographic3(a, b)
    }
}

/// Sorts the points by `kernel`'s lexicographic order; returns the parity of the permutation, `Zero` if two are
/// copies.
fn sorted<K: Kernel3, const N: usize>(kernel: &K, points: &mut [Point3; N]) -> Sign {
    let mut parity = Sign::Positive;
    for end in 1..N {
        for i in (0..end).rev() {
            match kernel.lexicographic3(points[i], points[i + 1]) {
                Ordering::Less => break,
                Ordering::Equal => return Sign::Zero,
                Ordering::Greater => {
                    points.swap(i, i + 1);
                    parity = -parity;
                }
            }
        }
    }
    parity
}

/// The sign of the vanishing orientation of four points once they are moved.
#[cold]
fn orient_moved<K: Kernel3>(kernel: &K, mut points: [Point3; 4]) -> Sign {
    let parity = sorted(kernel, &mut points);
    if parity.is_zero() {
        return Sign::Zero;
    }
    let [a, b, c, d] = points;
    // γ₀, β₀, α₀: the first point moves.
    for (axis, direction) in [
        (Axis::Z, Sign::Negative),
        (Axis::Y, Sign::Negative),
        (Axis::X, Sign::Positive),
    ] {
        let shadow = kernel.shadow(axis, b, c, d);
        if !shadow.is_zero() {
            return parity * direction * shadow;
        }
    }
    // b, c, d are collinear. γ₁: the second point moves up.
    let shadow = kernel.shadow(Axis::Z, a, c, d);
    if !shadow.is_zero() {
        return parity * shadow;
    }
    // γ₁β₀ and γ₁α₀: d - c in x, in y; not negative, because c precedes d.
    if c[0] != d[0] || c[1] != d[1] {
        return parity;
    }
    // β₁, then β₁α₀: d - c in z, positive, while the first point moves left.
    let shadow = kernel.shadow(Axis::Y, a, c, d);
    if shadow.is_zero() {
        -parity
    } else {
        parity * shadow
    }
}

/// The sign of the vanishing orientation of three shadows once the points are moved.
#[cold]
fn shadow_moved<K: Kernel3>(kernel: &K, axis: Axis, mut points: [Point3; 3]) -> Sign {
    let parity = sorted(kernel, &mut points);
    if parity.is_zero() {
        return Sign::Zero;
    }
    let [a, b, c]: [Point2; 3] = points.map(|p| axis.shadow_of(p));
    // How the shadow's two coordinates move, and which of them moves further.
    let (moves, further) = match axis {
        Axis::X => ([Sign::Positive, Sign::Positive], 1),
        Axis::Y => ([Sign::Positive, Sign::Negative], 0),
        Axis::Z => ([Sign::Negative, Sign::Positive], 1),
    };
    let difference = |p: f64, q: f64| p.partial_cmp(&q).map_or(Sign::Zero, Sign::from);
    // The derivatives of (b-a) × (c-a) in the coordinates of a, and of b.
    let in_a = [difference(b[1], c[1]), difference(c[0], b[0])];
    let in_b = [difference(c[1], a[1]), difference(a[0], c[0])];
    let mixed = [Sign::Negative, Sign::Positive];
    let terms = [
        moves[further] * in_a[further],
        moves[1 - further] * in_a[1 - further],
        moves[further] * in_b[further],
        moves[further] * moves[1 - further] * mixed[further],
    ];
    let leading = terms.into_iter().find(|term| !term.is_zero());
    parity * leading.unwrap_or(Sign::Zero)
}
