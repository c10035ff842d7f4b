//! The ends of the range of `f64`.

use super::grids;
use crate::families;
use geometry_core::Point3;

/// `points` times a power of two, which loses nothing as long as the range is not left.
pub fn scaled(points: Vec<Point3>, exponent: i32) -> Vec<Point3> {
    let half = exponent / 2;
    let (one, other) = (2.0_f64.powi(half), 2.0_f64.powi(exponent - half));
    points
        .into_iter()
        .map(|p| p.map(|x| x * one * other))
        .collect()
}

/// Coordinates near 1e300, where products overflow, and the largest finite values, where differences do.
pub fn huge() -> Vec<Point3> {
    let most = f64::MAX;
    vec![
        [1e300, 1e300, -1e300],
        [most, most, most],
        [-most, most, most],
        [most, -most, most],
        [most, most, -most],
        [-most, -most, -most],
        [0.0, most, most.next_down()],
        [most, 1e292, 0.0],
        [0.0; 3],
        [1e299, 1.0000000000000002e299, 1e299],
        [-1e300, -1e300, 1e300],
    ]
}

/// Coordinates near 1e-300, where products underflow to zero.
pub fn tiny() -> Vec<Point3> {
    vec![
        [1e-300, 1e-300, 1e-300],
        [2e-300, 2e-300, 2e-300],
        [3e-300, 3e-300, 3e-300_f64.next_up()],
        [-1e-300, 1e-300, 2e-300],
        [1e-300, -2e-300, 5e-301],
        [0.0; 3],
        [5e-301, 1e-301, -4e-300],
        [4e-300, 4e-300, 4e-300],
        [-3e-300, -1e-300, 1e-300],
        [1e-300, 1e-300, 1e-300],
    ]
}

/// A 3 × 3 × 3 lattice in units of the least positive value.
pub fn subnormal_lattice() -> Vec<Point3> {
    let units = grids::lattice(3).into_iter();
    units.map(|p| p.map(|x| x * 5e-324)).collect()
}

/// 1e308 and 5e-324 in one set: orientations hang on differences 2000 binary places apart.
pub fn whole_range() -> Vec<Point3> {
    vec![
        [-1e308, 0.0, 0.0],
        [1e308, 0.0, 0.0],
        [0.0, 5e-324, 0.0],
        [0.0, -5e-324, 0.0],
        [0.0, 0.0, 5e-324],
        [1.0, 0.0, -5e-324],
        [-1.0, 0.0, 0.0],
        [1e308, 5e-324, 0.0],
        [0.0, 1.0, 0.0],
        [1e-200, 1e100, -1e100],
        [0.0; 3],
        [5e-324, 5e-324, 5e-324],
    ]
}

/// `n` random points whose coordinates have random exponents over the whole range.
pub fn mixed_exponents(seed: u64, n: usize) -> Vec<Point3> {
    let planar = families::magnitudes::mixed_exponents(seed, n);
    let height = families::magnitudes::mixed_exponents(seed + 1, n);
    let lifted = planar.into_iter().zip(height);
    lifted.map(|([x, y], [z, _])| [x, y, z]).collect()
}

/// Both zeros: eight copies of the origin, copies on the axes, and a cube they are corners of.
pub fn signed_zeros() -> Vec<Point3> {
    let sign = |bit: u32| if bit == 0 { 0.0 } else { -0.0 };
    let mut points: Vec<Point3> = (0..8_u32)
        .map(|bits| [sign(bits & 1), sign(bits & 2), sign(bits & 4)])
        .collect();
    points.extend([
        [2.0, -0.0, 0.0],
        [2.0, 0.0, -0.0],
        [-0.0, 2.0, 0.0],
        [0.0, -0.0, 2.0],
    ]);
    points.extend([
        [2.0, 2.0, -0.0],
        [-0.0, 2.0, 2.0],
        [2.0, 0.0, 2.0],
        [2.0, 2.0, 2.0],
    ]);
    points
}

/// A lattice with the spacing of one ulp, near (2⁵³, 2⁵³, 2⁵³).
pub fn far_from_origin() -> Vec<Point3> {
    let corner = 2.0_f64.powi(53);
    let lattice = grids::lattice(3).into_iter();
    lattice.map(|p| p.map(|x| corner + 2.0 * x)).collect()
}

/// A needle: x up to 1e15, y up to 1, z up to 1e-15, random.
pub fn needle(seed: u64, n: usize) -> Vec<Point3> {
    super::random::ball(seed, n)
        .into_iter()
        .map(|[x, y, z]| [x * 1e15, y, z * 1e-15])
        .collect()
}
