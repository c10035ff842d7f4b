//! Random points, by seed.

use geometry_core::Point3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// `n` points of the k × k × k integer grid, with repetition.
pub fn on_grid(seed: u64, k: u32, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut coordinate = || f64::from(rng.random_range(0..k));
    (0..n)
        .map(|_| [coordinate(), coordinate(), coordinate()])
        .collect()
}

/// `n` points in the unit cube.
pub fn cube(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..n).map(|_| rng.random()).collect()
}

/// `n` points in the unit ball, none within a hundredth of its centre.
pub fn ball(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut points = Vec::with_capacity(n);
    while points.len() < n {
        let p: Point3 = [0; 3].map(|_| rng.random_range(-1.0..1.0));
        let square: f64 = p.iter().map(|x| x * x).sum();
        if (1e-4..=1.0).contains(&square) {
            points.push(p);
        }
    }
    points
}

/// [`ball`], rounded to `f32`: coordinates of at most 24 bits.
pub fn ball_of_singles(seed: u64, n: usize) -> Vec<Point3> {
    ball(seed, n)
        .into_iter()
        .map(|p| p.map(|x| f64::from(x as f32)))
        .collect()
}

/// `n` points within a few roundings of the plane z = x / 3 + y / 5.
pub fn near_a_plane(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..n)
        .map(|_| {
            let [x, y] = [0; 2].map(|_| rng.random_range(1.0..2.0_f64));
            let off = f64::from(rng.random_range(-2..=2)) * f64::EPSILON / 4.0;
            [x, y, x / 3.0 + y / 5.0 + off]
        })
        .collect()
}

/// `n` points within a few roundings of the line x = 3 y = 5 z.
pub fn near_a_line(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..n)
        .map(|_| {
            let x = rng.random_range(1.0..2.0_f64);
            let mut off = || f64::from(rng.random_range(-2..=2)) * f64::EPSILON / 8.0;
            [x, x / 3.0 + off(), x / 5.0 + off()]
        })
        .collect()
}
