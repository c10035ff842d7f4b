//! Points on curves and nested polygons: many vertices, or many layers.

use geometry_core::Point2;
use std::f64::consts::{PI, TAU};

/// `n` points on the unit circle, rounded: nearly all of them corners.
///
/// ```text
///         . - .
///       '       '
///       .       .
///         ' - '
/// ```
pub fn circle(n: u32) -> Vec<Point2> {
    (0..n)
        .map(|i| {
            let angle = TAU * f64::from(i) / f64::from(n);
            [angle.cos(), angle.sin()]
        })
        .collect()
}

/// All integer points on the circle of radius 65, exactly cocircular; those on the axes twice.
pub fn integer_circle() -> Vec<Point2> {
    let legs = [(0, 65), (16, 63), (25, 60), (33, 56), (39, 52)];
    let mut points = Vec::new();
    for (a, b) in legs {
        for (x, y) in [(a, b), (b, a)] {
            for (sx, sy) in [(1, 1), (-1, 1), (-1, -1), (1, -1)] {
                points.push([f64::from(sx * x), f64::from(sy * y)]);
            }
        }
    }
    points
}

/// [`integer_circle`], and points along both axes.
pub fn integer_circle_and_axes() -> Vec<Point2> {
    let mut points = integer_circle();
    points.extend((-4..=4).map(|t| [f64::from(t * 13), 0.0]));
    points.extend((-4..=4).map(|t| [0.0, f64::from(t * 13)]));
    points
}

/// 2n + 1 points (i, i²): every one a corner.
///
/// ```text
///     *           *
///      *         *
///        *  *  *
/// ```
pub fn parabola(n: i32) -> Vec<Point2> {
    (-n..=n).map(|i| [f64::from(i), f64::from(i * i)]).collect()
}

/// 2n + 1 points (i², i): the same, lying on its side.
pub fn lying_parabola(n: i32) -> Vec<Point2> {
    parabola(n).into_iter().map(|[x, y]| [y, x]).collect()
}

/// `n` points on a parabola with abscissae 1, 1/2, 1/4, …: the furthest point from a chord always splits
/// off one point, so quickhull takes a quadratic number of steps.
///
/// ```text
///                                   *
///
///                 *
///     ***  *
/// ```
///
/// For n above 500 the ordinates underflow; up to then they are exact.
pub fn geometric_parabola(n: i32) -> Vec<Point2> {
    (0..n)
        .map(|i| [2.0_f64.powi(-i), 2.0_f64.powi(-2 * i)])
        .collect()
}

/// `n` triangles one inside the other, each a layer.
///
/// ```text
///     *---------------*
///      \   *-----*   /
///       \   \ * /   /
///        \    *    /
///             *
/// ```
pub fn nested_triangles(n: u32) -> Vec<Point2> {
    (1..=n)
        .map(f64::from)
        .flat_map(|r| [[-4.0 * r, 3.0 * r], [4.0 * r, 3.0 * r], [0.0, -5.0 * r]])
        .collect()
}

/// `n` squares one inside the other, with the middles of their edges.
///
/// ```text
///     *-----*-----*
///     |  *--*--*  |
///     *  *     *  *
///     |  *--*--*  |
///     *-----*-----*
/// ```
pub fn nested_squares(n: u32) -> Vec<Point2> {
    let ring = [-1.0, 0.0, 1.0].map(|x| [-1.0, 0.0, 1.0].map(|y| [x, y]));
    (1..=n)
        .map(f64::from)
        .flat_map(|r| ring.into_iter().flatten().map(move |[x, y]| [r * x, r * y]))
        .filter(|&p| p != [0.0, 0.0])
        .collect()
}

/// `n` points on a spiral that winds inwards, outermost last.
pub fn spiral(n: u32) -> Vec<Point2> {
    (1..=n)
        .map(|i| {
            let (angle, radius) = (PI * 0.37 * f64::from(i), f64::from(i));
            [radius * angle.cos(), radius * angle.sin()]
        })
        .collect()
}
