//! The front door for library users: an exact convex hull by default, or any method by name.
//!
//! ```
//! let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = hullkit::convex_hull_2d(&points)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//!
//! let gs = hullkit::method("gs").expect("a registered slug");
//! println!("{}: {}", gs.title, gs.cost);
//! # Ok::<(), hullkit::HullError>(())
//! ```

pub use geometry_core::{Boundary, Hull2, HullError, Layers, Method, Points, Task};

/// Every registered method, family by family.
pub fn methods() -> impl Iterator<Item = &'static Method> {
    let families: [&'static [Method]; 5] = [
        planar_peeling::METHODS,
        quickhull::METHODS,
        gift_wrap::METHODS,
        incremental::METHODS,
        divide_and_conquer::METHODS,
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
/// That of method `gs`: linear on average for the usual distributions, O(n h) at worst; n indices twice.
pub fn convex_hull_2d(points: &[[f64; 2]]) -> Result<Hull2, HullError> {
    convex_hull_2d_with(points, Boundary::Extreme)
}

/// [`convex_hull_2d`] under a chosen convention of which boundary points are vertices.
///
/// # Errors
///
/// As [`convex_hull_2d`].
pub fn convex_hull_2d_with(points: &[[f64; 2]], boundary: Boundary) -> Result<Hull2, HullError> {
    let points = Points::new(points)?;
    planar_peeling::gs::gs(points, boundary, &geometry_core::Exact, &mut geometry_core::Silent)
}

/// The convex layers of `points`, outermost first.
///
/// # Errors
///
/// As [`convex_hull_2d`].
///
/// # Cost
///
/// One hull a layer: about 0.4 n L for L layers of random points.
pub fn convex_layers(points: &[[f64; 2]], boundary: Boundary) -> Result<Layers, HullError> {
    let points = Points::new(points)?;
    planar_peeling::peel::gs_peel(points, boundary, &geometry_core::Exact, &mut geometry_core::Silent)
}
