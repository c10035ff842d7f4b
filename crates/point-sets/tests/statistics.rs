//! Whether the random sets have the distributions they are named after.
//!
//! Radii, directions and coordinates are compared with their exact distribution functions by the test of
//! Kolmogorov and Smirnov, and hull sizes with their exact expectations. Seeds are fixed, so a test passes
//! always or never; its bound is one that a right generator meets for 999 of 1000 seeds. The same tests are
//! shown to refuse sets that are nearly right.

mod common;

use common::{Point, hull, points};
use point_sets::{Spec, cell_seed};
use std::f64::consts::{PI, SQRT_2};

const N: usize = 100_000;

/// √n times the largest difference between the values' distribution function and `exact`.
fn kolmogorov(mut values: Vec<f64>, exact: impl Fn(f64) -> f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len() as f64;
    let differences = values.iter().enumerate().map(|(index, &value)| {
        let expected = exact(value);
        let below = expected - index as f64 / n;
        below.max(1.0 / n - below)
    });
    n.sqrt() * differences.fold(0.0, f64::max)
}

/// Exceeded once in a thousand times.
const BOUND: f64 = 1.95;

#[track_caller]
fn follows(what: &str, values: Vec<f64>, exact: impl Fn(f64) -> f64) {
    let distance = kolmogorov(values, exact);
    assert!(distance < BOUND, "{what}: {distance}");
}

#[track_caller]
fn departs(what: &str, values: Vec<f64>, exact: impl Fn(f64) -> f64) {
    let distance = kolmogorov(values, exact);
    assert!(distance > 2.0 * BOUND, "{what}: {distance}");
}

fn radii(points: &[Point]) -> Vec<f64> {
    points.iter().map(|[x, y]| libm::hypot(*x, *y)).collect()
}

/// Directions as fractions of a turn.
fn turns(points: &[Point]) -> Vec<f64> {
    points
        .iter()
        .map(|[x, y]| libm::atan2(*y, *x) / (2.0 * PI) + 0.5)
        .collect()
}

fn axis(points: &[Point], axis: usize) -> Vec<f64> {
    points.iter().map(|point| point[axis]).collect()
}

fn normal_below(x: f64) -> f64 {
    0.5 * libm::erfc(-x / SQRT_2)
}

fn cauchy_below(x: f64) -> f64 {
    0.5 + libm::atan(x) / PI
}

fn cauchy_radius_below(r: f64) -> f64 {
    1.0 - 1.0 / (1.0 + r * r).sqrt()
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = values.len() as f64;
    values.sum::<f64>() / n
}

#[test]
fn disc() {
    let points = points("disc", N, 1);
    follows("radius", radii(&points), |r| r * r);
    follows("direction", turns(&points), |turn| turn);
    departs(
        "radius of a set too dense in the middle",
        radii(&points),
        |r| r,
    );
    // E r² = 1/2 with variance 1/12.
    let second = mean(points.iter().map(|[x, y]| x * x + y * y));
    assert!(
        (second - 0.5).abs() < 3.3 / (12.0 * N as f64).sqrt(),
        "{second}"
    );
}

#[test]
fn square() {
    let points = points("square", N, 2);
    follows("x", axis(&points, 0), |x| x);
    follows("y", axis(&points, 1), |y| y);
    // Covariance 0, with a standard deviation of 1/(12 √n).
    let covariance = mean(points.iter().map(|[x, y]| (x - 0.5) * (y - 0.5)));
    assert!(
        covariance.abs() < 3.3 / (12.0 * (N as f64).sqrt()),
        "{covariance}"
    );
}

#[test]
fn normal() {
    let points = points("normal", N, 3);
    follows("x", axis(&points, 0), normal_below);
    follows("y", axis(&points, 1), normal_below);
    follows("radius", radii(&points), |r| -libm::expm1(-r * r / 2.0));
    follows("direction", turns(&points), |turn| turn);
    // Fourth moment 3, with a variance of 96/n.
    let fourth = mean(points.iter().map(|[x, _]| x.powi(4)));
    assert!(
        (fourth - 3.0).abs() < 3.3 * (96.0 / N as f64).sqrt(),
        "{fourth}"
    );
}

#[test]
fn cauchy() {
    let points = points("cauchy", N, 4);
    follows("radius", radii(&points), cauchy_radius_below);
    follows("direction", turns(&points), |turn| turn);
    follows("x", axis(&points, 0), cauchy_below);
    let slanted = points.iter().map(|[x, y]| (x + y) / SQRT_2).collect();
    follows("the marginal along the diagonal", slanted, cauchy_below);
}

#[test]
fn two_independent_cauchy_coordinates_would_be_refused() {
    let (first, second) = (points("cauchy", N, 5), points("cauchy", N, 6));
    let product: Vec<Point> = first
        .iter()
        .zip(&second)
        .map(|(a, b)| [a[0], b[0]])
        .collect();
    follows("x", axis(&product, 0), cauchy_below);
    departs("radius", radii(&product), cauchy_radius_below);
    departs("direction", turns(&product), |turn| turn);
}

#[test]
fn circle() {
    let points = points("circle", N, 7);
    follows("direction", turns(&points), |turn| turn);
    assert!(
        radii(&points)
            .iter()
            .all(|r| (r - 1.0).abs() < 4.0 * f64::EPSILON)
    );
}

#[test]
fn near_collinear() {
    let points = points("near-collinear", N, 8);
    follows("place along the line", axis(&points, 0), |x| {
        (x - 0.5) / 23.5
    });
    let mut counts = [0_u32; 5];
    for [x, y] in &points {
        // Both coordinates are the same double moved up by 0, 1 or 2.
        let apart = y.to_bits() as i64 - x.to_bits() as i64;
        counts[(apart + 2) as usize] += 1;
    }
    let expected = [1.0, 2.0, 3.0, 2.0, 1.0].map(|ninths| ninths / 9.0 * N as f64);
    let chi2: f64 = counts
        .iter()
        .zip(expected)
        .map(|(&c, e)| (f64::from(c) - e).powi(2) / e)
        .sum();
    assert!(chi2 < 18.5, "{chi2} on 4 degrees of freedom: {counts:?}");
}

/// Mean and standard deviation of the number of extreme points over replicates with seeds of their own.
fn hull_sizes(spec: &str, n: usize, replicates: u64) -> f64 {
    let parsed: Spec = spec.parse().unwrap();
    let sizes = (0..replicates).map(|replicate| {
        hull(
            &points(spec, n, cell_seed(1979, &parsed, n, replicate)),
            false,
        )
        .len() as f64
    });
    sizes.sum::<f64>() / replicates as f64
}

/// The exact expectations for 100 points, with the standard deviation of one hull.
#[test]
fn hulls_have_the_expected_size() {
    for (spec, expectation, deviation) in [
        ("disc", 15.1713, 1.866),
        ("square", 11.9846, 1.96),
        ("normal", 8.8892, 1.508),
        ("cauchy", 4.9301, 1.12),
    ] {
        let replicates = 2000;
        let size = hull_sizes(spec, 100, replicates);
        let z = (size - expectation) / (deviation / (replicates as f64).sqrt());
        assert!(z.abs() < 3.3, "{spec}: {size}, z = {z}");
    }
}
