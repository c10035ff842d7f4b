//! Quickhull in space, with outside sets.
//!
//! **Paper.** C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls", *ACM Transactions
//! on Mathematical Software* 22(4), 469–483, 1996.
//!
//! **Essence.**
//!
//! 1. Four extreme points span the first surface, a tetrahedron.
//! 2. Every other point goes to the *outside set* of the first facet that it lies outside of; a point outside none is
//!    inside and dropped.
//! 3. While some facet's outside set is not empty: its furthest point p is a vertex. The facets that p sees form
//!    one region; remove them, and join p to each edge of the region's rim, the *horizon*, by a new facet.
//! 4. The points in the outside sets of the removed facets are partitioned among the new facets as in step 2.
//!    No other point need be looked at (invariant 2).
//!
//! ```text
//!              p                      q, outside a removed facet and outside the new hull, is above a new facet:
//!             /|\                     the facets it sees form one region that crosses the horizon. The plane of
//!      q    /  |  \                   a new facet through an edge of the horizon lies between the planes
//!       \ /    |    \                 of the two old facets there, so what is above both is above it
//!   ----*------.------*----
//!     horizon   removed    horizon
//! ```
//!
//! **Bound.** O(n log n) for points whose partitions are balanced, as the paper assumes; O(n²) at worst. Measured
//! plane questions a point, flat in n from 10³ to 10⁶: 12 in a ball, 8 to 10 in a cube. On a sphere it is n log n: 33,
//! 47, 62 at n = 10³, 10⁴, 10⁵. Space: up to 6 n ids and n points for the outside sets and for partitioning, and
//! 40 bytes a facet.
//!
//! **Memory.** What takes the time for many points is waiting for memory, so neighbours in space are kept together:
//! facets are taken up region by region (`crate::pending`), the outside sets are slices of one vector, and the
//! points in them are copied in their order now and then (`regroup`).
//!
//! **Invariants.** In the terms of the perturbed kernel, for which no four distinct points are coplanar:
//!
//! 1. Before each step the surface is the hull of the vertices added so far.
//! 2. Each point that is outside the surface is in exactly one outside set, that of a facet it is outside of.
//! 3. `pending` holds every facet whose outside set is not empty; it may hold others.
//! 4. Copies of a point are asked the same questions and go to the same set, in the order of their indices, where the
//!    first is taken; it then coincides with a vertex, is outside of nothing, and all others are dropped.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When all points are extreme and their order is not adverse, `incremental-conflict` asks
//! about as much and has an expected bound that holds for every input.

mod outside;
mod simplex;
mod sites;

use crate::furthest::furthest;
use crate::horizon::Horizon;
use crate::pending::Pending;
use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::{TriMesh, TriangleId};
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Points, Step};
use outside::OutsideSets;
use sites::Sites;

/// Where this file departs from the paper, and why.
pub const DEPARTURES: &[&str] = &[
    "the paper handles rounding and coplanar points by merging facets that are not clearly convex; here every \
     answer is exact, coplanar points are told apart by a symbolic perturbation, and exactly coplanar facets are merged at \
     the end",
    "only three dimensions: facets are triangles",
    "the paper leaves open in which order facets are taken up. Here it is first made first, which keeps the \
     partitions balanced, but when many are waiting, half of them are left until the others and all that come of them \
     are done, which keeps one region of the surface at a time in the cache",
];

/// The convex hull by quickhull with outside sets.
///
/// # Errors
///
/// [`HullError::Contradiction`] if the facets that a point sees are not one region with one rim; cannot happen with
/// an exact kernel.
///
/// # Cost
///
/// O(n²) questions at worst; about linear on average for points of which few are extreme, O(n log n) for points on a
/// sphere. Space: O(n).
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
///
/// // The corners of a cube, its centre, and the centre of one face.
/// let mut points: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
/// points.extend([[0.5; 3], [0.5, 0.5, 0.0]]);
/// let hull = quickhull::quickhull_3d(Points::new(&points)?, &Exact, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 2, 3, 4, 5, 6, 7]);
/// assert_eq!(hull.facets().count(), 6);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn quickhull_3d<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let basis = match AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        Ok(flat) => return Ok(flat),
        Err(basis) => basis,
    };
    let simplex = simplex::spread(points, kernel, basis);
    let mut quickhull = Quickhull::of_simplex(points, Perturbed(kernel), observer, simplex);
    let mut many = FEW;
    while let Some((facet, apex)) = quickhull.next_apex() {
        quickhull.add(facet, apex)?;
        if quickhull.mesh.len() >= many {
            quickhull.regroup();
            many = 4 * quickhull.mesh.len();
        }
    }
    Ok(Hull3::from_mesh(points, &quickhull.mesh, kernel))
}

/// With so many facets, and whenever there are four times as many as the last time, the points left are copied in the
/// order of the outside sets. It takes a quarter off the time for a million points, in a ball and on a sphere.
const FEW: usize = 16;

struct Quickhull<'a, K, O> {
    points: Points<'a, 3>,
    kernel: K,
    observer: &'a mut O,
    mesh: TriMesh,
    /// The points still outside. The sets, the pool and what is found in it hold places in it, the mesh ids.
    sites: Sites<'a>,
    outside: OutsideSets,
    pending: Pending,
    horizon: Horizon,
    /// The facets made by the step under way.
    made: Vec<TriangleId>,
    /// The points to partition.
    pool: Vec<u32>,
    /// The points found outside one facet, and room for more.
    found: Vec<u32>,
}

impl<'a, K: Kernel3, O: Observer> Quickhull<'a, K, O> {
    /// Steps 1 and 2.
    fn of_simplex(
        points: Points<'a, 3>,
        kernel: K,
        observer: &'a mut O,
        simplex: [u32; 4],
    ) -> Self {
        let mesh = TriMesh::tetrahedron(simplex);
        let mut quickhull = Self {
            points,
            kernel,
            observer,
            made: mesh.triangles().collect(),
            mesh,
            sites: Sites::of(points),
            outside: OutsideSets::default(),
            pending: Pending::default(),
            horizon: Horizon::default(),
            pool: points.ids().filter(|id| !simplex.contains(id)).collect(),
            found: vec![0; points.len()],
        };
        quickhull.partition();
        quickhull
    }

    /// A facet with a point outside, and the place of the furthest such point.
    fn next_apex(&mut self) -> Option<(TriangleId, u32)> {
        loop {
            let facet = self.pending.next()?;
            if let Some(apex) = self.outside.furthest(facet) {
                return Some((facet, apex));
            }
        }
    }

    /// Steps 3 and 4 for the point at the place `apex`, which is outside `facet`.
    fn add(&mut self, facet: TriangleId, apex: u32) -> Result<(), HullError> {
        let id = self.sites.id(apex);
        self.observer.step(|| Step::Apex(id));
        self.find_horizon(facet, id)?;
        self.pool.clear();
        for &facet in &self.horizon.visible {
            let [a, b, c] = self.mesh.corners(facet);
            self.observer.step(|| Step::Drop(a, b, c));
            self.outside.take(facet, &mut self.pool);
            self.mesh.remove(facet);
        }
        if let Some(position) = self.pool.iter().position(|&place| place == apex) {
            self.pool.remove(position);
        }
        self.mesh.close(&self.horizon.rim, id, &mut self.made);
        self.observer.step(|| Step::Insert(id));
        self.partition();
        Ok(())
    }

    fn find_horizon(&mut self, start: TriangleId, id: u32) -> Result<(), HullError> {
        let (points, kernel, mesh) = (self.points, &self.kernel, &self.mesh);
        self.horizon.search(mesh, start, |facet| {
            let [a, b, c] = mesh.corners(facet).map(|id| points[id]);
            kernel.orient3(a, b, c, points[id]).is_positive()
        })
    }

    /// Gives each point of the pool to the first facet made that it is outside of, and drops the others.
    fn partition(&mut self) {
        let made = std::mem::take(&mut self.made);
        for &facet in &made {
            let [a, b, c] = self.mesh.corners(facet);
            self.observer.step(|| Step::Facet(a, b, c));
            if !self.pool.is_empty() {
                self.claim(facet);
            }
        }
        self.made = made;
        for &place in &self.pool {
            self.observer.step(|| Step::Discard(self.sites.id(place)));
        }
    }

    /// Moves the points of the pool that are outside `facet` to its outside set.
    ///
    /// Which side a point is on decides no branch: the processor could not foresee it.
    fn claim(&mut self, facet: TriangleId) {
        let plane = self.mesh.corners(facet).map(|id| self.points[id]);
        let [a, b, c] = plane;
        let coordinates = self.sites.coordinates();
        let (mut outside, mut rest) = (0, 0);
        for position in 0..self.pool.len() {
            let place = self.pool[position];
            self.observer.step(|| Step::Visit(self.sites.id(place)));
            let side = self.kernel.orient3(a, b, c, coordinates[place as usize]);
            let is_outside = side.is_positive();
            self.found[outside] = place;
            self.pool[rest] = place;
            outside += usize::from(is_outside);
            rest += usize::from(!is_outside);
        }
        self.pool.truncate(rest);
        let found = &self.found[..outside];
        let apex = furthest(coordinates, &self.kernel, plane, found.iter().copied());
        if let Some(apex) = apex {
            self.outside.put(facet, found, apex);
            let stored = self.outside.stored();
            self.observer.step(|| Step::Storage(stored as u32));
            self.pending.put_off(facet);
        }
    }

    /// Copies the points left in the order of the outside sets.
    fn regroup(&mut self) {
        let order = self.outside.renumber();
        self.sites.reorder(&order);
    }
}
