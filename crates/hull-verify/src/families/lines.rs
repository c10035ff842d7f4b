//! Collinear points, and points that are collinear but for a rounding.

use geometry_core::Point2;

/// `n` points in a row, from the middle outwards so that no end comes first.
///
/// ```text
///     … 5 3 1 0 2 4 …
/// ```
pub fn horizontal(n: usize) -> Vec<Point2> {
    steps(n).map(|t| [t, 2.0]).collect()
}

/// `n` points in a column.
pub fn vertical(n: usize) -> Vec<Point2> {
    steps(n).map(|t| [-1.0, t]).collect()
}

/// `n` points on the line y = x.
///
/// ```text
///             2
///           0
///         1
///       3
/// ```
pub fn diagonal(n: usize) -> Vec<Point2> {
    steps(n).map(|t| [t, t]).collect()
}

/// `n` points on a line that falls to the right.
pub fn falling(n: usize) -> Vec<Point2> {
    steps(n).map(|t| [2.0 * t, 1.0 - 3.0 * t]).collect()
}

/// `n` points on a line so steep that they differ far more in y than in x.
pub fn steep(n: usize) -> Vec<Point2> {
    steps(n)
        .map(|t| [t * 2.0_f64.powi(-30), t * 2.0_f64.powi(30)])
        .collect()
}

/// 0, 1, -1, 2, -2, …: `n` of them.
fn steps(n: usize) -> impl Iterator<Item = f64> {
    (0..n as u32).map(|i| {
        let half = f64::from(i.div_ceil(2));
        if i % 2 == 1 { half } else { -half }
    })
}

/// (0.1 i, 0.3 i): collinear in decimals, and a ragged band one rounding wide in binary.
///
/// ```text
///     y
///     |              .  '
///     |         .  '           a dot is rounded down, a tick up
///     |    '  .
///     | . '
///     +------------------ x
/// ```
pub fn tenths(n: usize) -> Vec<Point2> {
    (0..n as u32)
        .map(|i| [0.1 * f64::from(i), 0.3 * f64::from(i)])
        .collect()
}

/// (0.1 i, 0.1 i): rounded, and on one line all the same.
pub fn tenths_on_one_line(n: usize) -> Vec<Point2> {
    (0..n as u32).map(|i| [0.1 * f64::from(i); 2]).collect()
}

/// (i / 3, i / 7): rounded quotients along a line through the origin.
pub fn thirds(n: usize) -> Vec<Point2> {
    (0..n as u32)
        .map(|i| [f64::from(i) / 3.0, f64::from(i) / 7.0])
        .collect()
}

/// `n` points on y = x, moved in turn by no, one up, and one down ulp.
///
/// ```text
///            '  .  -
///      '  .  -
/// ```
pub fn ulp_off(n: usize) -> Vec<Point2> {
    (0..n as u32)
        .map(|i| {
            let x = 1.0 + f64::from(i) / 64.0;
            match i % 3 {
                0 => [x, x],
                1 => [x, x.next_up()],
                _ => [x, x.next_down()],
            }
        })
        .collect()
}

/// `n` collinear points, the middle one moved up by an ulp: a triangle with a row of points on its base.
///
/// ```text
///               '
///     .  .  .      .  .  .
/// ```
pub fn one_ulp_off(n: usize) -> Vec<Point2> {
    let mut points: Vec<Point2> = (0..n as u32).map(|i| [f64::from(i), 1.0]).collect();
    if let Some(middle) = points.get_mut(n / 2) {
        middle[1] = middle[1].next_up();
    }
    points
}

/// `n` points in a row and one above: a triangle most of whose points are on one edge.
///
/// ```text
///             *
///
///     *  *  *  *  *  *
/// ```
pub fn line_and_apex(n: usize) -> Vec<Point2> {
    let mut points = horizontal(n);
    points.push([0.5, 6.0]);
    points
}

/// `n` points in a row, one above and one below: all but the two ends of the row are inside.
///
/// ```text
///             *
///     *  *  *  *  *  *
///          *
/// ```
pub fn line_and_two_apexes(n: usize) -> Vec<Point2> {
    let mut points = line_and_apex(n);
    points.insert(0, [0.0, -5.0]);
    points
}

/// A k × k grid of neighbouring `f64` values just above (1/2, 1/2), between two points far along y = x: most
/// rounded orientations of the three are wrong.
///
/// ```text
///                             24, 24
///           12, 12
///     ::::
///     ::::   (1/2 + i u, 1/2 + j u), u = 2⁻⁵³
/// ```
///
/// After L. Kettner, K. Mehlhorn, S. Pion, S. Schirra, C. Yap, *Classroom examples of robustness problems in
/// geometric computations*, Computational Geometry 40 (2008).
pub fn classroom(k: usize) -> Vec<Point2> {
    let u = f64::EPSILON / 2.0;
    let near = |i: usize| 0.5 + i as f64 * u;
    let mut points = vec![[12.0, 12.0], [24.0, 24.0]];
    points.extend((0..k * k).map(|cell| [near(cell / k), near(cell % k)]));
    points
}
