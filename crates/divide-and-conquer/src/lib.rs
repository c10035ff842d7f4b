//! Hulls by merging the hulls of two halves, after Preparata and Hong.
//!
//! | slug | module | time |
//! |---|---|---|
//! | `preparata-hong-2d` | [`preparata_hong_2d`](mod@preparata_hong_2d) | O(n log n); the merges together O(n) |
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = divide_and_conquer::preparata_hong_2d(
//!     Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::{Method, planar_task};

pub mod preparata_hong_2d;

pub use preparata_hong_2d::preparata_hong_2d;

/// The methods of this family.
pub const METHODS: &[Method] = &[Method {
    slug: "preparata-hong-2d",
    title: "Preparata and Hong's divide and conquer in the plane",
    citation: "F. P. Preparata and S. J. Hong, Convex hulls of finite sets of points in two and three dimensions, \
               Communications of the ACM 20(2), 87-93, 1977",
    departures: preparata_hong_2d::DEPARTURES,
    cost: "O(n log n): the sort; the merges O(n)",
    task: planar_task!(PlanarHull, preparata_hong_2d::preparata_hong_2d),
}];
