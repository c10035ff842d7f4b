//! Green and Silverman's hull and peels, Graham's scan, Andrew's monotone chain.
//!
//! | slug | module | time | use it |
//! |---|---|---|---|
//! | `gs` | [`gs`](gs::gs) | O(n h), linear on average for the usual distributions | by default: most points are not extreme |
//! | `gs-bare` | [`gs`](gs::gs_bare) | as `gs` | to time what the bookkeeping for peels costs |
//! | `monotone-chain` | [`monotone_chain`] | O(n log n) | when most points are extreme, or an adversary chose them |
//! | `graham` | [`graham`] | O(n log n) | to compare with the first O(n log n) method |
//! | `gs-peel` | [`peel`] | O(n L) on average for L layers | for the first layers, or a few hundred points |
//! | `chain-peel` | [`chain_peel`] | O(n log n + n L) | as an independent check of the others |
//! | `fast-layers` | [`fast_layers`](mod@fast_layers) | O(n log n) | by default for layers |
//!
//! The hull methods give a [`Hull2`](geometry_core::Hull2), the layers methods [`Layers`](geometry_core::Layers),
//! whose [`c_ranks`](geometry_core::Layers::c_ranks) are the stages at which points leave.
//!
//! ```
//! use geometry_core::{Boundary, Exact, Points, Silent};
//! let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 2.0], [3.0, 2.0], [2.0, 3.0]];
//! let points = Points::new(&points)?;
//! let hull = planar_peeling::gs::gs(points, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(hull.vertices(), [0, 1, 2, 3]);
//! let layers = planar_peeling::peel::gs_peel(points, Boundary::Extreme, &Exact, &mut Silent)?;
//! assert_eq!(layers.c_ranks(), [1, 1, 1, 1, 2, 2, 2]);
//! # Ok::<(), geometry_core::HullError>(())
//! ```

pub mod chain_peel;
pub mod fast_layers;
pub mod graham;
pub mod gs;
pub mod monotone_chain;
pub mod peel;

use geometry_core::{Method, planar_task};

/// The methods of this family.
pub const METHODS: &[Method] = &[
    Method {
        slug: "gs",
        title: "Green and Silverman's method GS",
        citation: "P. J. Green and B. W. Silverman, Constructing the convex hull of a set of points in the plane, The Computer Journal 22 (1979) 262-266",
        departures: &[
            "the kernel decides which points are doubtful, in place of a tolerance",
            "a point on the base line waits until it is known which side of the line is empty",
            "extremes are lexicographic, and ties for the furthest point are broken along the line",
            "confirmed edges are kept apart from the other labels, within the promised stack",
            "points outside the second line of a split wait in the free cells of LIST until all are read",
            "at most 2^31 - 1 points",
        ],
        cost: "O(n h) at worst; O(n) on average for the usual distributions",
        task: planar_task!(PlanarHull, gs::gs),
    },
    Method {
        slug: "gs-bare",
        title: "Method GS without the bookkeeping that peeling needs",
        citation: "P. J. Green and B. W. Silverman, Constructing the convex hull of a set of points in the plane, The Computer Journal 22 (1979) 262-266",
        departures: &[
            "those of gs",
            "interior points are dropped instead of written back, so there is no next peel",
        ],
        cost: "O(n h) at worst; O(n) on average for the usual distributions",
        task: planar_task!(PlanarHull, gs::gs_bare),
    },
    Method {
        slug: "gs-peel",
        title: "Green and Silverman's peels: one call of method GS a layer",
        citation: "P. J. Green and B. W. Silverman, Constructing the convex hull of a set of points in the plane, The Computer Journal 22 (1979) 262-266",
        departures: &["those of gs", "copies of a vertex leave together with it"],
        cost: "O(n L) on average for L layers; O(n^2) at worst",
        task: planar_task!(PlanarLayers, peel::gs_peel),
    },
    Method {
        slug: "graham",
        title: "Graham's scan",
        citation: "R. L. Graham, An efficient algorithm for determining the convex hull of a finite planar set, Information Processing Letters 1 (1972) 132-133",
        departures: &[
            "the interior point is a rounded centroid, verified strictly inside; where no double is, the lexicographically smallest point serves as the pole",
            "the walk starts at the lexicographically smallest point",
        ],
        cost: "O(n log n)",
        task: planar_task!(PlanarHull, graham::graham),
    },
    Method {
        slug: "monotone-chain",
        title: "Andrew's monotone chain",
        citation: "A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Information Processing Letters 9 (1979) 216-219",
        departures: &[
            "all points are scanned twice, instead of being split by the line through the extreme points",
        ],
        cost: "O(n log n)",
        task: planar_task!(PlanarHull, monotone_chain::monotone_chain),
    },
    Method {
        slug: "chain-peel",
        title: "Peels by the monotone chain: one sort, two chains a layer",
        citation: "A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Information Processing Letters 9 (1979) 216-219, applied to what is left until nothing is",
        departures: &[
            "those of monotone-chain",
            "the points are sorted once for all layers",
        ],
        cost: "O(n log n + n L) for L layers; O(n^2) at worst",
        task: planar_task!(PlanarLayers, chain_peel::chain_peel),
    },
    Method {
        slug: "fast-layers",
        title: "Convex layers from two trees of hulls that only shrink",
        citation: "M. H. Overmars and J. van Leeuwen, Maintenance of configurations in the plane, J. Comput. System Sci. 23 (1981) 166-204; B. Chazelle, On the convex layers of a planar set, IEEE Trans. Inform. Theory 31 (1985) 509-517; J. Hershberger and S. Suri, Applications of a semi-dynamic convex hull algorithm, BIT 32 (1992) 249-267",
        departures: &[
            "hulls are linked lists in the nodes of a static tree, a point in that of the highest node whose hull it is on",
            "leaves hold blocks of points",
            "a layer leaves in one pass over the tree of its half, and point by point from the other",
            "points are put in order by their coordinates; the kernel is not asked",
        ],
        cost: "O(n log n)",
        task: planar_task!(PlanarLayers, fast_layers::fast_layers),
    },
];
