//! Few points, and copies.

use geometry_core::Point2;

/// No points.
pub fn empty() -> Vec<Point2> {
    Vec::new()
}

/// One point.
pub fn one() -> Vec<Point2> {
    vec![[3.0, -2.0]]
}

/// Two points.
pub fn two() -> Vec<Point2> {
    vec![[3.0, -2.0], [-1.0, 4.0]]
}

/// `n` copies of one point.
pub fn copies(n: usize) -> Vec<Point2> {
    vec![[0.1, 0.2]; n]
}

/// Two points in turn, `n` times each.
///
/// ```text
///                     1 3 5 7 …
///     0 2 4 6 …
/// ```
pub fn two_places(n: usize) -> Vec<Point2> {
    [[0.0, 0.0], [0.3, 0.1]].repeat(n)
}

/// Three corners.
pub fn triangle() -> Vec<Point2> {
    vec![[0.0, 0.0], [4.0, 1.0], [1.0, 3.0]]
}

/// Three corners, `n` copies of each, and one point inside.
///
/// ```text
///          nnn
///         /   \
///        /  1  \
///     nnn-------nnn
/// ```
pub fn triangle_with_copied_corners(n: usize) -> Vec<Point2> {
    let mut points = vec![[1.0, 1.0]];
    points.extend([[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]].repeat(n));
    points
}

/// A square with `n` copies of its centre, given first.
///
/// ```text
///     1-------1
///     |   n   |
///     1-------1
/// ```
pub fn square_with_copied_centre(n: usize) -> Vec<Point2> {
    let mut points = vec![[1.0, 1.0]; n];
    points.extend([[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0]]);
    points
}

/// Every one of `points` twice, the copies after the originals, in reverse.
pub fn twice(points: Vec<Point2>) -> Vec<Point2> {
    let mut doubled = points.clone();
    doubled.extend(points.iter().rev());
    doubled
}
