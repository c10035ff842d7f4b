//! Hulls and layers straight from the definition, for small sets. In space: [`hull3`].
//!
//! An edge of the hull is a directed pair of points with no point to its right. From a boundary point p the
//! pairs p→q of that kind all lead in one direction, along the edge that leaves p; the nearest such q is the next
//! boundary point, the furthest the next corner. So the hull is read off the definition of an edge, and there is
//! nothing to get wrong but the [arithmetic](crate::arithmetic), which is that of the checker.

mod space;

pub use space::hull3;

use crate::arithmetic::{Frame, Turn, order};
use geometry_core::{Boundary, Hull2, Layers, Point2};

/// The hull of `points`, which must be finite and fewer than 2³².
///
/// # Cost
///
/// O(n² h) time at most, O(n) space.
///
/// ```
/// use geometry_core::{Boundary, Hull2};
/// use hull_verify::oracle;
/// let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 0.0]];
/// assert_eq!(oracle::hull2(&points, Boundary::Extreme), Hull2::Polygon(vec![0, 2, 3]));
/// assert_eq!(oracle::hull2(&points, Boundary::All), Hull2::Polygon(vec![0, 1, 2, 3]));
/// ```
pub fn hull2(points: &[Point2], boundary: Boundary) -> Hull2 {
    hull_of(
        points,
        Frame::of(points),
        (0..points.len() as u32).collect(),
        boundary,
    )
}

/// The convex layers of `points`, which must be finite and fewer than 2³²: the hull, removed with all copies of
/// its vertices, until nothing is left.
///
/// # Cost
///
/// O(n² h) time at most, where h counts the vertices of all layers; O(n) space.
///
/// ```
/// use geometry_core::{Boundary, Hull2};
/// use hull_verify::oracle;
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0], [1.0, 1.0]];
/// let layers = oracle::layers(&points, Boundary::Extreme);
/// assert_eq!(layers.rings(), [Hull2::Polygon(vec![0, 1, 2]), Hull2::Point(3)]);
/// assert_eq!(layers.c_ranks(), [1, 1, 1, 2, 2]);
/// ```
pub fn layers(points: &[Point2], boundary: Boundary) -> Layers {
    let frame = Frame::of(points);
    let at = |id: u32| points[id as usize];
    let mut rings = Vec::new();
    let mut ranks = vec![0; points.len()];
    let mut left: Vec<u32> = (0..points.len() as u32).collect();
    while !left.is_empty() {
        let ring = hull_of(points, frame, left.clone(), boundary);
        let rank = rings.len() as u32 + 1;
        left.retain(|&id| {
            let removed = ring
                .vertices()
                .iter()
                .any(|&v| order(at(v), at(id)).is_eq());
            if removed {
                ranks[id as usize] = rank;
            }
            !removed
        });
        rings.push(ring);
    }
    Layers::new(rings, ranks)
}

/// The hull of the points `ids`.
fn hull_of(points: &[Point2], frame: Frame, mut ids: Vec<u32>, boundary: Boundary) -> Hull2 {
    let at = |id: u32| points[id as usize];
    ids.sort_by(|&a, &b| order(at(a), at(b)).then(a.cmp(&b)));
    ids.dedup_by(|later, kept| order(at(*later), at(*kept)).is_eq());
    let (first, last) = match ids[..] {
        [] => return Hull2::Empty,
        [only] => return Hull2::Point(only),
        [first, .., last] => (first, last),
    };
    let on_line = |&id: &u32| frame.turn(at(first), at(last), at(id)) == Turn::Straight;
    if ids.iter().all(on_line) {
        return Hull2::Segment(match boundary {
            Boundary::Extreme => vec![first, last],
            Boundary::All => ids,
        });
    }
    let mut cycle = vec![first];
    let mut corner = first;
    // The successors of boundary points run round the boundary and come back to the first.
    while let Some(next) = successor(points, frame, &ids, corner, boundary)
        && next != first
        && cycle.len() < ids.len()
    {
        cycle.push(next);
        corner = next;
    }
    Hull2::Polygon(cycle)
}

/// The vertex after the boundary point p: of all q with no point to the right of p→q the furthest, or the
/// nearest under [`Boundary::All`]. `ids` are distinct points in lexicographic order, not all collinear.
fn successor(
    points: &[Point2],
    frame: Frame,
    ids: &[u32],
    p: u32,
    boundary: Boundary,
) -> Option<u32> {
    let at = |id: u32| points[id as usize];
    let none_right = |q: u32| {
        ids.iter()
            .all(|&r| frame.turn(at(p), at(q), at(r)) != Turn::Right)
    };
    let mut ahead = ids.iter().copied().filter(|&q| q != p && none_right(q));
    // They lie on one ray from p, in lexicographic order, so the first is an end and so is the last.
    let first = ahead.next()?;
    let last = ahead.next_back().unwrap_or(first);
    let ascending = order(at(p), at(first)).is_lt();
    match (boundary, ascending) {
        (Boundary::Extreme, true) | (Boundary::All, false) => Some(last),
        (Boundary::Extreme, false) | (Boundary::All, true) => Some(first),
    }
}
