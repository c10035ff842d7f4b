//! Quickhull in its historical and modern forms.
//!
//! | slug | module | time |
//! |---|---|---|
//! | `eddy` | [`eddy`](mod@eddy) | O(n h), about linear on the usual distributions |
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = quickhull::eddy(Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::{Method, planar_task};

pub mod eddy;

pub use eddy::eddy;

/// The methods of this family.
pub const METHODS: &[Method] = &[Method {
    slug: "eddy",
    title: "Eddy's CONVEX (method E, ACM Algorithm 523)",
    citation: "W. F. Eddy, A new convex hull algorithm for planar sets, ACM Transactions on Mathematical Software \
               3(4), 398-403, and Algorithm 523: CONVEX, 411-412, 1977",
    departures: eddy::DEPARTURES,
    cost: "O(n h); about linear on average for the usual distributions",
    task: planar_task!(PlanarHull, eddy::eddy),
}];
