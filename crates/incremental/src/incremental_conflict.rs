//! Insertion in random order with a conflict graph: expected O(n log n) in space, for every input.
//!
//! **Paper.** K. L. Clarkson, P. W. Shor, "Applications of random sampling in computational geometry, II", *Discrete &
//! Computational Geometry* 4, 387–421, 1989; as told by M. de Berg, O. Cheong, M. van Kreveld, M. Overmars,
//! *Computational Geometry: Algorithms and Applications*, third edition, Springer 2008, chapter 11.
//!
//! **Essence.**
//!
//! 1. Four points of the random order form a tetrahedron. A point not yet inserted and a facet that it sees are *in
//!    conflict*; the conflict graph holds all such pairs, from both sides.
//! 2. Insert the next point p. The graph names the facets that it sees; if there are none, p is inside.
//! 3. Otherwise join p to each edge e of their rim by a new facet. A point can see the new facet only if it sees one of
//!    the two old facets at e (invariant 3), so only those in conflict with either are tested.
//! 4. Drop the facets that p sees, and p, with all their arcs.
//!
//! ```text
//!               p                     the plane of the new facet (e, p) lies between
//!              /                      those of f and g: what is below both of these
//!             / new                   is below it
//!     g      /
//!   --------e
//!            \ f, dropped
//! ```
//!
//! **Bound.** Expected O(n log n) time over the random orders, whatever the points; O(n²) for the worst order. Expected
//! facets made: at most 6 n - 20, by backwards analysis: the point inserted last has average degree less than 6.
//! On a sphere the measured figure is 5.91, 5.99, 6.00 a point at n = 10³, 10⁴, 10⁵. Space: expected O(n) arcs.
//!
//! **Invariants.** In the terms of the perturbed kernel:
//!
//! 1. Before each insertion the surface is the hull of the points inserted so far.
//! 2. The graph holds an arc for exactly the pairs of a point not yet inserted and a facet that it sees.
//! 3. A point outside the new hull that sees the new facet over e sees one of the two old facets at e: the plane of
//!    the new facet lies between theirs, so what is above it is above one of them.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When most points are interior, or the order of the input has no malice in it: quickhull asks
//! half as much, because it looks at one conflict of a point and chooses its points.

mod graph;

use crate::order::Order;
use crate::surface::{self, Start};
use geometry_core::mesh::{SideId, TriMesh, TriangleId};
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Points, Step};
use graph::{ConflictGraph, unite};

/// Where this file departs from the book, and why.
pub const DEPARTURES: &[&str] = &[
    "the book lets a new facet that is coplanar with the old one beyond the horizon be merged with it at once; here \
     coplanar points are told apart by a symbolic perturbation, and exactly coplanar facets are merged at the end",
    "copies of a point are left out by a sort; a set that does not span space has its flat hull",
    "the doubly connected edge list is one of triangles only",
];

/// The convex hull by insertion in random order with a conflict graph, with [`DEFAULT_SEED`](crate::DEFAULT_SEED).
///
/// # Errors
///
/// [`HullError::Contradiction`] if what a point sees is not one region; cannot happen with an exact kernel.
///
/// # Cost
///
/// Expected O(n log n) questions and time. Space: expected O(n).
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent, Tally};
///
/// // A cube: its six square facets are cut into twelve triangles on the way.
/// let points: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
/// let mut tally = Tally::default();
/// let hull = incremental::incremental_conflict(Points::new(&points)?, &Exact, &mut tally)?;
/// assert_eq!(hull.facets().count(), 6);
/// assert_eq!(tally.facets - tally.drops, 12);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn incremental_conflict<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    incremental_conflict_in(points, Order::default(), kernel, observer)
}

/// [`incremental_conflict`] with a seed for the random order.
///
/// # Errors
///
/// As [`incremental_conflict`].
pub fn incremental_conflict_seeded<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    seed: u64,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    incremental_conflict_in(points, Order::Shuffled { seed }, kernel, observer)
}

/// [`incremental_conflict`] in a chosen order. The hull is the same for all.
///
/// # Errors
///
/// As [`incremental_conflict`].
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent, Tally};
/// use incremental::{Order, incremental_conflict_in};
///
/// // Points on a circle, then points up its axis: in this order each of the latter sees the whole cone.
/// let circle = (0..20).map(|i| f64::from(i) * std::f64::consts::TAU / 20.0).map(|t| [t.cos(), t.sin(), 0.0]);
/// let points: Vec<_> = circle.chain((1..=20).map(|z| [0.0, 0.0, f64::from(z)])).collect();
/// let facets = |order| {
///     let mut tally = Tally::default();
///     incremental_conflict_in(Points::new(&points)?, order, &Exact, &mut tally)?;
///     Ok::<u64, geometry_core::HullError>(tally.facets)
/// };
/// assert!(facets(Order::AsGiven)? >= 20 * 20);
/// assert!(facets(Order::default())? < 200);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn incremental_conflict_in<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    order: Order,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let (corners, rest) = match surface::start(points, kernel, order.of(points, kernel))? {
        Start::Flat(hull) => return Ok(hull),
        Start::Tetrahedron { corners, rest } => (corners, rest),
    };
    let mut hull = GrowingHull::of_tetrahedron(points, Perturbed(kernel), observer, corners, &rest);
    for next in 0..rest.len() as u32 {
        hull.look_up_visible(next);
        if hull.visible.is_empty() {
            hull.observer.step(|| Step::Discard(rest[next as usize]));
        } else {
            hull.insert(next)?;
        }
    }
    Ok(Hull3::from_mesh(points, &hull.mesh, kernel))
}

/// The hull of the points inserted so far, with the conflicts of the others (invariants 1 and 2).
struct GrowingHull<'a, K, O> {
    points: Points<'a, 3>,
    kernel: K,
    observer: &'a mut O,
    /// The points to insert, in order; the graph numbers them by their places here.
    order: &'a [u32],
    mesh: TriMesh,
    graph: ConflictGraph,
    /// The facets that the latest point sees.
    visible: Vec<TriangleId>,
    /// For each facet, whether the latest point sees it; all false between insertions.
    is_visible: Vec<bool>,
    rim: Vec<SideId>,
    made: Vec<TriangleId>,
    /// Places of points that may see a new facet.
    candidates: Vec<u32>,
}

impl<'a, K: Kernel3, O: Observer> GrowingHull<'a, K, O> {
    /// Step 1.
    fn of_tetrahedron(
        points: Points<'a, 3>,
        kernel: K,
        observer: &'a mut O,
        corners: [u32; 4],
        order: &'a [u32],
    ) -> Self {
        let mut hull = Self {
            points,
            kernel,
            observer,
            order,
            mesh: TriMesh::tetrahedron(corners),
            graph: ConflictGraph::of_points(order.len()),
            visible: Vec::new(),
            is_visible: Vec::new(),
            rim: Vec::new(),
            made: Vec::new(),
            candidates: (0..order.len() as u32).collect(),
        };
        for facet in [0, 1, 2, 3].map(TriangleId) {
            hull.find_conflicts(facet);
        }
        hull
    }

    /// Step 2.
    fn look_up_visible(&mut self, next: u32) {
        self.visible.clear();
        self.visible.extend(self.graph.facets_of(next));
    }

    /// Steps 3 and 4.
    fn insert(&mut self, next: u32) -> Result<(), HullError> {
        self.is_visible.resize(self.mesh.slots(), false);
        for facet in &self.visible {
            self.is_visible[facet.0 as usize] = true;
        }
        let is_visible = |facet: TriangleId| self.is_visible[facet.0 as usize];
        surface::rim(&self.mesh, &self.visible, is_visible, &mut self.rim)?;
        // The old facets at each edge of the rim. Those to be dropped stay until their conflicts have been read.
        let old: Vec<[TriangleId; 2]> = self
            .rim
            .iter()
            .map(|&beyond| [self.mesh.twin(beyond), beyond].map(SideId::triangle))
            .collect();
        let id = self.order[next as usize];
        self.mesh.close(&self.rim, id, &mut self.made);
        self.observer.step(|| Step::Insert(id));
        for (at, [seen, beyond]) in old.into_iter().enumerate() {
            let [seen, beyond] = [seen, beyond].map(|facet| self.graph.points_of(facet));
            unite(
                seen.filter(|&point| point != next),
                beyond,
                &mut self.candidates,
            );
            self.find_conflicts(self.made[at]);
        }
        self.drop_visible();
        let arcs = self.graph.len();
        self.observer.step(|| Step::Storage(arcs as u32));
        Ok(())
    }

    /// Puts the candidates that see `facet`, a new one, into the graph.
    fn find_conflicts(&mut self, facet: TriangleId) {
        let [a, b, c] = self.mesh.corners(facet);
        self.observer.step(|| Step::Facet(a, b, c));
        for &candidate in &self.candidates {
            let id = self.order[candidate as usize];
            self.observer.step(|| Step::Visit(id));
            if surface::sees(self.points, &self.kernel, &self.mesh, facet, id) {
                self.graph.add(facet, candidate);
            }
        }
    }

    fn drop_visible(&mut self) {
        for &facet in &self.visible {
            let [a, b, c] = self.mesh.corners(facet);
            self.observer.step(|| Step::Drop(a, b, c));
            self.is_visible[facet.0 as usize] = false;
            self.graph.drop_facet(facet);
            self.mesh.remove(facet);
        }
    }
}
