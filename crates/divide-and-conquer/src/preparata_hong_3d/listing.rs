//! The facets of one hull listed by Day's spiral and by a plain traversal, for studies of the spiral.

use super::edges::Dart;
use super::faces::{by_number, spiral};
use super::questions::Oriented;
use super::surface::{Fault, Surface};
use super::{Order, Resumed};
use geometry_core::dimension::AffineBasis;
use geometry_core::{HullError, Kernel3, Perturbed, Points, Silent};

/// The facets of a hull, twice: triangles anticlockwise seen from outside, coplanar ones apart.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listings {
    /// In the order in which Day's path meets them.
    pub spiral: Vec<[u32; 3]>,
    /// In the order of the edge records.
    pub by_number: Vec<[u32; 3]>,
    /// How many calls within each other Day's recursive procedure would take.
    pub deepest: usize,
}

/// Lists the facets of the hull of `points` in both ways; nothing for points that do not span space.
///
/// # Errors
///
/// Those of [`preparata_hong_3d`](super::preparata_hong_3d()).
///
/// # Cost
///
/// That of [`preparata_hong_3d`](super::preparata_hong_3d()).
///
/// # Example
///
/// ```
/// use divide_and_conquer::preparata_hong_3d::listings;
/// use geometry_core::{Exact, Points};
/// let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// let listings = listings(Points::new(&corner)?, &Exact)?;
/// assert_eq!((listings.spiral.len(), listings.by_number.len()), (4, 4));
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn listings<K: Kernel3>(points: Points<'_, 3>, kernel: &K) -> Result<Listings, HullError> {
    if AffineBasis::of(points, kernel)
        .flat_hull(points, kernel)
        .is_ok()
    {
        return Ok(Listings::default());
    }
    let order = Order::of(points, kernel);
    let questions = Oriented(Perturbed(kernel));
    let mut surface = Surface::<Resumed, _, _>::new(&order.points, &order.ids, &questions, Silent);
    surface.conquer(0..order.ids.len(), &mut |_| {})?;
    let start = Dart(surface.places[0].spoke);
    let spiral = spiral(&surface.edges, start, order.ids.len())?;
    let corners = |dart| {
        let facet = surface.edges.triangle(dart).ok_or(Fault::Tangled)?;
        Ok(facet.map(|dart| surface.id(surface.edges.origin(dart))))
    };
    let triangles = |darts: Vec<Dart>| darts.into_iter().map(corners).collect::<Result<_, Fault>>();
    Ok(Listings {
        deepest: spiral.deepest,
        spiral: triangles(spiral.facets)?,
        by_number: triangles(by_number(&surface.edges)?)?,
    })
}
