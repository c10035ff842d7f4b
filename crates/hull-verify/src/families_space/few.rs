//! Few points, copies, and points on one line.

use geometry_core::Point3;

/// No points.
pub fn empty() -> Vec<Point3> {
    Vec::new()
}

/// One point.
pub fn one() -> Vec<Point3> {
    vec![[3.0, -2.0, 1.0]]
}

/// Two points.
pub fn two() -> Vec<Point3> {
    vec![[3.0, -2.0, 1.0], [-1.0, 4.0, 1.0]]
}

/// `n` copies of one point.
pub fn copies(n: usize) -> Vec<Point3> {
    vec![[0.1, 0.2, 0.3]; n]
}

/// `n` points along `direction`, the middle ones first.
pub fn line(n: u32, direction: Point3) -> Vec<Point3> {
    let middle = n / 2;
    (middle..n)
        .chain(0..middle)
        .map(|i| direction.map(|d| f64::from(i) * d))
        .collect()
}

/// Three corners in a plane that is along no axis.
pub fn triangle() -> Vec<Point3> {
    vec![[0.0, 0.0, 1.0], [4.0, 1.0, 0.0], [1.0, 3.0, 2.0]]
}

/// Four corners.
pub fn tetrahedron() -> Vec<Point3> {
    vec![[0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]]
}

/// A tetrahedron with a point inside, one on a facet, one on an edge, and `n` copies of every corner.
pub fn tetrahedron_with_copies(n: usize) -> Vec<Point3> {
    let mut points = vec![[0.5; 3], [1.0; 3], [1.5, 1.5, 0.0]];
    points.extend(tetrahedron().repeat(n));
    points
}

/// Every one of `points` twice, the copies after the originals, in reverse.
pub fn twice(points: Vec<Point3>) -> Vec<Point3> {
    let mut doubled = points.clone();
    doubled.extend(points.iter().rev());
    doubled
}
