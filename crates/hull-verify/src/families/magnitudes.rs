//! The ends of the range of `f64`.

use super::grids;
use geometry_core::Point2;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Coordinates near 1e300, where products overflow, and the largest finite values, where differences do.
pub fn huge() -> Vec<Point2> {
    vec![
        [1e300, 1e300],
        [-1e300, 1e300],
        [1e300, -1e300],
        [f64::MAX, f64::MAX],
        [-f64::MAX, f64::MAX],
        [f64::MAX, -f64::MAX],
        [-f64::MAX, -f64::MAX],
        [f64::MAX, 0.0],
        [0.0, f64::MAX.next_down()],
        [f64::MAX, 1e292],
        [0.0, 0.0],
        [1e299, 1.0000000000000002e299],
    ]
}

/// Coordinates near 1e-300, where products underflow to zero.
pub fn tiny() -> Vec<Point2> {
    vec![
        [1e-300, 1e-300],
        [2e-300, 2e-300],
        [3e-300, 3e-300_f64.next_up()],
        [-1e-300, 1e-300],
        [1e-300, -2e-300],
        [0.0, 0.0],
        [5e-301, 1e-301],
        [4e-300, 4e-300],
        [-3e-300, -1e-300],
        [1e-300, 1e-300],
    ]
}

/// Subnormal coordinates, a few units of the least positive value.
pub fn subnormal() -> Vec<Point2> {
    let units = [
        [0, 0],
        [1, 2],
        [2, 4],
        [3, 5],
        [7, 1],
        [-4, 6],
        [2, -9],
        [1, 1],
        [-1, -1],
        [7, 1],
        [3, 3],
    ];
    units
        .map(|p: [i32; 2]| p.map(|t| f64::from(t) * 5e-324))
        .to_vec()
}

/// The [`grids::lattice`] in units of the least positive value.
pub fn subnormal_lattice(k: u32) -> Vec<Point2> {
    grids::lattice(k)
        .into_iter()
        .map(|p| p.map(|x| x * 5e-324))
        .collect()
}

/// 1e308 and 5e-324 in one set: orientations hang on differences 2000 binary places apart.
///
/// ```text
///     *  ........................ 1e308 ........................  *
///                                  :                     (5e-324 apart)
///     *                                                           *
/// ```
pub fn whole_range() -> Vec<Point2> {
    vec![
        [-1e308, 0.0],
        [1e308, 0.0],
        [0.0, 5e-324],
        [0.0, -5e-324],
        [1.0, 5e-324],
        [-1.0, 0.0],
        [1e308, 5e-324],
        [-1e308, 1e-323],
        [5e-324, 0.0],
        [0.0, 1.0],
        [1e-200, 1e100],
        [0.0, 0.0],
    ]
}

/// `n` random points whose coordinates have random exponents over the whole range.
pub fn mixed_exponents(seed: u64, n: usize) -> Vec<Point2> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut coordinate = || {
        let sign = if rng.random() { 1.0 } else { -1.0 };
        let exponent = rng.random_range(-1070..1023);
        let half = exponent / 2;
        sign * rng.random_range(1.0..2.0) * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half)
    };
    (0..n).map(|_| [coordinate(), coordinate()]).collect()
}

/// Both zeros in every combination: four copies of the origin, and copies on both axes.
pub fn signed_zeros() -> Vec<Point2> {
    vec![
        [0.0, -0.0],
        [-0.0, 0.0],
        [-0.0, -0.0],
        [0.0, 0.0],
        [2.0, -0.0],
        [2.0, 0.0],
        [-0.0, 2.0],
        [0.0, 2.0],
        [1.0, -0.0],
        [-0.0, 1.0],
        [1.0, 1.0],
    ]
}

/// A k × k lattice with the spacing of one ulp, near (2⁵³, 2⁵³).
pub fn far_from_origin(k: u32) -> Vec<Point2> {
    let corner = 2.0_f64.powi(53);
    grids::lattice(k)
        .into_iter()
        .map(|p| p.map(|x| corner + 2.0 * x))
        .collect()
}
