//! Graham's scan (method G of Green and Silverman).
//!
//! R. L. Graham, *An efficient algorithm for determining the convex hull of a finite planar set*, Information
//! Processing Letters 1 (1972), 132-133.
//!
//! 1. Find a point inside the hull, the pole: the centroid of three points that are not collinear.
//! 2. Sort the points by their polar angle about the pole. Of points at one angle only the furthest can be on the
//!    boundary; the nearer ones go.
//! 3. Walk round from a vertex. While three consecutive points do not turn left, the middle one is no vertex.
//!
//! # Bound
//!
//! O(n log n) comparisons of angles, each of at most one orientation, then fewer than 2n orientations: each keeps a
//! point or removes one for good.
//!
//! # Invariants
//!
//! 1. The points walked over have distinct angles about the pole, in increasing order, and begin with the
//!    lexicographically smallest point, a vertex; points in line with the pole occur only on the two edges that
//!    meet in a pole which is that vertex.
//! 2. The chain is the boundary of the points walked over, as seen from the pole.
//!
//! # Departures
//!
//! 1. The centroid is rounded, so it may lie outside the triangle, and is used only if exact orientations put it
//!    strictly inside. Where no double does (three points an ulp apart, say), the lexicographically smallest point is
//!    the pole: still Graham's scan, with all angles within a half turn.
//! 2. Under [`Boundary::All`] and with that second pole, the points in line with it on the first edge are kept in
//!    outward order, those on the last in inward order. With an interior pole nothing is special: a ray from inside
//!    leaves the hull in one point.
//! 3. The walk starts at the lexicographically smallest point, not at an arbitrary one, and so needs no second round.
//!
//! # When not to use it
//!
//! It is the history of the monotone chain, which sorts without orientations and needs no pole.

use crate::monotone_chain::keeps;
use geometry_core::sort::merge_sort;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Point2, Points, Step};

/// The convex hull of `points` by Graham's scan.
///
/// Returns ids of `points`, anticlockwise from the lexicographically smallest vertex; `boundary` says whether
/// points inside an edge count.
///
/// # Errors
///
/// None: rounded kernels may cause a wrong hull, but the sort and the scan always end.
///
/// # Cost
///
/// O(n log n) comparisons of angles, fewer than 2n orientations; 3n ids of memory.
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::graham::graham;
/// let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
/// let hull = |boundary| graham(Points::new(&points)?, boundary, &Exact, &mut Silent);
/// assert_eq!(hull(Boundary::Extreme)?.vertices(), [0, 2, 3, 4]);
/// assert_eq!(hull(Boundary::All)?.vertices(), [0, 1, 2, 3, 4]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn graham<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let Some(triangle) = triangle(points, kernel) else {
        let ids = points.ids().collect();
        return Ok(Hull2::of_collinear(points, ids, boundary, kernel));
    };
    let start = lexicographic_minimum(points, kernel);
    let around = match point_inside(triangle.map(|id| points[id]), kernel) {
        Some(pole) => around_interior(points, pole, start, kernel, observer),
        None => around_vertex(points, start, boundary, kernel, observer),
    };
    let vertices = scan(points, &around, boundary, kernel, observer);
    let closed = vertices.iter().zip(vertices.iter().cycle().skip(1));
    for (&from, &to) in closed {
        observer.step(|| Step::Edge(from, to));
    }
    Ok(Hull2::from_cycle(points, vertices))
}

/// Three points that are not collinear, if there are any.
fn triangle<K: Kernel2>(points: Points<'_, 2>, kernel: &K) -> Option<[u32; 3]> {
    let a = points.ids().next()?;
    let differs = |&id: &u32| kernel.lexicographic(points[a], points[id]).is_ne();
    let b = points.ids().find(differs)?;
    let off_line = |&id: &u32| !kernel.orient(points[a], points[b], points[id]).is_zero();
    let c = points.ids().skip(b as usize + 1).find(off_line)?;
    Some([a, b, c])
}

/// The lexicographically smallest point; of copies, the one with the smallest index.
fn lexicographic_minimum<K: Kernel2>(points: Points<'_, 2>, kernel: &K) -> u32 {
    let smaller = |least: u32, id: u32| {
        if kernel.lexicographic(points[id], points[least]).is_lt() {
            id
        } else {
            least
        }
    };
    points.ids().reduce(smaller).unwrap_or(0)
}

/// The rounded centroid of the triangle, if it lies strictly inside.
fn point_inside<K: Kernel2>([a, b, c]: [Point2; 3], kernel: &K) -> Option<Point2> {
    // Thirds, so that the sum can't overflow.
    let centroid = [0, 1].map(|axis| a[axis] / 3.0 + b[axis] / 3.0 + c[axis] / 3.0);
    let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| kernel.orient(p, q, centroid));
    let inside = !sides[0].is_zero() && sides.iter().all(|side| *side == sides[0]);
    inside.then_some(centroid)
}

/// The points that can be on the boundary, anticlockwise around the interior point `pole` from `start`.
fn around_interior<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    pole: Point2,
    start: u32,
    kernel: &K,
    observer: &mut O,
) -> Vec<u32> {
    let sorted = sorted_by_angle(points, pole, kernel, observer);
    let mut around = Vec::with_capacity(sorted.len());
    for ray in rays(points, pole, &sorted, kernel) {
        around.extend(furthest(points, pole, ray, kernel));
    }
    let place = around.iter().position(|&id| id == start);
    around.rotate_left(place.unwrap_or(0));
    around
}

/// The points that can be on the boundary, anticlockwise around the vertex `start`, and that first.
fn around_vertex<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    start: u32,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Vec<u32> {
    let pole = points[start];
    let mut sorted = sorted_by_angle(points, pole, kernel, observer);
    let lengths: Vec<usize> = rays(points, pole, &sorted, kernel)
        .map(<[u32]>::len)
        .collect();
    let mut around = vec![start];
    let mut behind = &mut sorted[..];
    for (number, &length) in (1..).zip(&lengths) {
        let (ray, rest) = behind.split_at_mut(length);
        behind = rest;
        // The first and the last ray are edges, and all points on them are on the boundary (departure 2).
        let is_edge = number == 1 || number == lengths.len();
        if boundary == Boundary::Extreme || !is_edge {
            around.extend(furthest(points, pole, ray, kernel));
            continue;
        }
        let mut outwards = outwards(points, pole, ray, kernel);
        if number == lengths.len() {
            outwards.reverse();
        }
        around.append(&mut outwards);
    }
    around
}

/// The distinct points of a ray, from `pole` outwards.
fn outwards<K: Kernel2>(
    points: Points<'_, 2>,
    pole: Point2,
    ray: &mut [u32],
    kernel: &K,
) -> Vec<u32> {
    let direction = points[ray[0]];
    merge_sort(ray, &mut vec![0; ray.len()], |a, b| {
        let order = kernel.compare_along(pole, direction, points[a], points[b]);
        order.then(a.cmp(&b))
    });
    let mut distinct = ray.to_vec();
    distinct.dedup_by(|later, kept| kernel.lexicographic(points[*later], points[*kept]).is_eq());
    distinct
}

/// All points but `pole` and its copies, by angle about it, then by index.
fn sorted_by_angle<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    pole: Point2,
    kernel: &K,
    observer: &mut O,
) -> Vec<u32> {
    let mut ids = Vec::with_capacity(points.len());
    for id in points.ids() {
        observer.step(|| Step::Visit(id));
        if kernel.lexicographic(points[id], pole).is_ne() {
            ids.push(id);
        }
    }
    let mut scratch = vec![0; ids.len()];
    merge_sort(&mut ids, &mut scratch, |a, b| {
        kernel.compare_angle(pole, points[a], points[b])
    });
    ids
}

/// The runs of one angle.
fn rays<'a, K: Kernel2>(
    points: Points<'a, 2>,
    pole: Point2,
    sorted: &'a [u32],
    kernel: &'a K,
) -> impl Iterator<Item = &'a [u32]> {
    sorted.chunk_by(move |&a, &b| kernel.compare_angle(pole, points[a], points[b]).is_eq())
}

/// The point of a ray furthest from `pole`; of copies, the one with the smallest index.
fn furthest<K: Kernel2>(
    points: Points<'_, 2>,
    pole: Point2,
    ray: &[u32],
    kernel: &K,
) -> Option<u32> {
    ray.iter().copied().reduce(|best, id| {
        let direction = points[best];
        let further = kernel.compare_along(pole, direction, points[id], points[best]);
        if further.is_gt() { id } else { best }
    })
}

/// The points of `around` that make left turns only (or, under [`Boundary::All`], no right turns).
fn scan<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    around: &[u32],
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Vec<u32> {
    let mut chain: Vec<u32> = Vec::new();
    let start = around.first().copied();
    // The start comes round again and closes the chain, but is not put on it twice.
    for id in around.iter().copied().chain(start) {
        while let [.., a, b] = chain[..] {
            observer.step(|| Step::Line(a, b));
            if keeps(boundary, kernel.orient(points[a], points[b], points[id])) {
                break;
            }
            observer.step(|| Step::Pop(b));
            chain.pop();
        }
        observer.step(|| Step::Push(id));
        chain.push(id);
    }
    chain.pop();
    chain
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::{Exact, Silent};

    /// Around three points an ulp apart there is no room for a centroid, and a vertex is the pole.
    #[test]
    fn points_without_room_inside() {
        let ulp = f64::from_bits(1);
        let triangle = [[0.0, 0.0], [ulp, 0.0], [0.0, ulp]];
        assert_eq!(point_inside(triangle, &Exact), None);
        let cells = (0..9).map(|cell| [f64::from(cell / 3) * ulp, f64::from(cell % 3) * ulp]);
        let points: Vec<[f64; 2]> = cells.chain(triangle).collect();
        let points = Points::new(&points).expect("finite points");
        let hull = |boundary| graham(points, boundary, &Exact, &mut Silent);
        assert_eq!(
            hull(Boundary::Extreme),
            Ok(Hull2::Polygon(vec![0, 6, 8, 2]))
        );
        let all = vec![0, 3, 6, 7, 8, 5, 2, 1];
        assert_eq!(hull(Boundary::All), Ok(Hull2::Polygon(all)));
    }
}
