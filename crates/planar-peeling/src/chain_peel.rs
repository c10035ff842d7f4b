//! Peeling by Andrew's monotone chain.
//!
//! A. M. Andrew, *Another efficient algorithm for convex hulls in two dimensions*, Information Processing
//! Letters 9 (1979), 216-219, applied again and again to what is left. The number of the round that takes a point
//! is its c-rank: V. Barnett, *The ordering of multivariate data*, J. Roy. Statist. Soc. A 139 (1976), 318-354.
//!
//! 1. Sort the points by x, then y, once.
//! 2. Build both chains of the points left; they are the next layer.
//! 3. Take the layer's points out, which keeps the others sorted, and go on until none is left.
//!
//! # Bound
//!
//! O(n log n) comparisons once, then fewer than 4 orientations per layer for each point left: O(n L) for L
//! layers, O(n²) at worst, with small constants and sequential access. 3n indices.
//!
//! # Invariants
//!
//! 1. The points left are distinct and in lexicographic order.
//! 2. A point has a stage exactly if it has been taken out. Copies get theirs at the end.
//!
//! # When not to use it
//!
//! When there are many layers and many points: each layer walks over all points left. It is here as a second,
//! independent method for layers.

use crate::monotone_chain::hull_of_sorted;
use geometry_core::hull2::sort_distinct;
use geometry_core::{Boundary, HullError, Kernel2, Layers, Observer, Points, Step};

/// The convex layers of `points` by one sort and a pair of monotone chains a layer.
///
/// Returns the layers, outermost first, as ids of `points`; `boundary` says whether points inside an edge belong
/// to a layer.
///
/// # Errors
///
/// None.
///
/// # Cost
///
/// O(n log n + n L) for L layers, O(n²) at worst; 3n indices.
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::chain_peel::chain_peel;
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0], [0.0, 0.0]];
/// let layers = chain_peel(Points::new(&points)?, Boundary::All, &Exact, &mut Silent)?;
/// assert_eq!(layers.c_ranks(), [1, 1, 1, 2, 1]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn chain_peel<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Layers, HullError> {
    let mut left: Vec<u32> = points.ids().collect();
    sort_distinct(points, &mut left, kernel);
    let distinct = left.clone();
    let mut stages = vec![0; points.len()];
    let mut rings = Vec::new();
    while !left.is_empty() {
        let ring = hull_of_sorted(points, &left, boundary, kernel, observer);
        let stage = rings.len() as u32 + 1;
        for &id in ring.vertices() {
            stages[id as usize] = stage;
        }
        left.retain(|&id| stages[id as usize] == 0);
        rings.push(ring);
        observer.step(|| Step::Layer(stage));
    }
    give_copies_their_stages(points, &distinct, &mut stages, kernel);
    Ok(Layers::new(rings, stages))
}

/// Gives each point without a stage, which is a copy, the stage of its equal among `distinct`.
fn give_copies_their_stages<K: Kernel2>(
    points: Points<'_, 2>,
    distinct: &[u32],
    stages: &mut [u32],
    kernel: &K,
) {
    for id in points.ids() {
        if stages[id as usize] > 0 {
            continue;
        }
        let equal =
            distinct.binary_search_by(|&other| kernel.lexicographic(points[other], points[id]));
        if let Ok(place) = equal {
            stages[id as usize] = stages[distinct[place] as usize];
        }
    }
}
