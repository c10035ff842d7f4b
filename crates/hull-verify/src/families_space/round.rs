//! Points on round bodies and curves: many vertices, and facets of many corners.

use crate::families;
use geometry_core::{Point2, Point3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// A prism over integer points of a circle: two facets of many corners, the others rectangles.
pub fn prism() -> Vec<Point3> {
    let circle = families::curves::integer_circle();
    let at = |z: f64| circle.iter().map(move |&[x, y]| [x, y, z]);
    at(0.0).chain(at(7.0)).collect()
}

/// A prism over a regular polygon of `n` corners, rounded: its walls are exactly planar all the same.
pub fn rounded_prism(n: u32) -> Vec<Point3> {
    let circle = families::curves::circle(n);
    let at = |z: f64| circle.iter().map(move |&[x, y]| [x, y, z]);
    at(-1.0).chain(at(1.0)).collect()
}

/// An antiprism: the polygon of `n` corners below, the same turned by half a step above.
pub fn antiprism(n: u32) -> Vec<Point3> {
    let circle = families::curves::circle(2 * n);
    let level = |(i, &[x, y]): (usize, &Point2)| [x, y, (i % 2) as f64];
    circle.iter().enumerate().map(level).collect()
}

/// A cone: a polygon of `n` corners and an apex, in which all other facets meet.
pub fn cone(n: u32) -> Vec<Point3> {
    let circle = families::curves::circle(n);
    let mut points: Vec<Point3> = circle.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    points.push([0.0, 0.0, 2.0]);
    points
}

/// A cone over integer points of a circle, with points along its axis.
pub fn circle_and_axis() -> Vec<Point3> {
    let circle = families::curves::integer_circle();
    let mut points: Vec<Point3> = (-5..=5).map(|z| [0.0, 0.0, f64::from(z)]).collect();
    points.extend(circle.iter().map(|&[x, y]| [x, y, 0.0]));
    points
}

/// `n` points (t, t², t³) for integers t about zero: every pair is an edge, as many facets as there can be.
pub fn moment_curve(n: i32) -> Vec<Point3> {
    (-n / 2..n - n / 2)
        .map(|t| [t, t * t, t * t * t].map(f64::from))
        .collect()
}

/// `n` points on a helix, and their axis.
pub fn helix(n: u32) -> Vec<Point3> {
    (0..n)
        .flat_map(|i| {
            let t = f64::from(i) / 4.0;
            [[t.cos(), t.sin(), t], [0.0, 0.0, t]]
        })
        .collect()
}

/// A point on the paraboloid z = x² + y² over each of the k × k grid: facets of four corners, all of them squares
/// in the shadow.
pub fn paraboloid(k: u32) -> Vec<Point3> {
    families::grids::lattice(k)
        .into_iter()
        .map(|[x, y]| [x, y, x * x + y * y])
        .collect()
}

/// All integer points on the sphere of radius 9: (±9, 0, 0), (±8, ±4, ±1), (±7, ±4, ±4), (±6, ±6, ±3) in every order.
/// Exactly cospherical, with facets of three to many corners.
pub fn integer_sphere() -> Vec<Point3> {
    let mut points = Vec::new();
    for x in -9_i32..=9 {
        for y in -9_i32..=9 {
            for z in -9_i32..=9 {
                if x * x + y * y + z * z == 81 {
                    points.push([x, y, z].map(f64::from));
                }
            }
        }
    }
    points
}

/// `n` random points on the unit sphere, rounded.
pub fn sphere(seed: u64, n: usize) -> Vec<Point3> {
    super::random::ball(seed, n)
        .into_iter()
        .map(|p| {
            let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
            p.map(|x| x / length)
        })
        .collect()
}

/// `n` random points on the unit sphere, and every one again slightly further in.
pub fn shells(seed: u64, n: usize) -> Vec<Point3> {
    let outer = sphere(seed, n);
    let inner = outer.iter().map(|p| p.map(|x| 0.999 * x));
    inner.chain(outer.iter().copied()).collect()
}

/// `n` random points on two circles about the z axis and between them: a drum.
pub fn drum(seed: u64, n: usize) -> Vec<Point3> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    families::random::disc(seed, n)
        .into_iter()
        .map(|[x, y]| [x, y, f64::from(rng.random_range(0..2_u8))])
        .collect()
}
