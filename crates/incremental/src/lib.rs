//! Hulls by inserting one point at a time.
//!
//! | slug | module | time |
//! |---|---|---|
//! | `incremental-r` | [`method_r`](mod@method_r) | Σ hᵢ: from O(n h) down, as the hull grows |
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = incremental::method_r(Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::{Method, planar_task};

pub mod method_r;

pub use method_r::method_r;

/// The methods of this family.
pub const METHODS: &[Method] = &[Method {
    slug: "incremental-r",
    title: "Method R: points added one at a time",
    citation: "P. J. Green and B. W. Silverman, Constructing the convex hull of a set of points in the plane, \
               The Computer Journal 22(3), 262-266, 1979, section 5",
    departures: method_r::DEPARTURES,
    cost: "sum of h_i over the points; O(n h)",
    task: planar_task!(PlanarHull, method_r::method_r),
}];
