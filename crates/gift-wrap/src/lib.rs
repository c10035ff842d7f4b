//! Hulls by gift wrapping: from each vertex to the next along the boundary, from each facet to the next across an edge.
//!
//! In the plane, after Jarvis:
//!
//! | slug | module | seeks the next vertex among | time |
//! |---|---|---|---|
//! | `jarvis-j1` | [`jarvis_j1`](mod@jarvis_j1) | all points | O(n h) |
//! | `jarvis-j2` | [`jarvis_j2`](mod@jarvis_j2) | those beyond the last in angle | O(n h + n log n) |
//! | `jarvis-j3` | [`jarvis_j3`](mod@jarvis_j3) | those further right, then left | O(n h + n log n) |
//!
//! The three differ in that one respect only; the search itself is shared (`src/search.rs`).
//!
//! In space:
//!
//! | slug | module | seeks the next facet | time |
//! |---|---|---|---|
//! | `nathan` | [`nathan`](mod@nathan) | by trying triangles until one fits | O(h n log n) on shuffled points |
//! | `pivot-wrap` | [`pivot_wrap`](mod@pivot_wrap) | by one pass that keeps the best so far | O(n h) |
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = gift_wrap::jarvis_j1(Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::{Method, planar_task, spatial_task};

pub mod jarvis_j1;
pub mod jarvis_j2;
pub mod jarvis_j3;
pub mod nathan;
pub mod pivot_wrap;
mod search;
mod surface;

pub use jarvis_j1::jarvis_j1;
pub use jarvis_j2::jarvis_j2;
pub use jarvis_j3::jarvis_j3;
pub use nathan::nathan;
pub use pivot_wrap::pivot_wrap;

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
    Method {
        slug: "nathan",
        title: "Nathan's gift wrapping",
        citation: "P. Nathan, Obtaining the convex hull from a set of points using the gift wrapping algorithm, 2015",
        departures: nathan::DEPARTURES,
        cost: "O(h n log n) on shuffled points, O(h n^2) at worst",
        task: spatial_task!(nathan::nathan),
    },
    Method {
        slug: "pivot-wrap",
        title: "Gift wrapping by pivoting",
        citation: "D. R. Chand and S. S. Kapur, An algorithm for convex polytopes, Journal of the ACM 17(1), 78-86, 1970",
        departures: pivot_wrap::DEPARTURES,
        cost: "O(n h)",
        task: spatial_task!(pivot_wrap::pivot_wrap),
    },
];
