//! Quickhull in its historical and modern forms.
//!
//! | slug | module | time |
//! |---|---|---|
//! | `eddy` | [`eddy`](mod@eddy) | O(n h), about linear on the usual distributions |
//! | `fast-2d` | [`fast_2d`](mod@fast_2d) | O(n + m log m) for m points left by the throw-away |
//! | `fast-2d-parallel` | [`fast_2d_parallel`] | the same, the pass over all points on several processors |
//! | `quickhull-balan` | [`balan_quickhull`](mod@balan_quickhull) | O(n m) for m facets made |
//! | `quickhull-3d` | [`quickhull_3d`](mod@quickhull_3d) | O(n²); about linear on the usual distributions, O(n log n) on a sphere |
//! | `fast-3d` | [`fast_3d`](mod@fast_3d) | O(n) on average where few points are extreme |
//! | `fast-3d-parallel` | [`fast_3d_parallel`] | the same, on several processors |
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = quickhull::eddy(Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::method::{PlanarHull, SpatialHull};
use geometry_core::{Exact, Method, Task, planar_task, spatial_task};

pub mod balan_quickhull;
mod blocks;
pub mod eddy;
pub mod fast_2d;
pub mod fast_3d;
mod furthest;
mod horizon;
mod pending;
pub mod quickhull_3d;

pub use balan_quickhull::balan_quickhull;
pub use eddy::eddy;
pub use fast_2d::{convex_hull, convex_hull_parallel, fast_2d, fast_2d_parallel};
pub use fast_3d::{fast_3d, fast_3d_parallel, fast_3d_unseen};
pub use quickhull_3d::quickhull_3d;

const FAST_3D: &str = "C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for convex hulls, ACM Transactions on \
    Mathematical Software 22(4), 469-483, 1996; K. L. Clarkson, P. W. Shor, Applications of random sampling in \
    computational geometry, II, Discrete & Computational Geometry 4, 387-421, 1989";

const THROW_AWAY: &str = "S. G. Akl, G. T. Toussaint, A fast convex hull algorithm, Information Processing Letters 7 \
                          (1978), 219-222; L. Devroye, G. T. Toussaint, A note on linear expected time algorithms for \
                          finding convex hulls, Computing 26 (1981), 361-366; A. M. Andrew, Information Processing \
                          Letters 9 (1979), 216-219";

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method {
        slug: "eddy",
        title: "Eddy's CONVEX (method E, ACM Algorithm 523)",
        citation: "W. F. Eddy, A new convex hull algorithm for planar sets, ACM Transactions on Mathematical Software \
               3(4), 398-403, and Algorithm 523: CONVEX, 411-412, 1977",
        departures: eddy::DEPARTURES,
        cost: "O(n h); about linear on average for the usual distributions",
        task: planar_task!(PlanarHull, eddy::eddy),
    },
    Method {
        slug: "fast-2d",
        title: "Throw-away with certificates, then monotone chains",
        citation: THROW_AWAY,
        departures: fast_2d::DEPARTURES,
        cost: "O(n + m log m) for m points not thrown away: about linear on average where few points are extreme, \
               O(n log n) always",
        task: planar_task!(PlanarHull, fast_2d::fast_2d, fast_2d::convex_hull),
    },
    Method {
        slug: "fast-2d-parallel",
        title: "Throw-away with certificates on several processors, then monotone chains",
        citation: THROW_AWAY,
        departures: fast_2d::PARALLEL_DEPARTURES,
        cost: "that of fast-2d; the pass over all points is shared among the processors",
        task: Task::PlanarHull(PlanarHull {
            unseen: fast_2d::convex_hull_parallel,
            exact: |points, boundary| fast_2d::fast_2d_parallel(points, boundary, &Exact),
            tallied: |points, boundary, kernel, tally| {
                fast_2d::fast_2d(points, boundary, &kernel, tally)
            },
            recorded: |points, boundary, kernel, recorder| {
                fast_2d::fast_2d(points, boundary, &kernel, recorder)
            },
        }),
    },
    Method {
        slug: "quickhull-balan",
        title: "Quickhull as Balan, Munjal and Rao describe it",
        citation: "A. Balan, G. Munjal, T. R. Rao, Implementation of Convex Hull Algorithms in 3D space, section 3.3",
        departures: balan_quickhull::DEPARTURES,
        cost: "O(n m) for m facets made",
        task: spatial_task!(balan_quickhull::balan_quickhull),
    },
    Method {
        slug: "quickhull-3d",
        title: "Quickhull with outside sets",
        citation: "C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for convex hulls, ACM \
                   Transactions on Mathematical Software 22(4), 469-483, 1996",
        departures: quickhull_3d::DEPARTURES,
        cost: "O(n^2); about linear on average where few points are extreme, O(n log n) on a sphere",
        task: spatial_task!(quickhull_3d::quickhull_3d),
    },
    Method {
        slug: "fast-3d",
        title: "Quickhull after discarding what is inside the hull of a sample",
        citation: FAST_3D,
        departures: fast_3d::DEPARTURES,
        cost: "O(n) on average where few points are extreme, O(n log n) on a sphere, O(n^2) at worst",
        task: spatial_task!(fast_3d::fast_3d, |points| fast_3d_unseen(points, &Exact)),
    },
    Method {
        slug: "fast-3d-parallel",
        title: "Quickhull after discarding what is inside the hull of a sample, on several processors",
        citation: FAST_3D,
        departures: fast_3d::PARALLEL_DEPARTURES,
        cost: "that of fast-3d; discards and the hulls of halves are shared among the processors",
        task: Task::SpatialHull(SpatialHull {
            unseen: |points| fast_3d_parallel(points, &Exact),
            exact: |points| fast_3d_parallel(points.as_slice(), &Exact),
            tallied: |points, kernel, tally| fast_3d(points, &kernel, tally),
            recorded: |points, kernel, recorder| fast_3d(points, &kernel, recorder),
        }),
    },
];
