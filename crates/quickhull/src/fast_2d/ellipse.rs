//! An ellipse inside the polygon, with its axes level and upright: the cheapest test there is for sets that are round.
//!
//! ```text
//!            .--"""--.
//!          /     B     \            ((x - cx) / A)² + ((y - cy) / B)² < r²
//!         |      c - A  |
//!          \           /
//!            '--...--'
//! ```
//!
//! # Why it is inside
//!
//! Let a x + b y - c₀ be the function of an edge, positive exactly to the left, and T its value at the centre. Its least value in
//! the ellipse is T - r √((a A)² + (b B)²), so r is chosen as the least of T / √(…) over all edges, with half the polygon's
//! [bound](super::polygon) and more taken off T for its rounding. What else is rounded, in r and in the test itself, is rounded relative to
//! its size: differences, products and sums of what is positive, by less than 2⁻⁴⁰ in all, as long as nothing
//! underflows. r is made smaller by 2⁻³⁰ of itself for that. With 2⁻⁴⁰⁰ ≤ A, B ≤ 2⁴⁰⁰ and r ≥ 2⁻¹¹⁰ (T is above the bound, of
//! 2⁻⁴⁸ M, by a unit of its last place, and the root at most 2 M), what
//! underflows, in a, b or a square, is less than 2⁻²⁰⁰ of what it is added to or compared with. A coordinate that is infinite, or a
//! square that overflows, makes the measure infinite and negative, and one that is NaN makes it NaN.

use super::polygon::{Corners, Polygon};
use super::region::{BLOCK, Block, Region};
use geometry_core::Point2;

/// The range of the half axes.
const SMALLEST: f64 = f64::from_bits((1023 - 400) << 52);
const LARGEST: f64 = f64::from_bits((1023 + 400) << 52);

/// 1 - 2⁻³⁰.
const SHRUNK: f64 = 1.0 - 1.0 / (1 << 30) as f64;

/// The ellipse.
#[derive(Debug)]
pub(super) struct Ellipse {
    centre: Point2,
    /// 1 / A and 1 / B.
    scales: [f64; 2],
    /// r².
    most: f64,
}

impl Ellipse {
    /// The largest inside the polygon of these corners that is as wide and high as they are, up to a factor; none if the centre is not
    /// inside.
    pub(super) fn inside(polygon: &Polygon, corners: &Corners, centre: Point2) -> Option<Self> {
        let axes = corners.extents().map(|extent| extent / 2.0);
        let in_range = axes.iter().all(|axis| (SMALLEST..=LARGEST).contains(axis));
        let room = polygon.room_for_ellipse(centre, axes) * SHRUNK;
        (in_range && room > 0.0).then(|| Self {
            centre,
            scales: axes.map(f64::recip),
            most: room * room,
        })
    }
}

impl Region for Ellipse {
    #[inline(always)]
    #[allow(clippy::needless_range_loop)] // three arrays side by side
    fn measure(&self, block: &Block) -> [f64; BLOCK] {
        let mut measures = [0.0; BLOCK];
        // In one loop, compilers take the x and the y of one point for a vector, which takes twice as long.
        for i in 0..BLOCK {
            let y = (block.y[i] - self.centre[1]) * self.scales[1];
            measures[i] = self.most - y * y;
        }
        for i in 0..BLOCK {
            let x = (block.x[i] - self.centre[0]) * self.scales[0];
            measures[i] -= x * x;
        }
        measures
    }

    fn bound(&self) -> f64 {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::{Exact, Kernel2};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// Points close to the ellipse, far away from the origin too: what passes is left of all edges, and much passes.
    #[test]
    fn what_passes_is_left_of_every_edge() {
        let mut rng = ChaCha8Rng::seed_from_u64(31);
        let (mut ellipses, mut inside) = (0, 0);
        for round in 0..2_000 {
            let [wide, high] = [-300, -20, -3, 0, 2, 30, 300, 399, 402]
                .map(|exponent| 2.0_f64.powi(exponent + round % 7))
                .map(|size| [size, size * rng.random_range(1e-3..1.0)])[round as usize % 9];
            let off = [0.0, 1.0, 1e6, 1e13][round as usize % 4];
            let circle = (3..rng.random_range(7..40)).map(|_| rng.random_range(0.0..6.3_f64));
            let mut angles: Vec<f64> = circle.collect();
            angles.sort_unstable_by(f64::total_cmp);
            let at = |angle: f64, r: f64| {
                [
                    wide * (r * angle.cos() + off),
                    high * (r * angle.sin() - off),
                ]
            };
            let corners = Corners::distinct(angles.iter().map(|&angle| at(angle, 1.0)));
            let centre = at(rng.random_range(0.0..6.3), rng.random_range(0.0..0.4));
            let ellipse = Polygon::of(&corners)
                .and_then(|polygon| Ellipse::inside(&polygon, &corners, centre));
            let Some(ellipse) = ellipse else { continue };
            ellipses += 1;
            // On the rim of the ellipse, but for a few roundings.
            let r = ellipse.most.sqrt();
            let mut points = [[0.0; 2]; BLOCK];
            for point in &mut points {
                let angle: f64 = rng.random_range(0.0..6.3);
                let r = r * (1.0 + f64::from(rng.random_range(-9..3)) * f64::EPSILON);
                *point = [
                    centre[0] + r * angle.cos() / ellipse.scales[0],
                    centre[1] + r * angle.sin() / ellipse.scales[1],
                ];
            }
            let outside = ellipse.not_inside(&points);
            for (place, &point) in points.iter().enumerate() {
                if outside >> place & 1 == 1 {
                    continue;
                }
                inside += 1;
                let corners = corners.as_slice();
                for (i, &from) in corners.iter().enumerate() {
                    let to = corners[(i + 1) % corners.len()];
                    assert!(
                        Exact.orient(from, to, point).is_positive(),
                        "{round}: {point:?}"
                    );
                }
            }
        }
        assert!(
            ellipses > 300 && inside > 30 * ellipses,
            "{ellipses}, {inside}"
        );
    }
}
