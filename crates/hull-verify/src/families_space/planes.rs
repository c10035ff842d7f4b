//! Points in one plane or two, and points a rounding off a plane.

use crate::families;
use geometry_core::{Point2, Point3};

/// A plane: where a point of the plane (u, v) lies in space.
pub type Plane = fn(Point2) -> Point3;

/// Planes along the axes, through one axis, and through none. Integers stay integers.
pub const PLANES: [(&str, Plane); 6] = [
    ("z = 3", |[u, v]| [u, v, 3.0]),
    ("y = 3", |[u, v]| [u, 3.0, v]),
    ("x = 3", |[u, v]| [3.0, u, v]),
    ("x = y", |[u, v]| [u, u, v]),
    ("z = 2x + y", |[u, v]| [u, v, 2.0 * u + v]),
    ("x + y + z = 7", |[u, v]| [7.0 - u - v, u, v]),
];

/// `points` in a plane.
pub fn in_plane(points: &[Point2], plane: Plane) -> Vec<Point3> {
    points.iter().map(|&p| plane(p)).collect()
}

/// A k × k grid in a plane, and one point off it: a pyramid over a square whose base is full of points.
///
/// ```text
///            *
///         .  :  .
///       .    :    .
///     *--*--*--*--*
/// ```
pub fn grid_and_apex(k: u32, plane: Plane) -> Vec<Point3> {
    let mut points = in_plane(&families::grids::lattice(k), plane);
    let [x, y, z] = plane([f64::from(k) / 2.0, f64::from(k) / 2.0]);
    points.insert(points.len() / 2, [x + 1.0, y + 2.0, z + 4.0]);
    points
}

/// A k × k grid and the same grid one unit away.
pub fn two_grids(k: u32, plane: Plane) -> Vec<Point3> {
    let grid = in_plane(&families::grids::lattice(k), plane);
    let moved = grid.iter().map(|&[x, y, z]| [x + 1.0, y + 1.0, z + 1.0]);
    grid.iter().copied().chain(moved).collect()
}

/// A k × k grid of tenths in a plane through the origin, rounded: some points are on it and some an ulp off.
pub fn tenths(k: u32) -> Vec<Point3> {
    let grid = families::grids::lattice_of_tenths(k);
    in_plane(&grid, |[u, v]| [u, v, 0.3 * u + 0.7 * v])
}

/// A k × k grid of units in the plane z = 1, every second point one ulp above it.
pub fn ulp_off(k: u32) -> Vec<Point3> {
    let mut points = in_plane(&families::grids::lattice(k), |[u, v]| [u, v, 1.0]);
    for point in points.iter_mut().step_by(2) {
        point[2] = point[2].next_up();
    }
    points
}

/// A k × k grid in an oblique plane, one of its points (in the middle) one ulp above.
pub fn one_ulp_off(k: u32) -> Vec<Point3> {
    let mut points = in_plane(&families::grids::lattice(k), |[u, v]| {
        [u, v, 1.0 + u / 4.0 + v / 2.0]
    });
    let middle = points.len() / 2;
    points[middle][2] = points[middle][2].next_up();
    points
}
