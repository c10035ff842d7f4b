//! Jarvis's second method: the march over points sorted by angle, which drops those it has passed.
//!
//! **Paper.** R. A. Jarvis, "On the identification of the convex hull of a finite set of points in the plane",
//! *Information Processing Letters* 2(1), 18–21, 1973; in the form that P. J. Green and B. W. Silverman,
//! *The Computer Journal* 22(3), 262–266, 1979, section 5, call J2.
//!
//! **Essence.**
//!
//! 1. The leftmost point is the first vertex, v1. Sort all others by angle about it.
//! 2. The first of them is v2.
//! 3. From the last vertex v_i, search for the next one only among the points on the far side of the line v1 v_i,
//!    that is, those after v_i in the order, and v1 itself. The others lie in the hull of the vertices found.
//! 4. If the search gives v1, the hull is found; otherwise repeat step 3.
//!
//! ```text
//!        z
//!        |      .      v_i ____         sought: the points between
//!        |   .     .  / :::::: \        the rays v1 z and v1 v_i
//!        | .   .    / :::::::::  v3
//!        |      . /:::::::::::::/       passed: those at ::::, in the
//!        v1 ----------:::::::: /        hull of v1 .. v_i
//!          '-----____::::::: /
//!                    ------ v2
//! ```
//!
//! **Bound.** O(n log n) comparisons of angles, and for each vertex one orientation for every point after it:
//! about half of J1's if the vertices are spread evenly, still O(n h). Space: 2 n indices while sorting, n after.
//!
//! **Invariants.**
//!
//! 1. The vertices found are consecutive on the hull, anticlockwise; under [`Boundary::Extreme`] each is a corner.
//! 2. All points up to the last vertex in the order lie in the hull of the vertices found.
//! 3. The place of the last vertex in the order increases, so there are at most n searches, whatever the kernel
//!    answers.
//!
//! Of points on one ray from v1 the nearer come first, as the walk meets those on the first edge; on the last
//! ray the further come first, as it meets those on the last edge. On rays between, at most the furthest is a vertex.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** Once the points are sorted by angle, Graham's scan (`graham`) finds the hull in O(n)
//! more. Searching instead pays only for a handful of vertices.

use crate::search::{Search, leftmost};
use geometry_core::sort::merge_sort;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Points, Step};
use std::cmp::Ordering;

/// Where this file departs from the paper, and why.
pub const DEPARTURES: &[&str] = &[
    "angles are compared by orientations, in the sort and in the searches, instead of computed",
    "points in one direction from the first vertex are ordered by distance so that boundary points come in the \
     order of the walk; copies of the first vertex are dropped; the paper leaves both aside",
];

/// The convex hull by Jarvis's second method: every search goes through the points not yet passed.
///
/// # Errors
///
/// None of its own: with a kernel that contradicts itself it gives some polygon.
///
/// # Cost
///
/// O(n log n) angle comparisons, O(n h) orientations. Space O(n).
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [2.0, 4.0], [2.0, 2.0]];
/// let points = Points::new(&points)?;
/// let hull = |boundary| gift_wrap::jarvis_j2(points, boundary, &Exact, &mut Silent);
/// assert_eq!(hull(Boundary::Extreme)?.vertices(), [0, 1, 3]);
/// assert_eq!(hull(Boundary::All)?.vertices(), [0, 2, 1, 3]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn jarvis_j2<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let Some(first) = leftmost(points, kernel) else {
        return Ok(Hull2::Empty);
    };
    let mut order = by_angle(points, first, kernel);
    let on_first_ray = ray_length(points, first, order.iter(), kernel);
    if on_first_ray == order.len() {
        order.push(first);
        return Ok(Hull2::of_collinear(points, order, boundary, kernel));
    }
    let on_last_ray = ray_length(points, first, order.iter().rev(), kernel);
    let last_ray = order.len() - on_last_ray;
    order[last_ray..].reverse();
    order.push(first); // The walk ends there.

    let search = Search {
        points,
        boundary,
        kernel,
    };
    let mut walk = vec![first];
    observer.step(|| Step::Push(first));
    let mut passed = 0;
    let mut reach = on_first_ray;
    loop {
        let candidates = order[passed..reach].iter().copied();
        let Some((place, next)) = search.next_vertex(&walk, candidates, observer) else {
            break;
        };
        for &id in &order[passed..passed + place] {
            observer.step(|| Step::Discard(id));
        }
        let from = walk[walk.len() - 1];
        observer.step(|| Step::Edge(from, next));
        if next == first {
            break;
        }
        observer.step(|| Step::Push(next));
        walk.push(next);
        passed += place + 1;
        reach = order.len();
    }
    Ok(Hull2::from_cycle(points, walk))
}

/// All points but `first` and its copies, by angle about it, on one ray from near to far.
fn by_angle<K: Kernel2>(points: Points<'_, 2>, first: u32, kernel: &K) -> Vec<u32> {
    let is_copy = |&id: &u32| kernel.lexicographic(points[id], points[first]) == Ordering::Equal;
    let mut order: Vec<u32> = points.ids().filter(|id| !is_copy(id)).collect();
    let mut scratch = vec![0; order.len()];
    merge_sort(&mut order, &mut scratch, |a, b| {
        let (a, b) = (points[a], points[b]);
        // All points are lexicographically beyond the first, so on a ray that order is the order of distance.
        kernel
            .compare_angle(points[first], a, b)
            .then_with(|| kernel.lexicographic(a, b))
    });
    order
}

/// How many points at the start of `order` lie on the same ray from `first`.
fn ray_length<'o, K: Kernel2>(
    points: Points<'_, 2>,
    first: u32,
    mut order: impl Iterator<Item = &'o u32>,
    kernel: &K,
) -> usize {
    let Some(&leader) = order.next() else {
        return 0;
    };
    let (center, leader) = (points[first], points[leader]);
    1 + order
        .take_while(|&&id| kernel.compare_angle(center, leader, points[id]) == Ordering::Equal)
        .count()
}
