//! The front door for library users: an exact convex hull by default, or any method by name.
//!
//! ```
//! let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = hullkit::convex_hull_2d(&points)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//!
//! let same = hullkit::Builder::new().method("gs")?.convex_hull_2d(&points)?;
//! assert_eq!(same, hull);
//!
//! let grid: Vec<[f64; 3]> = (0..27).map(|i| [i % 3, i / 3 % 3, i / 9].map(f64::from)).collect();
//! let hull = hullkit::convex_hull_3d(&grid)?;
//! assert_eq!(hull.vertices(), [0, 2, 6, 8, 18, 20, 24, 26]);
//!
//! let triangulation = hullkit::delaunay(&points)?;
//! assert_eq!(triangulation.len(), 4);
//! # Ok::<(), hullkit::BuildError>(())
//! ```

mod builder;
mod delaunay;
mod space;
pub mod sweep;

pub use builder::{BuildError, Builder, Processors};
pub use delaunay::{delaunay, delaunay_by};
pub use geometry_core::hull3::Location;
pub use geometry_core::{
    Boundary, Hull2, Hull3, HullError, Layers, Method, Points, Task, Triangulation,
};
pub use lifted_delaunay::{Voronoi, VoronoiEdge};

use geometry_core::{Exact, Silent};

/// Every registered method, family by family.
pub fn methods() -> impl Iterator<Item = &'static Method> {
    let families: [&'static [Method]; 8] = [
        planar_peeling::METHODS,
        quickhull::METHODS,
        gift_wrap::METHODS,
        incremental::METHODS,
        divide_and_conquer::METHODS,
        lifted_delaunay::METHODS,
        delaunay::METHODS,
        space::METHODS,
    ];
    families.into_iter().flatten()
}

/// The method registered as `slug`.
pub fn method(slug: &str) -> Option<&'static Method> {
    methods().find(|method| method.slug == slug)
}

/// The convex hull of `points`: indices of the extreme points, anticlockwise.
///
/// Exact for every finite input. Repeated, collinear and no points at all are ordinary input.
///
/// # Errors
///
/// [`HullError::NotFinite`] names the index and axis of a coordinate that is NaN or infinite.
///
/// # Cost
///
/// That of method `fast-2d`: linear on average for the usual distributions, O(n log n) at worst; 28 bytes for each point
/// that is not obviously inside.
pub fn convex_hull_2d(points: &[[f64; 2]]) -> Result<Hull2, HullError> {
    convex_hull_2d_with(points, Boundary::Extreme)
}

/// [`convex_hull_2d`] under a chosen convention of which boundary points are vertices.
///
/// # Errors
///
/// As [`convex_hull_2d`].
pub fn convex_hull_2d_with(points: &[[f64; 2]], boundary: Boundary) -> Result<Hull2, HullError> {
    quickhull::convex_hull(points, boundary)
}

/// [`convex_hull_2d_with`] on several processors, as many as the current rayon thread pool has. The same result.
///
/// # Errors
///
/// As [`convex_hull_2d`].
///
/// # Cost
///
/// The work of [`convex_hull_2d`], most of it shared if few points are extreme. Below some 10⁵ points there is nothing
/// to gain.
///
/// ```
/// use hullkit::Boundary;
/// let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
/// let hull = hullkit::convex_hull_2d_parallel(&points, Boundary::Extreme)?;
/// assert_eq!(hull, hullkit::convex_hull_2d(&points)?);
/// # Ok::<(), hullkit::HullError>(())
/// ```
pub fn convex_hull_2d_parallel(
    points: &[[f64; 2]],
    boundary: Boundary,
) -> Result<Hull2, HullError> {
    quickhull::convex_hull_parallel(points, boundary)
}

/// The convex layers of `points`, outermost first.
///
/// # Errors
///
/// As [`convex_hull_2d`].
///
/// # Cost
///
/// That of method `fast-layers`: O(n log n), whatever the points.
pub fn convex_layers(points: &[[f64; 2]], boundary: Boundary) -> Result<Layers, HullError> {
    let points = Points::new(points)?;
    planar_peeling::fast_layers::fast_layers(points, boundary, &Exact, &mut Silent)
}

/// The convex hull of `points` of space: its true facets, each anticlockwise seen from outside.
///
/// Exact for every finite input. Repeated, collinear, coplanar and no points at all are ordinary input.
///
/// # Errors
///
/// As [`convex_hull_2d`].
///
/// # Cost
///
/// That of method `hull-3d`: linear on average where few points are extreme, O(n log n) expected where all are.
///
/// ```
/// let cube: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
/// let hull = hullkit::convex_hull_3d(&cube)?;
/// assert_eq!((hull.len(), hull.facets().count(), hull.triangles().count()), (8, 6, 12));
/// # Ok::<(), hullkit::HullError>(())
/// ```
pub fn convex_hull_3d(points: &[[f64; 3]]) -> Result<Hull3, HullError> {
    space::hull_3d_unseen(points, &Exact)
}
