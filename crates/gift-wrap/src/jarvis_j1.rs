//! Jarvis's march: from each hull vertex, search all points for the next.
//!
//! **Paper.** R. A. Jarvis, "On the identification of the convex hull of a finite set of points in the plane",
//! *Information Processing Letters* 2(1), 18–21, 1973; in the form that P. J. Green and B. W. Silverman,
//! *The Computer Journal* 22(3), 262–266, 1979, section 5, call J1.
//!
//! **Essence.**
//!
//! 1. The leftmost point is the first vertex, v1.
//! 2. From the last vertex v_i, search through all the points for the one that leaves no other on the right of
//!    the line to it: v_{i+1}.
//! 3. If that is v1, the hull is found; otherwise repeat step 2.
//!
//! ```text
//!            v4 ------- v3
//!           /             \         from v3, the line to v4 leaves
//!          /     .    .    \        every other point on its left
//!        v1 --___     .   v2
//!                '''---'''
//! ```
//!
//! **Bound.** Each search asks one orientation of every point but two: h (n-2) for h vertices, and n - 1
//! lexicographic comparisons for the first vertex. O(n h); O(n²) when all points are vertices. Space: the
//! vertices.
//!
//! **Invariants.**
//!
//! 1. The vertices found are consecutive on the hull, anticlockwise; under [`Boundary::Extreme`] each is a corner.
//! 2. No vertex is met twice, so there are at most n searches.
//! 3. Only on collinear points does the walk turn back (why, `search.rs` says).
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When h may be large: at h above log n or so the methods that sort win. With few
//! vertices among many points it is hard to beat for brevity and needs no storage.

use crate::search::{Arrival, Search, arrive, leftmost};
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Points, Step};

/// Where this file departs from the paper, and why.
pub const DEPARTURES: &[&str] = &[
    "of two candidates the better is told by one orientation instead of by comparing two angles: no inverse \
     tangent, no rounding, and fewer operations than the paper's",
    "the first vertex is found by one pass, which Green and Silverman note to be quicker than Jarvis's way",
    "ties, copies and collinear points are decided by stated rules; the paper leaves them aside",
];

/// The convex hull by Jarvis's first method: every search goes through all points.
///
/// # Errors
///
/// [`HullError::Contradiction`] if the walk meets a vertex again that is not the first; cannot happen with an
/// exact kernel.
///
/// # Cost
///
/// h (n - 2) orientations for h vertices and no copies. Space: the result.
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Counted, Exact, Points, Silent};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, 4.0], [2.0, 2.0]];
/// let kernel = Counted::new(Exact);
/// let hull = gift_wrap::jarvis_j1(Points::new(&points)?, Boundary::Extreme, &kernel, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 3]);
/// assert_eq!(kernel.counts().orientations.total(), 3 * (5 - 2));
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn jarvis_j1<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let search = Search {
        points,
        boundary,
        kernel,
    };
    let mut walk: Vec<u32> = leftmost(points, kernel).into_iter().collect();
    while let Some(&from) = walk.last() {
        observer.step(|| Step::Push(from));
        let others = points.ids().filter(|&id| id != from);
        let Some((_, next)) = search.next_vertex(&walk, others, observer) else {
            break; // Every point is a copy of the first.
        };
        observer.step(|| Step::Edge(from, next));
        match arrive(&walk, next)? {
            Arrival::New => walk.push(next),
            Arrival::Closed => break,
            Arrival::TurnedBack => return Ok(Hull2::of_collinear(points, walk, boundary, kernel)),
        }
    }
    Ok(Hull2::from_cycle(points, walk))
}
