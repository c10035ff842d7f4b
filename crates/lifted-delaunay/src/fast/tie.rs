//! The rule for four points on one circle.
//!
//! Lift the points to the paraboloid, and lower each by an infinitesimal: the lexicographically first by ε₁, the second
//! by ε₂, and so on, with ε₁ ≫ ε₂ ≫ … > 0. No four lifted points are coplanar any more, so there is one Delaunay
//! triangulation, and it depends on the places alone. Lowering pulls: all facets around the first point of a set of cocircular
//! ones contain it. So their polygon is cut into the fan from its first corner, which is the rule of
//! [`delaunay_with`](crate::delaunay_with).
//!
//! For one question only the first of its four points matters. Let a, b, c be anticlockwise and d on their circle. It
//! lies inside exactly if its lift is below the plane of the other three.
//!
//! - If d is the first, it is lowered below the plane.
//! - If a is, the plane turns about b c. It sinks on the side of a and rises on the other. So d is inside if it is beyond b c as
//!   seen from a.
//! - Likewise for b and c.
//!
//! ```text
//!        c .---.
//!        /      \
//!       |    ____| d     with a lowered, the plane rises beyond b c: d is inside,
//!      a '.___.-'        and the diagonal is a d
//!             b
//! ```

use geometry_core::kernel::lexicographic;
use geometry_core::{Kernel2, Point2};

/// Whether d, on the circle through a, b, c, which are anticlockwise, counts as inside. All four are distinct.
#[cold]
#[inline(never)]
pub(super) fn is_inside_if_first_is_lowered(
    kernel: &impl Kernel2,
    a: Point2,
    b: Point2,
    c: Point2,
    d: Point2,
) -> bool {
    let precedes = |p: Point2, q: Point2| lexicographic(p, q).is_lt();
    // Of each pair, the first, and the side opposite to it.
    let (by_pair, [s, t]) = if precedes(a, b) {
        (a, [b, c])
    } else {
        (b, [c, a])
    };
    let (first, [s, t]) = if precedes(by_pair, c) {
        (by_pair, [s, t])
    } else {
        (c, [a, b])
    };
    precedes(d, first) || kernel.orient(s, t, d).is_negative()
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::Exact;

    /// Of a square, every corner taken as d, and the others from each on: a diagonal leads to the first corner.
    #[test]
    fn diagonals_of_a_square_lead_to_its_first_corner() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        for i in 0..4 {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| square[(i + k) % 4]);
            // Triangle abc has the diagonal ac, and d inside asks for the diagonal bd.
            let expected = b == square[0] || d == square[0];
            for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
                let inside = is_inside_if_first_is_lowered(&Exact, a, b, c, d);
                assert_eq!(inside, expected, "{a:?} {b:?} {c:?} {d:?}");
            }
        }
    }
}
