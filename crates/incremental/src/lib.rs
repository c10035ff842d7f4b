//! Hulls by inserting one point at a time.
//!
//! | slug | module | time |
//! |---|---|---|
//! | `incremental-r` | [`method_r`](mod@method_r) | Σ hᵢ: from O(n h) down, as the hull grows |
//! | `incremental-3d` | [`incremental_3d`](mod@incremental_3d) | Σ Fᵢ: (n-1)(n-4) tests if all points are extreme |
//! | `incremental-conflict` | [`incremental_conflict`](mod@incremental_conflict) | expected O(n log n) |
//! | `incremental-brio` | [`incremental_brio`](mod@incremental_brio) | expected O(n log n) along a surface; the fastest if nearly all points are extreme |
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = incremental::method_r(Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::{Method, planar_task, spatial_task};

pub mod incremental_3d;
pub mod incremental_brio;
pub mod incremental_conflict;
pub mod method_r;
mod order;
mod surface;

pub use incremental_3d::{incremental_3d, incremental_3d_in, incremental_3d_seeded};
pub use incremental_brio::incremental_brio;
pub use incremental_conflict::{
    incremental_conflict, incremental_conflict_in, incremental_conflict_seeded,
};
pub use method_r::method_r;
pub use order::{DEFAULT_SEED, Order};

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method {
        slug: "incremental-r",
        title: "Method R: points added one at a time",
        citation: "P. J. Green and B. W. Silverman, Constructing the convex hull of a set of points in the plane, \
               The Computer Journal 22(3), 262-266, 1979, section 5",
        departures: method_r::DEPARTURES,
        cost: "sum of h_i over the points; O(n h)",
        task: planar_task!(PlanarHull, method_r::method_r),
    },
    Method {
        slug: "incremental-3d",
        title: "Insertion in random order, every facet tested",
        citation: "A. Balan, G. Munjal, T. R. Rao, Implementation of Convex Hull Algorithms in 3D space, section 3.2",
        departures: incremental_3d::DEPARTURES,
        cost: "sum of F_i over the points; (n-1)(n-4) tests if all are extreme",
        task: spatial_task!(incremental_3d::incremental_3d),
    },
    Method {
        slug: "incremental-conflict",
        title: "Insertion in random order with a conflict graph",
        citation: "K. L. Clarkson, P. W. Shor, Applications of random sampling in computational geometry II, Discrete & \
                   Computational Geometry 4, 387-421, 1989; M. de Berg, O. Cheong, M. van Kreveld, M. Overmars, \
                   Computational Geometry, third edition, Springer 2008, chapter 11",
        departures: incremental_conflict::DEPARTURES,
        cost: "O(n log n) expected",
        task: spatial_task!(incremental_conflict::incremental_conflict),
    },
    Method {
        slug: "incremental-brio",
        title: "Insertion in a biased random order along Hilbert's curve, found by walking",
        citation: "N. Amenta, S. Choi, G. Rote, Incremental constructions con BRIO, Proceedings of the 19th Annual \
                   Symposium on Computational Geometry, 211-219, 2003",
        departures: incremental_brio::DEPARTURES,
        cost: "O(n log n) expected for points along a surface",
        task: spatial_task!(incremental_brio::incremental_brio),
    },
];
