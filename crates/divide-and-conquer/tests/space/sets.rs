//! Point sets for the tests of merges in space.

use geometry_core::Point3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// The point at distance r from the x-axis, `turn` of a full turn round it.
fn round_the_axis(x: f64, r: f64, turn: f64) -> Point3 {
    [x, r * (TAU * turn).cos(), r * (TAU * turn).sin()]
}

/// FAN(m): 4 m + 2 points whose last merge comes through one vertex, v, about m times.
///
/// v and a cone of N = 2 m points a in the first half; above every other side of the cone a point b, and m + 1 points
/// inside, in the second. `phase`, in steps of the cone's points, turns the set about the axis, and so decides where the
/// wrap begins.
pub(crate) fn fan(m: usize, phase: f64) -> Vec<Point3> {
    let sides = 2 * m;
    let turn = |step: f64| (step + phase) / sides as f64;
    let step = TAU / sides as f64;
    // Halfway between the plane of the side below and those of the sides next to it.
    let distance = 2.0 * (step / 2.0).cos() * (1.0 + 1.0 / step.cos()) / 2.0;
    let mut points = vec![[0.0; 3]];
    points.extend((0..sides).map(|i| round_the_axis(1.0, 1.0, turn(i as f64))));
    points.extend((0..m).map(|j| round_the_axis(2.0, distance, turn(2.0 * j as f64 + 0.5))));
    points.extend((0..=m).map(|k| {
        let risen = (k + 1) as f64 / (m + 1) as f64;
        round_the_axis(2.0 + risen / 2.0, (1.0 - risen) / 2.0, 0.618 * k as f64)
    }));
    points
}

/// CONE(m): 4 m + 2 points of which the last merge leaves one of the first half, v, and wraps round it.
pub(crate) fn cone(m: usize) -> Vec<Point3> {
    let scaled = |i: usize| 0.9 + 0.1 * (0.618 * i as f64).fract();
    let mut points = vec![[0.0; 3]];
    for (count, height, slope) in [(2 * m, 1.0, 0.5), (2 * m + 1, 2.0, 2.5)] {
        points.extend((0..count).map(|i| {
            let x = height * scaled(i);
            round_the_axis(x, slope * x, i as f64 / count as f64)
        }));
    }
    points
}

fn in_ball(rng: &mut ChaCha8Rng) -> (Point3, f64) {
    loop {
        let p: Point3 = std::array::from_fn(|_| 2.0 * rng.random::<f64>() - 1.0);
        let r = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        if r > 0.01 && r <= 1.0 {
            return (p, r);
        }
    }
}

/// Uniform in the unit ball.
pub(crate) fn ball(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..n).map(|_| in_ball(&mut rng).0).collect()
}

/// Uniform on the unit sphere, up to rounding.
pub(crate) fn sphere(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let on_sphere = |(p, r): (Point3, f64)| p.map(|x| x / r);
    (0..n).map(|_| on_sphere(in_ball(&mut rng))).collect()
}

/// Uniform in a cube.
pub(crate) fn cube(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let point = |_| std::array::from_fn(|_| rng.random::<f64>());
    (0..n).map(point).collect()
}

/// The cubic lattice of k³ points.
pub(crate) fn lattice(k: usize) -> Vec<Point3> {
    let coordinates = |i: usize| [i / k / k, i / k % k, i % k].map(|c| c as f64);
    (0..k * k * k).map(coordinates).collect()
}
