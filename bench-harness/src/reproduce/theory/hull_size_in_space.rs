//! Expected number of hull vertices of n random points of space, exactly, for finite n.
//!
//! With probability 1 every facet is a triangle, three points with all others on one side of their plane.
//! Integrating over the planes (Blaschke–Petkantschin) leaves one integral over the signed distance h of the plane
//! from the centre, with the probability that a point lies beyond it. A hull of F triangles has V = F/2 + 2
//! vertices.
//!
//! | distribution | E F |
//! |---|---|
//! | ball | 1260 C(n,3) ∫ t⁴ (1-t)⁴ (1 - t² (3-2t))ⁿ⁻³ dt, 0 < t < 1, with h = 1 - 2t |
//! | normal | 2 C(n,3) √(3/2π) ∫ exp(-3h²/2) Φ(h)ⁿ⁻³ dh |
//! | Cauchy | 2 C(n,3) (2/π) ∫ sin²s (1 - s/π)ⁿ⁻³ ds, 0 < s < π, with h = cot s |
//! | sphere | 2n - 4 |
//!
//! The powers are taken in logarithms, so that nothing overflows or cancels for large n.
//!
//! # Source
//!
//! Z. Kabluchko, D. Temesvari, C. Thäle, *Expected intrinsic volumes and facet numbers of random beta-polytopes*,
//! arXiv:1707.02253, with β = 0 for the ball, β' = 2 for Cauchy.

use super::quadrature::{integral, integral_peaked_at_start};
use statrs::function::erf::erfc;
use std::f64::consts::PI;

/// The expected number of vertices of the hull of `n` points of the distribution called `spec`.
///
/// `None` for a distribution without a formula here, and for `n` < 4, where degenerate hulls begin.
pub(crate) fn expected(spec: &str, n: usize) -> Option<f64> {
    if n < 4 {
        return None;
    }
    let n = n as f64;
    let facets = match spec {
        "ball" => ball(n),
        "normal3" => normal(n),
        "cauchy3" => cauchy(n),
        "sphere" => 2.0 * n - 4.0,
        _ => return None,
    };
    Some(facets / 2.0 + 2.0)
}

fn ball(n: f64) -> f64 {
    let density = |t: f64| (t * (1.0 - t)).powi(4) * all_within(t * t * (3.0 - 2.0 * t), n);
    1_260.0 * triples(n) * integral_peaked_at_start(density, 0.0, 1.0)
}

fn normal(n: f64) -> f64 {
    let density = |h: f64| (-1.5 * h * h).exp() * all_within(erfc(h / 2_f64.sqrt()) / 2.0, n);
    2.0 * triples(n) * (1.5 / PI).sqrt() * integral(density, -12.0, 12.0)
}

fn cauchy(n: f64) -> f64 {
    let density = |s: f64| s.sin().powi(2) * all_within(s / PI, n);
    4.0 / PI * triples(n) * integral_peaked_at_start(density, 0.0, PI)
}

/// C(n, 3).
fn triples(n: f64) -> f64 {
    n * (n - 1.0) * (n - 2.0) / 6.0
}

/// (1 - `beyond`)ⁿ⁻³: the probability that none of the other points lies beyond the plane.
fn all_within(beyond: f64, n: f64) -> f64 {
    ((n - 3.0) * (-beyond.min(1.0)).ln_1p()).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// n, then ball, normal, Cauchy.
    const KNOWN: [(usize, [f64; 3]); 7] = [
        (10, [8.830, 8.211, 6.977]),
        (100, [39.117, 21.852, 8.555]),
        (1_000, [135.837, 36.935, 8.580]),
        (10_000, [441.940, 52.523, 8.580]),
        (100_000, [1_409.995, 68.371, 8.580]),
        (1_000_000, [4_471.28, 84.380, 8.580]),
        (10_000_000, [14_151.9, 100.499, 8.580]),
    ];

    #[test]
    fn agrees_with_known_values() {
        for (n, values) in KNOWN {
            for (spec, known) in ["ball", "normal3", "cauchy3"].into_iter().zip(values) {
                let here = expected(spec, n).expect("a formula");
                // Half a unit of the last digit in which the value is known.
                let digits = match known {
                    k if k > 10_000.0 => 0.06,
                    k if k > 4_000.0 => 0.006,
                    _ => 6e-4,
                };
                assert!(
                    (here - known).abs() < digits,
                    "{spec} {n}: {here}, known {known}"
                );
            }
        }
    }

    #[test]
    fn the_limit_of_cauchy_is_known() {
        let limit = 2.0 + 2.0 * PI * PI / 3.0;
        let here = expected("cauchy3", 10_000_000).expect("a formula");
        assert!((here - limit).abs() < 1e-5, "{here}, limit {limit}");
    }

    #[test]
    fn four_points_are_a_tetrahedron() {
        for spec in ["ball", "normal3", "cauchy3", "sphere"] {
            let here = expected(spec, 4).expect("a formula");
            assert!((here - 4.0).abs() < 1e-9, "{spec}: {here}");
        }
    }

    #[test]
    fn no_formula_is_no_value() {
        assert_eq!(expected("fan", 100), None);
        assert_eq!(expected("ball", 3), None);
    }
}
