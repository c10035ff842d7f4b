//! Green and Silverman's hull and peels, Graham's scan, Andrew's monotone chain.

pub mod chain_peel;
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
];
