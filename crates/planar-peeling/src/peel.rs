//! Peeling with successive calls of method GS.
//!
//! P. J. Green and B. W. Silverman, *Constructing the convex hull of a set of points in the plane*, The Computer
//! Journal 22 (1979), 262-266, sections 1 and 4.
//!
//! 1. One call of the routine finds the hull of the points in the tail of LIST, writes its vertices to the front
//!    and the points inside back to the tail.
//! 2. Repeat until the tail is empty. The number of the call that takes a point is its c-rank (Barnett 1976).
//!
//! # Bound
//!
//! One hull a layer: Θ(n L) point visits for L layers of points spread as in a disc, where L ≈ 0.463 n^(2/3) and the
//! visits add up to (2/5) n L. O(n²) at worst. Storage: two arrays of n indices and m labels, with m at most the number
//! of peels plus the points on the largest.
//!
//! # Invariants
//!
//! 1. Between calls LIST holds the peels found, outermost first, then free cells (as many as copies have left), then
//!    the points not yet peeled.
//! 2. A point has a stage exactly if it has left LIST's tail.
//! 3. Every call takes at least one point, so there are at most n calls.
//!
//! # Departures
//!
//! Those of [`gs`](crate::gs), and: copies of a vertex leave together with it, so that a layer depends on the set of
//! points alone. The paper does not speak of copies. They are noticed when an orientation is zero and cost no
//! other question then.
//!
//! # When not to use it
//!
//! When there are many layers and many points: the work per layer is that of a hull of everything left.

use crate::gs::{Peeling, arrays_for, hull_of_peel, next_peel};
use geometry_core::{Boundary, HullError, Kernel2, Layers, Observer, Points, Step};

/// The convex layers of `points` by successive calls of method GS.
///
/// Returns the layers, outermost first, as ids of `points`; [`Layers::c_ranks`] are the stages at which points leave.
/// `boundary` says whether points inside an edge belong to a layer, as they do in the paper.
///
/// # Errors
///
/// [`HullError::TooManyPoints`] from 2³¹ points on.
///
/// # Cost
///
/// O(n L) orientations on average for L layers, O(n²) at worst; 2n indices, n stages and m labels.
///
/// ```
/// use geometry_core::{Boundary, Exact, Points, Silent};
/// use planar_peeling::peel::gs_peel;
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0], [0.0, 0.0]];
/// let layers = gs_peel(Points::new(&points)?, Boundary::All, &Exact, &mut Silent)?;
/// assert_eq!(layers.len(), 2);
/// assert_eq!(layers.c_ranks(), [1, 1, 1, 2, 1]);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn gs_peel<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    kernel: &K,
    observer: &mut O,
) -> Result<Layers, HullError> {
    let mut arrays = arrays_for(points)?;
    let mut stages = vec![0; points.len()];
    let mut stage = 0;
    while arrays.left() > 0 {
        stage += 1;
        let mut bookkeeping = Peeling {
            stage,
            stages: &mut stages,
        };
        let label = next_peel(
            points,
            boundary,
            kernel,
            observer,
            &mut bookkeeping,
            &mut arrays,
        );
        for &id in arrays.peel(label) {
            stages[id as usize] = stage;
        }
        observer.step(|| Step::Layer(stage));
    }
    let rings = arrays
        .peels
        .iter()
        .map(|&label| hull_of_peel(points, &arrays, label));
    Ok(Layers::new(rings.collect(), stages))
}
