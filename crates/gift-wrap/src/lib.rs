//! Hulls by gift wrapping, after Jarvis: from each vertex to the next along the boundary.
//!
//! | slug | module | seeks the next vertex among | time |
//! |---|---|---|---|
//! | `jarvis-j1` | [`jarvis_j1`](mod@jarvis_j1) | all points | O(n h) |
//! | `jarvis-j2` | [`jarvis_j2`](mod@jarvis_j2) | those beyond the last in angle | O(n h + n log n) |
//! | `jarvis-j3` | [`jarvis_j3`](mod@jarvis_j3) | those further right, then left | O(n h + n log n) |
//!
//! The three differ in that one respect only; the search itself is shared (`src/search.rs`).
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = gift_wrap::jarvis_j1(Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::{Method, planar_task};

pub mod jarvis_j1;
pub mod jarvis_j2;
pub mod jarvis_j3;
mod search;

pub use jarvis_j1::jarvis_j1;
pub use jarvis_j2::jarvis_j2;
pub use jarvis_j3::jarvis_j3;

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method {
        slug: "jarvis-j1",
        title: "Jarvis's march (J1)",
        citation: "R. A. Jarvis, On the identification of the convex hull of a finite set of points in the plane, \
                   Information Processing Letters 2(1), 18-21, 1973; as method J1 in Green and Silverman 1979",
        departures: jarvis_j1::DEPARTURES,
        cost: "O(n h)",
        task: planar_task!(PlanarHull, jarvis_j1::jarvis_j1),
    },
    Method {
        slug: "jarvis-j2",
        title: "Jarvis's march over points sorted by angle (J2)",
        citation: "R. A. Jarvis, On the identification of the convex hull of a finite set of points in the plane, \
                   Information Processing Letters 2(1), 18-21, 1973; as method J2 in Green and Silverman 1979",
        departures: jarvis_j2::DEPARTURES,
        cost: "O(n h + n log n)",
        task: planar_task!(PlanarHull, jarvis_j2::jarvis_j2),
    },
    Method {
        slug: "jarvis-j3",
        title: "Smallest slope to the right and back (J3)",
        citation: "P. J. Green and B. W. Silverman, Constructing the convex hull of a set of points in the plane, \
                   The Computer Journal 22(3), 262-266, 1979, section 5",
        departures: jarvis_j3::DEPARTURES,
        cost: "O(n h + n log n)",
        task: planar_task!(PlanarHull, jarvis_j3::jarvis_j3),
    },
];
