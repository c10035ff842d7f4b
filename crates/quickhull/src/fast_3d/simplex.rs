//! The first tetrahedron: four points far apart, chosen in rounded arithmetic.
//!
//! 1. a and b are the first and the last along the axis of the widest extent.
//! 2. c is the furthest from the line ab.
//! 3. d is the furthest from the plane abc.
//!
//! Any four points that span space will do; how well they are spread only decides how fast the others are found to be
//! inside. So nothing here need be exact but the last question, whether the four span space. If they do not, or an overflow has
//! spoilt the choice, [`AffineBasis`](geometry_core::dimension::AffineBasis) finds what does.
//!
//! Of equal points the first is taken.

use super::plane::Span;
use geometry_core::{Kernel3, Point3};

/// Four points that span space, positively oriented, if rounded arithmetic finds such.
pub(super) fn spread<K: Kernel3>(points: &[Point3], kernel: &K, span: &Span) -> Option<[u32; 4]> {
    let axis = span.widest_axis();
    let a = points.iter().position(|p| p[axis] == span.low[axis])?;
    let b = points.iter().position(|p| p[axis] == span.high[axis])?;
    let (origin, along) = (points[a], minus(points[b], points[a]));
    let c = greatest(points, |p| {
        let [x, y, z] = cross(along, minus(p, origin));
        x * x + y * y + z * z
    })?;
    let normal = cross(along, minus(points[c], origin));
    let d = greatest(points, |p| {
        let w = minus(p, origin);
        (normal[0] * w[0] + normal[1] * w[1] + normal[2] * w[2]).abs()
    })?;
    let orientation = kernel.orient3(origin, points[b], points[c], points[d]);
    let [a, b, c, d] = [a, b, c, d].map(|place| place as u32);
    if orientation.is_zero() {
        None
    } else if orientation.is_positive() {
        Some([a, b, c, d])
    } else {
        Some([a, c, b, d])
    }
}

/// The first place of the greatest measure that is above zero.
///
/// Two passes a block: the greatest of a block comes from whole vectors, and only where it is a new record is it looked for.
fn greatest(points: &[Point3], measure: impl Fn(Point3) -> f64) -> Option<usize> {
    const BLOCK: usize = 64;
    let mut best = None;
    let mut record = 0.0;
    for (number, block) in points.chunks(BLOCK).enumerate() {
        let mut measures = [0.0; BLOCK];
        for (slot, &p) in measures.iter_mut().zip(block) {
            *slot = measure(p);
        }
        let (lanes, _) = measures.as_chunks::<8>();
        let mut highest = [0.0; 8];
        for lane in lanes {
            for (high, &x) in highest.iter_mut().zip(lane) {
                *high = if x > *high { x } else { *high };
            }
        }
        let high = highest.into_iter().fold(0.0, f64::max);
        if high > record {
            record = high;
            let place = measures.iter().position(|&x| x == high);
            best = place.map(|place| number * BLOCK + place);
        }
    }
    best
}

fn minus(p: Point3, q: Point3) -> Point3 {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn cross(u: Point3, v: Point3) -> Point3 {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}
