//! Hulls by merging the hulls of two halves, after Preparata and Hong.
//!
//! | slug | function | time |
//! |---|---|---|
//! | `preparata-hong-2d` | [`preparata_hong_2d`](preparata_hong_2d()) | O(n log n); the merges together O(n) |
//! | `preparata-hong-3d` | [`preparata_hong_3d`](preparata_hong_3d()), as Day implements it | O(n log n) |
//! | `preparata-hong-rescan` | [`preparata_hong_rescan`], each search starting anew | O(n²) |
//! | `preparata-hong-balan` | [`preparata_hong_balan`], each search sorting | O(n² log n) |
//! | `preparata-hong-parallel` | [`preparata_hong_parallel`], on several processors | O(n log n) work |
//!
//! For studies of the merge in space: [`merges`](preparata_hong_3d::merges) tells what happened in each,
//! [`listings`](preparata_hong_3d::listings) lists the facets by Day's spiral and plainly, and
//! [`cotangent`](preparata_hong_3d::cotangent) repeats the merge with Day's rounded angles in any number format.
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let square = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
//! let hull = divide_and_conquer::preparata_hong_2d(
//!     Points::new(&square)?, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 3, 4]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

use geometry_core::method::SpatialHull;
use geometry_core::{Exact, Method, Points, Task, planar_task, spatial_task};

pub mod preparata_hong_2d;
pub mod preparata_hong_3d;

pub use preparata_hong_2d::preparata_hong_2d;
pub use preparata_hong_3d::{
    preparata_hong_3d, preparata_hong_balan, preparata_hong_parallel, preparata_hong_rescan,
};

const PREPARATA_HONG: &str = "F. P. Preparata and S. J. Hong, Convex hulls of finite sets of points in two and three \
                              dimensions, Communications of the ACM 20(2), 87-93, 1977";

const DAY: &str = "A. M. Day, The implementation of an algorithm to find the convex hull of a set of three-dimensional \
                   points, ACM Transactions on Graphics 9(1), 105-132, 1990";

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method {
        slug: "preparata-hong-2d",
        title: "Preparata and Hong's divide and conquer in the plane",
        citation: PREPARATA_HONG,
        departures: preparata_hong_2d::DEPARTURES,
        cost: "O(n log n): the sort; the merges O(n)",
        task: planar_task!(PlanarHull, preparata_hong_2d::preparata_hong_2d),
    },
    Method {
        slug: "preparata-hong-3d",
        title: "Preparata and Hong's divide and conquer in space, Day's wrap",
        citation: DAY,
        departures: preparata_hong_3d::DEPARTURES,
        cost: "O(n log n)",
        task: spatial_task!(preparata_hong_3d::preparata_hong_3d),
    },
    Method {
        slug: "preparata-hong-rescan",
        title: "Preparata and Hong's divide and conquer in space, every search from the start",
        citation: DAY,
        departures: preparata_hong_3d::RESCAN_DEPARTURES,
        cost: "O(n²) worst case",
        task: spatial_task!(preparata_hong_3d::preparata_hong_rescan),
    },
    Method {
        slug: "preparata-hong-balan",
        title: "Preparata and Hong's divide and conquer in space, every search sorting",
        citation: "A. Balan, G. Munjal and T. R. Rao, Implementation of convex hull algorithms in 3D space",
        departures: preparata_hong_3d::BALAN_DEPARTURES,
        cost: "O(n² log n) worst case",
        task: spatial_task!(preparata_hong_3d::preparata_hong_balan),
    },
    Method {
        slug: "preparata-hong-parallel",
        title: "Preparata and Hong's divide and conquer in space, on several processors",
        citation: DAY,
        departures: preparata_hong_3d::PARALLEL_DEPARTURES,
        cost: "O(n log n) work, O(n) of it sequential after the sort",
        task: Task::SpatialHull(SpatialHull {
            unseen: |points| {
                preparata_hong_3d::preparata_hong_parallel(Points::new(points)?, &Exact)
            },
            exact: |points| preparata_hong_3d::preparata_hong_parallel(points, &Exact),
            tallied: |points, kernel, tally| {
                preparata_hong_3d::preparata_hong_3d(points, &kernel, tally)
            },
            recorded: |points, kernel, recorder| {
                preparata_hong_3d::preparata_hong_3d(points, &kernel, recorder)
            },
        }),
    },
];
