//! Expected number of hull vertices of n random points, exactly, for finite n.
//!
//! An edge of the hull is a pair of points with all others on one side of its line. Integrating over the
//! lines (Blaschke–Petkantschin) leaves one integral over the distance h of the line from the centre, with
//! the probability G(h) that a point lies on the centre's side of it:
//!
//! | distribution | E V |
//! |---|---|
//! | disc | n(n-1) (8/3π) ∫ sin⁴t (1 - (t - sin t cos t)/π)ⁿ⁻² dt, 0 < t < π, with h = cos t |
//! | normal | n(n-1) / √π ∫ exp(-h²) Φ(h)ⁿ⁻² dh |
//! | Cauchy | n(n-1)/2 ∫ sin s (1 - s/π)ⁿ⁻² ds, 0 < s < π, with h = cot s |
//! | square | n(n-1)/6 {4 ∫ -p ln p [(1-p/2)ⁿ⁻² + (p/2)ⁿ⁻²] dp + 2 ∫ w(m) [mⁿ⁻² + (1-m)ⁿ⁻²] dm}, w(m) = 4 min(m, 1-m) |
//! | circle | n |
//!
//! The powers are taken in logarithms, so that nothing overflows or cancels for large n.
//!
//! # Source
//!
//! Z. Kabluchko, D. Temesvari, C. Thäle, *Expected intrinsic volumes and facet numbers of random beta-polytopes*,
//! arXiv:1707.02253; A. Rényi, R. Sulanke, *Über die konvexe Hülle von n zufällig gewählten Punkten*,
//! Z. Wahrscheinlichkeitstheorie 2 (1963) for the square's two kinds of lines.

use super::quadrature::{integral, integral_peaked_at_start};
use statrs::function::erf::erfc;
use std::f64::consts::PI;

/// The expected number of vertices of the hull of `n` points of the distribution called `spec`.
///
/// `None` for a distribution without a formula here, and for `n` < 3, where degenerate hulls begin.
pub(crate) fn expected(spec: &str, n: usize) -> Option<f64> {
    if n < 3 {
        return None;
    }
    let n = n as f64;
    match spec {
        "disc" => Some(disc(n)),
        "normal" => Some(normal(n)),
        "cauchy" => Some(cauchy(n)),
        "square" => Some(square(n)),
        "circle" => Some(n),
        _ => None,
    }
}

fn disc(n: f64) -> f64 {
    let density = |t: f64| {
        let outside = (t - t.sin() * t.cos()) / PI;
        t.sin().powi(4) * power(outside, n)
    };
    n * (n - 1.0) * 8.0 / (3.0 * PI) * integral_peaked_at_start(density, 0.0, PI)
}

fn normal(n: f64) -> f64 {
    let density = |h: f64| (-h * h).exp() * power(erfc(h / 2_f64.sqrt()) / 2.0, n);
    n * (n - 1.0) / PI.sqrt() * integral(density, -12.0, 12.0)
}

fn cauchy(n: f64) -> f64 {
    let density = |s: f64| s.sin() * power(s / PI, n);
    n * (n - 1.0) / 2.0 * integral_peaked_at_start(density, 0.0, PI)
}

fn square(n: f64) -> f64 {
    let corner = |p: f64| -p * p.ln() * (power(p / 2.0, n) + power(1.0 - p / 2.0, n));
    let weight = |m: f64| 4.0 * m.min(1.0 - m);
    let strip = |m: f64| weight(m) * (power(1.0 - m, n) + power(m, n));
    // The strip's density is symmetric about 1/2, where its weight has a corner.
    let strips = 2.0 * integral_peaked_at_start(strip, 0.0, 0.5);
    n * (n - 1.0) / 6.0 * (4.0 * integral_peaked_at_start(corner, 0.0, 1.0) + 2.0 * strips)
}

/// (1 - `outside`)ⁿ⁻²: the probability that no other point lies outside.
fn power(outside: f64, n: f64) -> f64 {
    ((n - 2.0) * (-outside.min(1.0)).ln_1p()).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// n, then disc, square, normal, Cauchy.
    const KNOWN: [(usize, [f64; 4]); 10] = [
        (10, [6.1145, 5.9621, 5.4547, 4.5850]),
        (50, [11.7923, 10.1495, 7.9728, 4.9165]),
        (100, [15.1713, 11.9846, 8.8892, 4.9301]),
        (200, [19.3626, 13.8264, 9.7345, 4.9336]),
        (500, [26.5407, 16.2658, 10.7648, 4.9346]),
        (1_000, [33.5842, 18.1129, 11.4906, 4.9348]),
        (10_000, [72.7737, 24.2519, 13.6536, 4.9348]),
        (100_000, [156.982, 30.3920, 15.5420, 4.9348]),
        (1_000_000, [338.298, 36.5322, 17.2385, 4.9348]),
        (10_000_000, [728.883, 42.6724, 18.7914, 4.9348]),
    ];

    #[test]
    fn agrees_with_known_values() {
        for (n, values) in KNOWN {
            for (spec, known) in ["disc", "square", "normal", "cauchy"]
                .into_iter()
                .zip(values)
            {
                let here = expected(spec, n).expect("a formula");
                let digits = if known > 100.0 { 6e-4 } else { 6e-5 };
                assert!(
                    (here - known).abs() < digits,
                    "{spec} {n}: {here}, known {known}"
                );
            }
        }
    }

    #[test]
    fn three_points_are_a_triangle() {
        for spec in ["disc", "square", "normal", "cauchy", "circle"] {
            let here = expected(spec, 3).expect("a formula");
            assert!((here - 3.0).abs() < 1e-9, "{spec}: {here}");
        }
    }

    #[test]
    fn no_formula_is_no_value() {
        assert_eq!(expected("killer", 100), None);
        assert_eq!(expected("disc", 2), None);
    }
}
