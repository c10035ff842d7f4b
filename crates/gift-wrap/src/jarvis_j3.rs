//! Method J3: the march over points sorted by x, to the right by smallest slope and back.
//!
//! **Source.** P. J. Green and B. W. Silverman, "Constructing the convex hull of a set of points in the plane",
//! *The Computer Journal* 22(3), 262–266, 1979, section 5: "a method similar to those considered by Jarvis".
//!
//! **Essence.**
//!
//! 1. Sort the points by x. The leftmost is the first vertex.
//! 2. Of the lines from the last vertex to all points on its right, take the one of smallest slope: it leads to
//!    the next vertex. Repeat until the rightmost point is reached.
//! 3. Return in the same way round the upper half: to all points on the left, until the leftmost is reached.
//!
//! ```text
//!                 _____ <- - -
//!             .-''     ''--.       upper half: only points on the left
//!          v1      .        v4     are looked at
//!            \  .      .  .'
//!             v2 ______ v3         lower half: only points on the right
//!                - - ->
//! ```
//!
//! **Bound.** O(n log n) lexicographic comparisons, and for each vertex one orientation for every point further
//! on: O(n h), with about half of J1's constant for vertices spread evenly. Space: 2 n indices.
//!
//! **Invariants.**
//!
//! 1. The vertices found are consecutive on the hull, anticlockwise; under [`Boundary::Extreme`] each is a corner.
//! 2. Points already passed on this half of the way cannot be vertices of this half; and the place of the last vertex
//!    in the order moves towards the end of the half, so there are at most 2 n searches, whatever the kernel answers.
//!
//! Order by x, then y, acts as a shear by an infinitesimal: a vertical right side belongs to the lower half, a
//! vertical left side to the upper.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** Once the points are sorted by x, one scan (`monotone-chain`) finds the hull in O(n)
//! more, about four orientations a point; the searches need h/2 of them.

use crate::search::{Arrival, Search, arrive};
use geometry_core::hull2::sort_distinct;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Points, Step};

/// Where this file departs from the source, and why.
pub const DEPARTURES: &[&str] = &[
    "of two candidates the one of smaller slope is told by one orientation instead of by comparing two \
     quotients, which also covers vertical lines",
    "points of equal x are ordered by y and copies are dropped after the sort; the source leaves both aside",
];

/// The convex hull by Green and Silverman's method J3.
///
/// # Errors
///
/// [`HullError::Contradiction`] if the way back meets a vertex of the way out; cannot happen with an exact kernel.
///
/// # Cost
///
/// O(n log n) lexicographic comparisons, O(n h) orientations. Space O(n).
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 0.0], [2.0, 4.0], [2.0, 2.0]];
/// let points = Points::new(&points)?;
/// let hull = |boundary| gift_wrap::jarvis_j3(points, boundary, &Exact, &mut Silent);
/// assert_eq!(hull(Boundary::Extreme)?.vertices(), [0, 1, 3]);
/// assert_eq!(hull(Boundary::All)?.vertices(), [0, 2, 1, 3]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn jarvis_j3<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let mut order: Vec<u32> = points.ids().collect();
    sort_distinct(points, &mut order, kernel);
    if order.len() < 2 {
        return Ok(Hull2::from_cycle(points, order));
    }
    let search = Search {
        points,
        boundary,
        kernel,
    };
    let mut walk = vec![order[0]];
    observer.step(|| Step::Push(order[0]));
    walk_to_end(&search, &mut walk, order.iter().copied(), observer)?;
    match walk_to_end(&search, &mut walk, order.iter().rev().copied(), observer)? {
        Arrival::TurnedBack => Ok(Hull2::of_collinear(points, walk, boundary, kernel)),
        _ => Ok(Hull2::from_cycle(points, walk)),
    }
}

/// Walks from the last vertex of `walk`, which is the first of `way`, to the last point of `way`.
fn walk_to_end<K: Kernel2, O: Observer>(
    search: &Search<'_, K>,
    walk: &mut Vec<u32>,
    mut way: impl Iterator<Item = u32> + Clone,
    observer: &mut O,
) -> Result<Arrival, HullError> {
    way.next();
    loop {
        let Some((place, next)) = search.next_vertex(walk, way.clone(), observer) else {
            return Ok(Arrival::New);
        };
        let from = walk[walk.len() - 1];
        observer.step(|| Step::Edge(from, next));
        match arrive(walk, next)? {
            Arrival::New => walk.push(next),
            end => return Ok(end),
        }
        observer.step(|| Step::Push(next));
        way.nth(place);
    }
}
