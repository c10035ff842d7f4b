//! The fastest exact hull in space where few points are extreme.
//!
//! **Idea.** Nearly all points lie deep inside, and finding that out must cost next to nothing. The hull of a sample
//! is known soon, and what is certainly inside that one is not extreme. After B. Barber, D. Dobkin, H. Huhdanpaa, "The
//! Quickhull algorithm for convex hulls", *ACM TOMS* 22(4), 1996; the hull of a sample as a filter is that of
//! K. L. Clarkson, P. W. Shor, "Applications of random sampling in computational geometry, II", *Discrete &
//! Computational Geometry* 4, 1989.
//!
//! **Essence.**
//!
//! 1. Find the hull of a sample, in the same way.
//! 2. From a centre in it, map directions to how far that hull certainly reaches (`directions`). One look-up and one product
//!    discard a point.
//! 3. Do the same to the points left, while that discards many: they lie near the surface, and so does a sample of them.
//! 4. Run quickhull on the points left, with a rounded height and a proved bound for each facet (`plane`), all facets of
//!    a new cone side by side (`fan`), and points in the plane of a facet counted as inside (`surface`).
//! 5. Merge coplanar triangles, exactly, and drop corners that are not extreme.
//!
//! **Bound.** Of n points, a share of h(m)/m lies outside the hull of a sample of m, where h(m) is the number of extreme
//! points of such a sample (Efron 1965). The map is O(n) with a constant that does not depend on the hull. Where h(m) grows
//! slower than m, all is O(n) on average. Space: the points left and a link for each, and 130 bytes a facet.
//!
//! **Exactness.** A rounded answer is used only where it is proved right. All others come from the kernel, which is also
//! asked about the first tetrahedron and when facets are merged.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** Where all points are extreme (a sphere, a paraboloid, a curve) nothing is discarded, and quickhull
//! asks O(log n) questions a point about facets all over memory: use `incremental`'s engine for such points. The map looks from
//! one centre, so it is blunt for a set a million times longer than wide, and not used for one 2²⁸ times as far from
//! the origin as wide; the answer is right all the same.

mod apex;
mod below;
mod core;
mod deal;
mod directions;
mod discard;
mod fan;
mod halves;
mod left;
mod lists;
mod parallel;
mod plane;
mod renumbered;
mod seam;
mod simplex;
mod surface;

use crate::quickhull_3d;
use directions::DirectionMap;
use discard::discard;
use geometry_core::{Basis, Hull3, HullError, Kernel3, Observer, Point3, Points, Silent};
use left::Left;
pub use parallel::{PARALLEL_DEPARTURES, fast_3d_parallel};
use renumbered::Renumbered;
use surface::{Surface, surface};

/// Where this method departs from the published one, and why.
pub const DEPARTURES: &[&str] = &[
    "under a kernel whose answers are not about the coordinates themselves, such as that of lifted points, it is \
     quickhull-3d",
    "answers that rounded arithmetic is proved to give right are not asked of the kernel, so a kernel is only asked the \
     others; Step::Visit tells each test of a point against a plane or the map",
    "points inside the hull of a sample are discarded first",
    "the furthest point is chosen by a rounded height: any point outside will do",
    "a point in the plane of a facet counts as inside it; exactly coplanar facets are merged at the end",
];

/// The convex hull of points of which few are extreme.
///
/// # Errors
///
/// [`HullError::Contradiction`] only with a kernel that is not exact.
///
/// # Cost
///
/// O(n) on average where few points are extreme, O(n log n) on a sphere, O(n²) at worst. Space: O(n) at worst, as many as
/// are left after the discards on average.
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
///
/// let lattice: Vec<[f64; 3]> = (0..1000).map(|i| [i % 10, i / 10 % 10, i / 100].map(f64::from)).collect();
/// let hull = quickhull::fast_3d(Points::new(&lattice)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 9, 90, 99, 900, 909, 990, 999]);
/// assert_eq!(hull.facets().count(), 6);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn fast_3d<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    // What is discarded is discarded for its coordinates, which must be what the kernel answers about.
    if kernel.basis() == Basis::Other || points.len() > lists::MOST {
        return quickhull_3d(points, kernel, observer);
    }
    match map_of_sample(points.as_slice(), kernel, observer)? {
        Some(map) => {
            let left = discard(points.as_slice(), 0, &map, observer);
            hull_of_left(left, kernel, observer)
        }
        None => hull_of_all(points, kernel, observer),
    }
}

/// [`fast_3d`] of points that nobody has looked at yet.
///
/// The same as of [`Points::new`], without a pass over the points for that: a coordinate that is not finite is never found
/// inside, so only the points left are searched for one.
///
/// # Errors
///
/// As [`Points::new`] and [`fast_3d`].
///
/// ```
/// use geometry_core::{Exact, HullError};
///
/// let mut lattice: Vec<[f64; 3]> = (0..8000).map(|i| [i % 20, i / 20 % 20, i / 400].map(f64::from)).collect();
/// let hull = quickhull::fast_3d_unseen(&lattice, &Exact)?;
/// assert_eq!(hull.vertices(), [0, 19, 380, 399, 7600, 7619, 7980, 7999]);
/// lattice[4000][2] = f64::NAN;
/// let error = quickhull::fast_3d_unseen(&lattice, &Exact).unwrap_err();
/// assert!(matches!(error, HullError::NotFinite { index: 4000, axis: 2, .. }));
/// # Ok::<(), HullError>(())
/// ```
pub fn fast_3d_unseen<K: Kernel3>(points: &[Point3], kernel: &K) -> Result<Hull3, HullError> {
    unseen(points, kernel, || {
        let Some(map) = map_of_sample(points, kernel, &mut Silent)? else {
            return Ok(None);
        };
        let left = discard(points, 0, &map, &mut Silent);
        hull_of_left(left, kernel, &mut Silent).map(Some)
    })
}

/// The hull that `discarding` finds, or else that of all points.
fn unseen<K: Kernel3>(
    points: &[Point3],
    kernel: &K,
    discarding: impl FnOnce() -> Result<Option<Hull3>, HullError>,
) -> Result<Hull3, HullError> {
    if kernel.basis() == Basis::Other || points.len() > lists::MOST {
        return quickhull_3d(Points::new(points)?, kernel, &mut Silent);
    }
    let hull = match discarding() {
        Ok(Some(hull)) => Ok(hull),
        Ok(None) => hull_of_all(Points::new(points)?, kernel, &mut Silent),
        Err(error) => Err(error),
    };
    // What is wrong with some of the points is wrong with all; the error is to name the first.
    hull.map_err(|error| Points::new(points).err().unwrap_or(error))
}

/// Steps 4 and 5 for all points.
fn hull_of_all<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let mut observer = Renumbered {
        observer,
        ids: None,
    };
    Ok(surface(points, kernel, &mut observer)?.hull(points, kernel))
}

/// Steps 3 to 5 for the points left, which it narrows down first.
fn hull_of_left<K: Kernel3, O: Observer>(
    left: Left,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let left = narrowed(left, kernel, observer)?;
    let points = Points::new(&left.points)?;
    let mut observer = Renumbered {
        observer,
        ids: Some(&left.ids),
    };
    let hull = surface(points, kernel, &mut observer)?.hull(points, kernel);
    Ok(hull.renumbered(&left.ids))
}

/// Step 3.
///
/// What is left lies close to the surface, so that a sample of it is worth a far larger one of all points.
fn narrowed<K: Kernel3, O: Observer>(
    mut left: Left,
    kernel: &K,
    observer: &mut O,
) -> Result<Left, HullError> {
    let mut before = usize::MAX;
    while left.points.len() >= MANY && left.points.len() <= before - before / 4 {
        before = left.points.len();
        let sample = left.sample(before / 8);
        let Some(map) = map_of(sample, before, kernel, observer)? else {
            break;
        };
        left = thinned(&left, &map, observer);
    }
    Ok(left)
}

/// Those of some points that the map does not find inside.
fn thinned<O: Observer>(left: &Left, map: &DirectionMap, observer: &mut O) -> Left {
    let mut observer = Renumbered {
        observer,
        ids: Some(&left.ids),
    };
    left.those_of(discard(&left.points, 0, map, &mut observer))
}

/// With fewer points than this, a sample does not pay.
const FEW: usize = 4096;

/// With fewer points left than this, a sample of them does not pay.
const MANY: usize = 1 << 16;

/// Steps 1 and 2 for all points: no map if they are few, or if nothing would be discarded.
fn map_of_sample<K: Kernel3, O: Observer>(
    points: &[Point3],
    kernel: &K,
    observer: &mut O,
) -> Result<Option<DirectionMap>, HullError> {
    if points.len() < FEW {
        return Ok(None);
    }
    let sample = Left::sample_of(points, sample_size(points.len()));
    map_of(sample, points.len(), kernel, observer)
}

/// The map of the hull of a sample, to be asked about `count` points.
fn map_of<K: Kernel3, O: Observer>(
    sample: Left,
    count: usize,
    kernel: &K,
    observer: &mut O,
) -> Result<Option<DirectionMap>, HullError> {
    let mut left = None;
    if sample.points.len() >= FEW {
        let size = sample_size(sample.points.len());
        let map = map_of(sample.sample(size), sample.points.len(), kernel, observer)?;
        left = map.map(|map| thinned(&sample, &map, observer));
    }
    let left = left.as_ref().unwrap_or(&sample);
    map_of_left(&sample, left, count, kernel, observer)
}

/// [`map_of`] a sample of which the points that may be extreme are `left`.
fn map_of_left<K: Kernel3, O: Observer>(
    sample: &Left,
    left: &Left,
    count: usize,
    kernel: &K,
    observer: &mut O,
) -> Result<Option<DirectionMap>, HullError> {
    let points_left = Points::new(&left.points)?;
    let mut observer = Renumbered {
        observer,
        ids: Some(&left.ids),
    };
    let Surface::Solid(mesh, _) = surface(points_left, kernel, &mut observer)? else {
        return Ok(None);
    };
    // About two triangles a corner.
    if mesh.len() > sample.points.len() {
        return Ok(None);
    }
    Ok(DirectionMap::of(points_left, &mesh, count, &sample.points))
}

/// The size of the sample of n points.
///
/// A sample of m costs time like m, and about n / √m points of a ball lie outside its hull, so the least of both is at m
/// like n to ⅔. The factor is measured; twice or half as many cost a tenth more.
fn sample_size(n: usize) -> usize {
    (2.0 * (n as f64).powf(2.0 / 3.0)) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::Exact;

    #[test]
    fn narrowing_keeps_what_is_extreme() -> Result<(), HullError> {
        let n = 200_000;
        let spec: point_sets::Spec = "ball".parse().expect("a set");
        let ball = spec.generate3(n as usize, 1).expect("points");
        let all = Left {
            ids: (0..n).step_by(2).collect(),
            points: ball.iter().step_by(2).copied().collect(),
        };
        let expected = hull_of_all(Points::new(&all.points)?, &Exact, &mut Silent)?;
        let expected = expected.renumbered(&all.ids);
        let narrowed = narrowed(all, &Exact, &mut Silent)?;
        assert!(narrowed.points.len() < n as usize / 4);
        let at = |id: &u32| ball[*id as usize];
        assert!(
            narrowed
                .ids
                .iter()
                .map(at)
                .eq(narrowed.points.iter().copied())
        );
        assert_eq!(hull_of_left(narrowed, &Exact, &mut Silent)?, expected);
        Ok(())
    }
}
