//! A kernel that never answers zero for distinct points: symbolic perturbation by lexicographic rank.
//!
//! Simulation of simplicity (Edelsbrunner and Mücke 1990) moves point i by infinitesimals that depend on its
//! index, so the answers depend on the order of the input. Here the infinitesimals depend on the point's
//! lexicographic rank instead: the point of rank r moves by (-δᵣ, +εᵣ) with
//!
//! ```text
//!     ε₀ ≫ δ₀ ≫ ε₁ ≫ δ₁ ≫ …  > 0
//! ```
//!
//! and the answers depend on the coordinates alone. The signs are chosen so that the lexicographic order of
//! the moved points is that of the points themselves (of two points with one x, the lower has the lower rank
//! and moves further left), so all questions stay consistent with each other.
//!
//! What the perturbation does: wherever a determinant vanishes, the leading term is the derivative in the
//! coordinates of the point of lowest rank. Worked out, each case is one lexicographic comparison:
//!
//! - three distinct collinear points turn left if they are in lexicographic order, and otherwise by the
//!   parity of the permutation that sorts them: a straight row bends into a chain that is convex from below;
//! - two points equally far from a→b compare by the direction of ab (or of pq) against the lexicographic
//!   order.
//!
//! Copies of one point move together and still give zero.

use super::{Kernel2, Stage, lexicographic};
use crate::points::Point2;
use crate::sign::Sign;
use std::cmp::Ordering;

/// Answers as `K` does, and where `K` sees a degeneracy of distinct points, as if they had been moved by
/// infinitesimals that depend on their lexicographic ranks.
///
/// ```
/// use geometry_core::{Exact, Kernel2, Perturbed, Sign};
/// let kernel = Perturbed(Exact);
/// let [a, b, c] = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
/// assert_eq!(kernel.orient(a, b, c), Sign::Positive);
/// assert_eq!(kernel.orient(c, b, a), Sign::Negative);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Perturbed<K>(pub K);

impl<K: Kernel2> Kernel2 for Perturbed<K> {
    fn orient_staged(&self, a: Point2, b: Point2, c: Point2) -> (Sign, Stage) {
        let (sign, stage) = self.0.orient_staged(a, b, c);
        let sign = if sign.is_zero() {
            parity(a, b, c)
        } else {
            sign
        };
        (sign, stage)
    }

    fn compare_distance_staged(
        &self,
        a: Point2,
        b: Point2,
        p: Point2,
        q: Point2,
    ) -> (Ordering, Stage) {
        let (ordering, stage) = self.0.compare_distance_staged(a, b, p, q);
        if ordering.is_ne() || p == q {
            return (ordering, stage);
        }
        let (p_on_line, q_on_line) = (p == a || p == b, q == a || q == b);
        let ordering = match (p_on_line, q_on_line) {
            (true, true) => Ordering::Equal,
            (true, false) => (-parity(a, b, q)).ordering(),
            (false, true) => parity(a, b, p).ordering(),
            (false, false) => by_lowest_rank(a, b, p, q),
        };
        (ordering, stage)
    }

    fn compare_along(&self, a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
        self.0.compare_along(a, b, p, q)
    }

    fn lexicographic(&self, a: Point2, b: Point2) -> Ordering {
        self.0.lexicographic(a, b)
    }
}

/// The parity of the permutation that sorts a, b, c; `Zero` if two of them are copies.
fn parity(a: Point2, b: Point2, c: Point2) -> Sign {
    Sign::from(lexicographic(b, a))
        * Sign::from(lexicographic(c, b))
        * Sign::from(lexicographic(c, a))
}

/// The leading term of (b-a) × (p-q), which vanishes, for p and q other than a and b.
fn by_lowest_rank(a: Point2, b: Point2, p: Point2, q: Point2) -> Ordering {
    let lowest_of_line = if lexicographic(a, b).is_le() { a } else { b };
    let lowest_of_pair = if lexicographic(p, q).is_le() { p } else { q };
    if lexicographic(lowest_of_line, lowest_of_pair).is_lt() {
        let leading = lexicographic(p, q);
        if lowest_of_line == a {
            leading
        } else {
            leading.reverse()
        }
    } else {
        let leading = lexicographic(b, a);
        if lowest_of_pair == p {
            leading
        } else {
            leading.reverse()
        }
    }
}
