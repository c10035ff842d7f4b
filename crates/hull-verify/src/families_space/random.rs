//! Random points, by seed.

use geometry_core::Point3;
use rand::{Rng, RngExt, SeedableRng};
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

/// Up to forty points, of a kind that the seed chooses, with or without copies: lattices, planes, all magnitudes.
pub fn difficult(seed: u64) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let n = rng.random_range(1..40);
    let kind = rng.random_range(0..9);
    let mut points: Vec<Point3> = (0..n).map(|_| difficult_point(kind, &mut rng)).collect();
    if rng.random_bool(0.3) {
        let copies = rng.random_range(1..=n);
        (0..copies).for_each(|_| points.push(points[rng.random_range(0..points.len())]));
    }
    points
}

fn difficult_point(kind: u32, rng: &mut impl Rng) -> Point3 {
    let mut lattice = |most: i32| [(); 3].map(|()| f64::from(rng.random_range(-most..=most)));
    match kind {
        0 => lattice(1),
        1 => lattice(3),
        // Far from the origin, so that differences of coordinates are exact and products are not.
        2 => lattice(5).map(|x| x * 0.1 + 1e8),
        // Up to an ulp off an oblique plane.
        3 => {
            let [x, y, z] = lattice(4);
            let (x, y) = (x * 0.1, y * 0.3);
            let plane = 1.0 + x / 3.0 + y / 7.0;
            [x, y, plane + z.signum() * f64::EPSILON]
        }
        // Mixed magnitudes.
        4 => lattice(9).map(|x| x.signum() * 10.0_f64.powf(x.abs() * 30.0 - 135.0)),
        5 => lattice(4).map(|x| x * 1e300 / 4.0),
        6 => lattice(4).map(|x| x * 5e-324),
        // The corners of two parallel oblique planes, exactly.
        7 => {
            let [x, y, z] = lattice(4);
            [x, y, x + y + 8.0 * f64::from(u8::from(z > 0.0))]
        }
        _ => [(); 3].map(|()| rng.random_range(-1.0..1.0)),
    }
}
