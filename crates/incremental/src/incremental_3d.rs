//! Insertion in random order, every facet tested: the hull in space without a conflict graph.
//!
//! **Paper.** A. Balan, G. Munjal, T. R. Rao, "Implementation of Convex Hull Algorithms in 3D space", sections 3.2
//! and 4.2, after M. de Berg, O. Cheong, M. van Kreveld, M. Overmars, *Computational Geometry: Algorithms and
//! Applications*, third edition, Springer 2008, chapter 11, whose conflict graph they leave out.
//!
//! **Essence.**
//!
//! 1. Four of the points that do not lie in one plane form a tetrahedron.
//! 2. Each further point, in random order, is tested against every facet of the hull so far: it *sees* those that it
//!    lies outside of.
//! 3. If it sees none, it is inside, and nothing changes. Otherwise the facets that it sees are deleted. An edge
//!    between two of them goes as well; an edge with only one deleted facet is on the *horizon*, and the new point is
//!    joined to it by a new facet.
//!
//! It is method R (`method_r`) one dimension up: edges become facets, the two ends of the run of edges that a point
//! lies outside of become the closed horizon.
//!
//! **Bound.** The i-th point costs one visibility test for each facet of the hull of those before it. If all points
//! are extreme and no four coplanar, that hull has 2(i-1) - 4 facets, and the tests are exactly
//!
//! ```text
//!     Σ  (2(i-1) - 4)  =  (n-1)(n-4)
//!    i=5..n
//! ```
//!
//! for every order; that is the text's "quadratic". With interior points it is Σ Fᵢ: about 6 n^1.5 in a ball, and
//! linear where the hull stays small. The facets made are expected to be fewer than 6 n in random order, but
//! may be n²/4 in a bad one: half the points on a circle, then the other half up its axis. Space: the surface, and a
//! flag a facet.
//!
//! **Invariants.** In the terms of the perturbed kernel:
//!
//! 1. Before each insertion the surface is the hull of the points inserted so far.
//! 2. What a new point sees is one region of the surface with one rim.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When the hull is large: `incremental-conflict` knows what a point sees and asks about
//! nothing else.

use crate::order::Order;
use crate::surface::{self, Start};
use geometry_core::mesh::{SideId, TriMesh, TriangleId};
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Points, Step};

/// Where this file departs from the text, and why.
pub const DEPARTURES: &[&str] = &[
    "the text tells visibility by the sign of a rounded volume; here the kernel tells it exactly, coplanar points are \
     told apart by a symbolic perturbation, and exactly coplanar facets are merged at the end",
    "the text takes the points to be distinct and raises an exception if they lie in one plane; here copies are left \
     out by a sort, and a flat set has its flat hull",
    "the two random points of the start are the first two of the random order",
    "the horizon is walked along in order, instead of joining the new facets by looking for equal edges",
];

/// The convex hull by insertion in random order, with [`DEFAULT_SEED`](crate::DEFAULT_SEED).
///
/// # Errors
///
/// [`HullError::Contradiction`] if what a point sees is not one region; cannot happen with an exact kernel.
///
/// # Cost
///
/// One orientation for every point and facet of the hull of the points before it: (n-1)(n-4) if all are extreme and
/// in general position. O(n log n) comparisons to leave out copies. Space: O(n).
///
/// # Example
///
/// ```
/// use geometry_core::{Counted, Exact, Hull3, Points, Silent};
///
/// let octahedron = [
///     [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0],
/// ];
/// let hull = incremental::incremental_3d(Points::new(&octahedron)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.facets().count(), 8);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn incremental_3d<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    incremental_3d_in(points, Order::default(), kernel, observer)
}

/// [`incremental_3d`] with a seed for the random order.
///
/// # Errors
///
/// As [`incremental_3d`].
pub fn incremental_3d_seeded<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    seed: u64,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    incremental_3d_in(points, Order::Shuffled { seed }, kernel, observer)
}

/// [`incremental_3d`] in a chosen order. The hull is the same for all.
///
/// # Errors
///
/// As [`incremental_3d`].
pub fn incremental_3d_in<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    order: Order,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let (corners, rest) = match surface::start(points, kernel, order.of(points, kernel))? {
        Start::Flat(hull) => return Ok(hull),
        Start::Tetrahedron { corners, rest } => (corners, rest),
    };
    let mut hull = GrowingHull::of_tetrahedron(points, Perturbed(kernel), observer, corners);
    for id in rest {
        hull.test_facets(id);
        if hull.visible.is_empty() {
            hull.observer.step(|| Step::Discard(id));
        } else {
            hull.insert(id)?;
        }
    }
    Ok(Hull3::from_mesh(points, &hull.mesh, kernel))
}

/// The hull of the points inserted so far (invariant 1).
struct GrowingHull<'a, K, O> {
    points: Points<'a, 3>,
    kernel: K,
    observer: &'a mut O,
    mesh: TriMesh,
    /// The facets that the latest point sees.
    visible: Vec<TriangleId>,
    /// For each facet, whether the latest point sees it.
    is_visible: Vec<bool>,
    rim: Vec<SideId>,
    made: Vec<TriangleId>,
}

impl<'a, K: Kernel3, O: Observer> GrowingHull<'a, K, O> {
    fn of_tetrahedron(
        points: Points<'a, 3>,
        kernel: K,
        observer: &'a mut O,
        corners: [u32; 4],
    ) -> Self {
        let mesh = TriMesh::tetrahedron(corners);
        let mut hull = Self {
            points,
            kernel,
            observer,
            made: mesh.triangles().collect(),
            mesh,
            visible: Vec::new(),
            is_visible: Vec::new(),
            rim: Vec::new(),
        };
        hull.tell_made();
        hull
    }

    /// Step 2.
    fn test_facets(&mut self, id: u32) {
        self.observer.step(|| Step::Visit(id));
        let Self {
            points,
            kernel,
            mesh,
            visible,
            is_visible,
            ..
        } = self;
        visible.clear();
        is_visible.clear();
        is_visible.resize(mesh.slots(), false);
        for triangle in mesh.triangles() {
            if surface::sees(*points, kernel, mesh, triangle, id) {
                visible.push(triangle);
                is_visible[triangle.0 as usize] = true;
            }
        }
    }

    /// Step 3, where it sees a facet.
    fn insert(&mut self, id: u32) -> Result<(), HullError> {
        let is_visible = |triangle: TriangleId| self.is_visible[triangle.0 as usize];
        surface::rim(&self.mesh, &self.visible, is_visible, &mut self.rim)?;
        for &triangle in &self.visible {
            let [a, b, c] = self.mesh.corners(triangle);
            self.observer.step(|| Step::Drop(a, b, c));
            self.mesh.remove(triangle);
        }
        self.mesh.close(&self.rim, id, &mut self.made);
        self.observer.step(|| Step::Insert(id));
        self.tell_made();
        Ok(())
    }

    fn tell_made(&mut self) {
        for &triangle in &self.made {
            let [a, b, c] = self.mesh.corners(triangle);
            self.observer.step(|| Step::Facet(a, b, c));
        }
    }
}
