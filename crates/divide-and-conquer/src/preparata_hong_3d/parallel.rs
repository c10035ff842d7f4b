//! The halves conquered side by side, on as many processors as there are.
//!
//! A range of more than [`GRAIN`] points is halved, and each half has its own arena, on its own thread; before their
//! merge, the arena of the first takes in that of the second, which costs a copy of its records on each of the few upper
//! levels. The halves are those of the sequential method, so the merges and the questions are the same ones.

use super::questions::{Oriented, Questions};
use super::surface::{Fault, Surface};
use super::{Resumed, hull_of_order};
use geometry_core::{Hull3, HullError, Kernel3, Perturbed, Point3, Points, Silent};

/// Where [`preparata_hong_parallel`] departs from Day's paper, and why.
pub const PARALLEL_DEPARTURES: &[&str] = &[
    "the halves of more than 4096 points are conquered at the same time, as Day planned to do on transputers",
    "steps are reported, and questions counted, by the sequential method, whose steps and questions are the same; the \
     parallel one cannot be observed",
    "otherwise as preparata-hong-3d",
];

/// Ranges of up to so many points are conquered by one thread. They take a few milliseconds.
const GRAIN: usize = 4096;

/// The result of [`preparata_hong_3d`](super::preparata_hong_3d()), found on several processors.
///
/// Runs on the current rayon thread pool. The sort, the top merge and the merging of coplanar facets are sequential.
///
/// # Errors
///
/// Those of [`preparata_hong_3d`](super::preparata_hong_3d()).
///
/// # Cost
///
/// The work of [`preparata_hong_3d`](super::preparata_hong_3d()); O(n) of it after another, besides the sort.
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points};
/// let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let hull = divide_and_conquer::preparata_hong_parallel(Points::new(&corner)?, &Exact)?;
/// assert_eq!(hull.facets().count(), 4);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn preparata_hong_parallel<K: Kernel3 + Sync>(
    points: Points<'_, 3>,
    kernel: &K,
) -> Result<Hull3, HullError> {
    hull_of_order(points, kernel, |order| {
        let questions = Oriented(Perturbed(kernel));
        let (surface, vertices) = conquer(&order.points, &order.ids, &questions)?;
        surface.into_mesh(vertices)
    })
}

/// The hull of all these points and its number of vertices.
fn conquer<'a, Q: Questions + Sync>(
    points: &'a [Point3],
    ids: &'a [u32],
    questions: &'a Q,
) -> Result<(Surface<'a, Resumed, Q, Silent>, u32), Fault> {
    let range = 0..points.len();
    if range.len() <= GRAIN {
        let mut surface = Surface::new(points, ids, questions, Silent);
        let vertices = surface.conquer(range, &mut |_| {})?;
        return Ok((surface, vertices));
    }
    let middle = range.len() / 2;
    let (first, second) = rayon::join(
        || conquer(&points[..middle], &ids[..middle], questions),
        || conquer(&points[middle..], &ids[middle..], questions),
    );
    let ((mut surface, first), (other, second)) = (first?, second?);
    surface.absorb(&other, points, ids);
    let vertices = surface.merge(range, middle, first + second)?;
    Ok((surface, vertices))
}
