//! The fast planar hull: throw away what is certainly inside, sort the rest, scan it once.
//!
//! **Papers.** S. G. Akl and G. T. Toussaint, "A fast convex hull algorithm", *Information Processing Letters* 7 (1978),
//! 219–222: points inside the quadrilateral of the four extreme points need not be looked at again. L. Devroye and G. T.
//! Toussaint, "A note on linear expected time algorithms for finding convex hulls", *Computing* 26 (1981), 361–366: with
//! eight directions what is left is, for many distributions, too little to matter. A. M. Andrew's monotone chain
//! (1979) is the scan.
//!
//! **Essence.**
//!
//! 1. Find the points furthest along the axes and the diagonals, in a sample if there are many points: the corners of a
//!    polygon (`polygon`). Add the points furthest outside its edges while that cuts off much of the sample, and fit an
//!    `ellipse` or an `octagon` inside that is cheap to test (`cascade`).
//! 2. Pass over all points and drop those certainly in one of these or in the polygon: a few operations without a branch, in
//!    vectors (`region`, `cascade`).
//! 3. Refine the corners by the points left and drop again, while that drops many (`throw_away`).
//! 4. Split the rest by the line through the leftmost and the rightmost point, sort each side (`order`), and scan it for
//!    its chain (`chains`).
//!
//! **Bound.** O(n + m log m) for m points left, so never worse than O(n log n). A polygon of k corners leaves about
//! 6.6 / k² of a disc, so m is a few times the number of vertices there, as in a square and for normal points; on a
//! lattice it is the boundary, 4 √n. Tests a point do not grow with n in these, nor for Cauchy points: at most 1.2 passes
//! (`tests/fast_2d/counts.rs`). They do where the points lie close to their hull: on a circle or a parabola m = n. Space: 20
//! bytes and a key of 8 for each point left; up to 128 of them need no allocation besides the result.
//!
//! **Invariants.**
//!
//! 1. A point is dropped only if it is an inner point of the hull of input points: `polygon` has the proof. So neither
//!    a vertex nor a boundary point ever is, and the hull of the points left is that of all, under either
//!    [`Boundary`].
//! 2. A coordinate that is not finite is never dropped.
//! 3. The points left keep their order, so of copies the first stands for all.
//! 4. Which points are dropped depends on the coordinates and their order alone: the arithmetic is that of IEEE 754 without
//!    fused operations, on every machine.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** To study the cost of a method in questions asked: here most points meet no kernel.
//! When most points are extreme it is a sort and a scan; when they lie on a line but for rounding, or products of their
//! coordinates leave the range of numbers (`hullbench points killer`), a scan that asks for exact arithmetic at every point.

mod cascade;
mod chains;
mod ellipse;
mod extremes;
mod few;
mod octagon;
mod order;
mod parallel;
mod polygon;
mod region;
mod sample;
#[cfg(test)]
mod tests;
mod throw_away;

use cascade::Cascade;
use chains::{Candidates, hull_of};
use geometry_core::exact::Unrounded;
use geometry_core::{Boundary, Exact, Hull2, HullError, Kernel2, Observer, Point2, Points, Silent};
pub use parallel::{PARALLEL_DEPARTURES, convex_hull_parallel, fast_2d_parallel};
use polygon::Polygon;
use region::Kept;
use throw_away::{Left, Passes, throw_away};

/// Where this file departs from the papers, and from the rule that an algorithm compares no coordinates.
pub const DEPARTURES: &[&str] = &[
    "points are thrown away by arithmetic with a proved bound on its error, not by asking the kernel: what is dropped is \
     inside for any kernel that is right. Passes over points are reported to the observer (a visit for each point and \
     polygon, a discard for each point dropped); the kernel counts the orientations asked about the rest",
    "the lexicographic order is found from keys, not by asking the kernel",
    "the corners are the extreme points of a sample and of what earlier polygons left, in up to 64 directions",
];

/// The convex hull of `points`.
///
/// # Errors
///
/// None of its own: with a kernel that contradicts itself it gives some polygon of distinct points.
///
/// # Cost
///
/// O(n + m log m) time for m points not thrown away, and about 2 m orientations; 28 m bytes.
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [2.0, 1.0], [2.0, 4.0], [2.0, 0.0]];
/// let hull = |boundary| quickhull::fast_2d(Points::new(&points)?, boundary, &Exact, &mut Silent);
/// assert_eq!(hull(Boundary::Extreme)?.vertices(), [0, 1, 3]);
/// assert_eq!(hull(Boundary::All)?.vertices(), [0, 4, 1, 3]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_2d<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull2, HullError> {
    let mut kept = Kept::default();
    let candidates = candidates::<InOrder, O>(points.as_slice(), &mut kept, observer);
    Ok(hull_of(candidates, boundary, kernel, observer))
}

/// The convex hull of a slice of points that nobody has looked at yet.
///
/// The same as [`fast_2d`] of [`Points::new`], without a pass over the points for the second: a coordinate that is not
/// finite is never thrown away (invariant 2), so only the points left are searched for one.
///
/// # Errors
///
/// Those of [`Points::new`].
///
/// # Cost
///
/// That of [`fast_2d`].
///
/// # Example
///
/// ```
/// use geometry_core::{Boundary, HullError};
///
/// let mut points = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
/// assert_eq!(quickhull::convex_hull(&points, Boundary::Extreme)?.vertices(), [0, 1, 2]);
/// points.push([0.25, f64::NAN]);
/// let error = quickhull::convex_hull(&points, Boundary::Extreme).unwrap_err();
/// assert!(matches!(error, HullError::NotFinite { index: 3, axis: 1, .. }));
/// # Ok::<(), HullError>(())
/// ```
pub fn convex_hull(points: &[Point2], boundary: Boundary) -> Result<Hull2, HullError> {
    hull_of_unseen::<InOrder>(points, boundary)
}

/// The hull of points of which only those that may be vertices are searched for coordinates that are not finite, and for what
/// lattice they are on: on a coarse one, where a filter fails at every zero, nothing is rounded.
fn hull_of_unseen<P: Passes<Silent>>(
    points: &[Point2],
    boundary: Boundary,
) -> Result<Hull2, HullError> {
    if u32::try_from(points.len()).is_err() {
        let count = points.len();
        return Err(HullError::TooManyPoints { count });
    }
    let mut kept = Kept::default();
    let candidates = candidates::<P, Silent>(points, &mut kept, &mut Silent);
    if Points::new(candidates.points).is_err() {
        // Names the first of all points, at leisure.
        Points::new(points)?;
    }
    Ok(match Unrounded::among(candidates.points) {
        Some(kernel) => hull_of(candidates, boundary, &kernel, &mut Silent),
        None => hull_of(candidates, boundary, &Exact, &mut Silent),
    })
}

/// The passes of one thread.
struct InOrder;

impl<O: Observer> Passes<O> for InOrder {
    fn sift(cascade: &Cascade, points: &[Point2], first: u32, kept: &mut Kept, observer: &mut O) {
        cascade.sift(points, first, kept, observer);
    }

    fn thin(kept: &mut Kept, polygon: &Polygon, observer: &mut O) {
        kept.thin_reported(polygon, observer);
    }
}

/// The points that may be vertices, in `kept` unless they are all.
fn candidates<'a, P: Passes<O>, O: Observer>(
    points: &'a [Point2],
    kept: &'a mut Kept,
    observer: &mut O,
) -> Candidates<'a> {
    match throw_away::<P, O>(points, kept, observer) {
        Left::All => Candidates { points, ids: None },
        Left::Kept => Candidates {
            points: kept.points(),
            ids: Some(kept.ids()),
        },
    }
}
