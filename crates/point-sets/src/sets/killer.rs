//! The geometric parabola on which quickhull cuts off one point a level.
//!
//! ```text
//!                     x3 x4
//!              ·      ··  ·      x2
//!         x1                       ·           x_k = (-a)^k,  y_k = -S x_k²
//!       ·                                      a = 0.5698, S = 2^1013
//!                                            x0
//!                                             ·
//! ```
//!
//! Of the points above a chord, the furthest is the one whose x is nearest to the middle of the chord. Above
//! x₀x₁ that middle is (1 - a)/2, halfway between x₂ = a² and x₄ = a⁴ if a⁴ + a² + a = 1. The value 0.5698 is
//! just below that root, so x₂ wins: nothing is left above x₀x₂, and all the rest above x₂x₁, which is the same
//! picture again, mirrored and smaller. So every level looks at all the points that are left and finds one:
//! n - 2 levels deep, and since a point left over is tested against one or, every other level, both of the new
//! chords, about (3/4) n² orientations in all.
//!
//! A larger a would lengthen the sequence but break the pattern. y shrinks by a² at each point, and S lets it
//! begin near the largest double; after [`LIMIT`] points it would leave the normal doubles. Exact kernels see
//! the pattern to the end; plain double arithmetic loses it earlier, where products of coordinates underflow.

use crate::catalogue::{Entry, Generate};
use crate::error::SpecError;

pub(crate) const ENTRY: Entry = Entry {
    name: "killer",
    summary: "a geometric sequence on a parabola: quickhull cuts off one point a level",
    parameters: &[],
    source: "the quadratic case of quickhull, y stretched so that a longer sequence fits in doubles",
    generate: Generate::Plane(|spec, n, _| {
        if n > LIMIT {
            return Err(SpecError::TooMany {
                set: spec.name(),
                limit: LIMIT,
                asked: n,
                reason: "coordinates shrink geometrically and leave the range of double precision; for a \
                         larger set use `duplicated:of=killer`",
            });
        }
        let abscissae = std::iter::successors(Some(1.0), |x| Some(-RATIO * x));
        Ok(abscissae
            .take(n)
            .map(|x: f64| [x, -(x * STRETCH * x)])
            .collect())
    }),
};

/// Just below the root 0.56984... of a⁴ + a² + a = 1.
const RATIO: f64 = 0.5698;

/// S = 2¹⁰¹³, a power of two so that stretching rounds nothing.
const STRETCH: f64 = f64::from_bits((1023 + 1013) << 52);

/// The largest n whose coordinates are all normal doubles.
const LIMIT: usize = 1254;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_is_where_normal_doubles_end() {
        assert_eq!(STRETCH, 2.0_f64.powi(1013));
        let spec: crate::Spec = "killer".parse().unwrap();
        let points = spec.generate(LIMIT, 0).unwrap();
        let [x, y] = points[LIMIT - 1];
        assert!(x.is_normal() && y.is_normal());
        assert!(!(y * (RATIO * RATIO)).is_normal());
        assert!(spec.generate(LIMIT + 1, 0).is_err());
    }
}
