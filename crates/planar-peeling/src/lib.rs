//! Green and Silverman's hull and peels, Graham's scan, Andrew's monotone chain.

pub mod gs;
pub mod monotone_chain;
pub mod peel;
mod sort;

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
        slug: "monotone-chain",
        title: "Andrew's monotone chain",
        citation: "A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, Information Processing Letters 9 (1979) 216-219",
        departures: &[
            "all points are scanned twice, instead of being split by the line through the extreme points",
        ],
        cost: "O(n log n)",
        task: planar_task!(PlanarHull, monotone_chain::monotone_chain),
    },
];
