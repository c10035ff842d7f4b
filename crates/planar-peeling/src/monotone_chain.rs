//! Andrew's monotone chain.
//!
//! A. M. Andrew, *Another efficient algorithm for convex hulls in two dimensions*, Information Processing
//! Letters 9 (1979), 216-219.
//!
//! 1. Sort the points by x, then y.
//! 2. Walk the sorted points from left to right and keep a chain that only turns left: while the new point does
//!    not lie left of the chain's last edge, the chain's last point is no vertex. This is the lower chain.
//! 3. Walk back from right to left in the same way for the upper chain, and join the two at their ends.
//!
//! # Bound
//!
//! O(n log n) comparisons for the sort, then fewer than 4n orientations: each one either keeps a point (n a
//! chain) or removes one for good (fewer than n a chain). One array of n ids and one of the chain.
//!
//! # Invariants
//!
//! 1. The ids walked over are distinct points in lexicographic order.
//! 2. The chain is the lower (upper) hull of the points walked over so far.
//! 3. Every point lies in both chains exactly if all points are collinear and boundary points count (then the
//!    upper chain is the lower one reversed); with two points that is so under both conventions.
//!
//! # Departures
//!
//! None of substance. Andrew splits the points by the line through the two extreme points before he scans; like
//! most later descriptions, this one scans all points twice instead.
//!
//! # When not to use it
//!
//! When few points are extreme and n is large: the sort alone then costs more than method GS. It is the better
//! choice when most points are extreme, and has no bad case.

use geometry_core::hull2::sort_distinct;
use geometry_core::{Boundary, Hull2, HullError, Kernel2, Observer, Points, Sign, Step};

/// The convex hull of `points` by Andrew's monotone chain.
///
/// Returns ids of `points`, anticlockwise from the lexicographically smallest vertex; `boundary` says whether
/// points inside an edge count.
///
/// # Errors
///
/// None: rounded kernels may cause a wrong hull, but the scan always ends.
///
/// # Cost
///
/// O(n log n) lexicographic comparisons, fewer than 4n orientations; 2n ids of memory.
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::monotone_chain::monotone_chain;
/// let points = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
/// let hull = |boundary| monotone_chain(Points::new(&points)?, boundary, &Exact, &mut Silent);
/// assert_eq!(hull(Boundary::Extreme)?.vertices(), [0, 2, 3, 4]);
/// assert_eq!(hull(Boundary::All)?.vertices(), [0, 1, 2, 3, 4]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn monotone_chain<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let mut ids: Vec<u32> = points.ids().collect();
    sort_distinct(points, &mut ids, kernel);
    let hull = hull_of_sorted(points, &ids, boundary, kernel, observer);
    let vertices = hull.vertices();
    for (&from, &to) in vertices.iter().zip(vertices.iter().cycle().skip(1)) {
        observer.step(|| Step::Edge(from, to));
    }
    Ok(hull)
}

/// The hull of the distinct points `ids`, which are in lexicographic order (invariant 1).
pub(crate) fn hull_of_sorted<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    ids: &[u32],
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Hull2 {
    if let [only] = ids {
        return Hull2::Point(*only);
    }
    let mut chain = Vec::new();
    extend_chain(
        points,
        ids.iter().copied(),
        boundary,
        kernel,
        observer,
        &mut chain,
    );
    let lower = chain.pop().map_or(0, |_| chain.len());
    extend_chain(
        points,
        ids.iter().rev().copied(),
        boundary,
        kernel,
        observer,
        &mut chain,
    );
    chain.pop();
    let upper = chain.len() - lower;
    // Invariant 3; each chain is counted without its last point.
    if lower + 1 == ids.len() && upper + 1 == ids.len() {
        return Hull2::Segment(ids.to_vec());
    }
    Hull2::from_cycle(points, chain)
}

/// Walks `ids` and appends their chain to `chain`, whose present end is left alone.
fn extend_chain<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    ids: impl Iterator<Item = u32>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
    chain: &mut Vec<u32>,
) {
    let floor = chain.len();
    for id in ids {
        observer.step(|| Step::Visit(id));
        while let [.., a, b] = chain[floor..] {
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
}

/// Whether the middle point of a turn of this orientation stays on an anticlockwise boundary.
pub(crate) fn keeps(boundary: Boundary, turn: Sign) -> bool {
    match boundary {
        Boundary::Extreme => turn.is_positive(),
        Boundary::All => !turn.is_negative(),
    }
}
