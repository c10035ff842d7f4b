//! Random points, by seed.

use geometry_core::Point2;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// `n` points of the k × k integer grid, with repetition.
pub fn on_grid(seed: u64, k: u32, n: usize) -> Vec<Point2> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut coordinate = || f64::from(rng.random_range(0..k));
    (0..n).map(|_| [coordinate(), coordinate()]).collect()
}

/// `n` points in the unit square.
pub fn square(seed: u64, n: usize) -> Vec<Point2> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..n).map(|_| [rng.random(), rng.random()]).collect()
}

/// `n` points in the unit disc.
pub fn disc(seed: u64, n: usize) -> Vec<Point2> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut points = Vec::with_capacity(n);
    while points.len() < n {
        let p: Point2 = [rng.random_range(-1.0..1.0), rng.random_range(-1.0..1.0)];
        if p[0] * p[0] + p[1] * p[1] <= 1.0 {
            points.push(p);
        }
    }
    points
}

/// [`disc`], rounded to `f32`: coordinates of at most 24 bits.
pub fn disc_of_singles(seed: u64, n: usize) -> Vec<Point2> {
    disc(seed, n)
        .into_iter()
        .map(|p| p.map(|x| f64::from(x as f32)))
        .collect()
}

/// `n` points within a few roundings of the line y = x / 3.
pub fn near_a_line(seed: u64, n: usize) -> Vec<Point2> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..n)
        .map(|_| {
            let x: f64 = rng.random_range(1.0..2.0);
            let off = f64::from(rng.random_range(-2..=2)) * f64::EPSILON / 4.0;
            [x, x / 3.0 + off]
        })
        .collect()
}
