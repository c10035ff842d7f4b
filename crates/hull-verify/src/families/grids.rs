//! Lattices and outlines: equal coordinates and collinear triples in great number.

use geometry_core::Point2;

/// All (i, j) for i, j in 0..k, row by row from the top.
///
/// ```text
///     0 1 2
///     3 4 5
///     6 7 8
/// ```
pub fn lattice(k: u32) -> Vec<Point2> {
    (0..k * k)
        .map(|cell| [f64::from(cell % k), f64::from(k - 1 - cell / k)])
        .collect()
}

/// All (0.1 i, 0.1 j): a lattice whose rows are straight and whose diagonals are not.
pub fn lattice_of_tenths(k: u32) -> Vec<Point2> {
    lattice(k).into_iter().map(|p| p.map(|x| 0.1 * x)).collect()
}

/// All (2 i + j, i - 3 j): no two edges of the lattice are along an axis.
///
/// ```text
///         *
///       *     *
///         *     *
///             *
/// ```
pub fn sheared_lattice(k: u32) -> Vec<Point2> {
    lattice(k)
        .into_iter()
        .map(|[x, y]| [2.0 * x + y, x - 3.0 * y])
        .collect()
}

/// All (i, j) with |i| + |j| ≤ r: the corners are on the axes, the edges full of points.
///
/// ```text
///         *
///       * * *
///     * * * * *
///       * * *
///         *
/// ```
pub fn diamond(r: i32) -> Vec<Point2> {
    let mut points = Vec::new();
    for y in -r..=r {
        let width = r - y.abs();
        points.extend((-width..=width).map(|x| [f64::from(x), f64::from(y)]));
    }
    points
}

/// The outline of a square of side k, with a point at every unit and none inside.
///
/// ```text
///     *  *  *  *
///     *        *
///     *        *
///     *  *  *  *
/// ```
pub fn square_outline(k: u32) -> Vec<Point2> {
    let side = f64::from(k);
    (0..k)
        .map(f64::from)
        .flat_map(|t| [[t, 0.0], [side, t], [side - t, side], [0.0, side - t]])
        .collect()
}

/// The outline of a right triangle with legs of length k, with a point at every unit.
///
/// ```text
///     *
///     *  *
///     *     *
///     *  *  *  *
/// ```
pub fn triangle_outline(k: u32) -> Vec<Point2> {
    let leg = f64::from(k);
    (0..k)
        .map(f64::from)
        .flat_map(|t| [[t, 0.0], [leg - t, t], [0.0, leg - t]])
        .collect()
}

/// `count` columns of `height` points each, the columns one apart, their points ever further apart.
///
/// ```text
///     *   *   *
///
///     *   *   *
///     *   *   *
/// ```
pub fn columns(count: u32, height: u32) -> Vec<Point2> {
    (0..count * height)
        .map(|cell| {
            let step = f64::from(cell / count);
            [f64::from(cell % count), step * step]
        })
        .collect()
}

/// [`columns`], with the axes exchanged.
pub fn rows(count: u32, length: u32) -> Vec<Point2> {
    columns(count, length)
        .into_iter()
        .map(|[x, y]| [y, x])
        .collect()
}

/// `n` steps up and to the right in turn: two parallel rows of corners.
///
/// ```text
///           *-*
///         *-*
///       *-*
///     *-*
/// ```
pub fn staircase(n: u32) -> Vec<Point2> {
    (0..n)
        .map(|i| [f64::from(i.div_ceil(2)), f64::from(i / 2)])
        .collect()
}

/// A row and a column that cross in the middle, with arms of length r.
///
/// ```text
///         *
///         *
///     * * * * *
///         *
///         *
/// ```
pub fn cross(r: i32) -> Vec<Point2> {
    (-r..=r)
        .map(f64::from)
        .flat_map(|t| [[t, 0.0], [0.0, t]])
        .collect()
}
