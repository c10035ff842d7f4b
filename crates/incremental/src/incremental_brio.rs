//! Insertion in a biased random order along a curve, each point found by a walk: for sets whose points are nearly all
//! extreme.
//!
//! **Paper.** N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", *Proceedings of the 19th Annual Symposium
//! on Computational Geometry*, 211–219, 2003. The walk: O. Devillers, S. Pion, M. Teillaud, "Walking in a triangulation",
//! *International Journal of Foundations of Computer Science* 13(2), 181–199, 2002; and why it ends: H. Edelsbrunner, "An
//! acyclicity theorem for cell complexes in d dimensions", *Combinatorica* 10(3), 251–260, 1990.
//!
//! **Essence.**
//!
//! 1. Four points make a tetrahedron. The others are put in rounds at random, each four times as large as the one before,
//!    and within a round along Hilbert's curve, or, where they lie along a line, along that (`line`). Points are moved in
//!    memory into that order.
//! 2. To insert a point, walk on the surface from the facet made last that faces it to a facet that the point sees. From a facet that
//!    it does not see, cross a side beyond which the point is, as seen from the *eye*, the first corner. If there is none,
//!    the facet covers the point, which is then in the hull.
//! 3. From the facet that it sees, search for all that it sees, and replace them by the cone over their rim.
//! 4. At the end merge coplanar triangles, and call the points by their indices. Where no point was in the plane of a
//!    facet on the way, only triangles of one cone can be coplanar (`noting`).
//!
//! ```text
//!     .-----.-----.            eye at the back, facets in front: the point is to the right
//!      \ 1 / \ 3 / \           of the shared side of 1 and 2, so cross it; then that of
//!       \ / 2 \ / 4 \  x       2 and 3; until a facet is seen or covers the point
//!        '-----'-----'
//! ```
//!
//! **Bound.** The expected number of facets made is that of a random order up to a constant, O(n): on a sphere 6.1 a
//! point. A walk takes O(1) steps a point where the order follows the surface (0.9 on a sphere, whatever n), and never
//! more steps than there are facets. Sorting takes O(n log n). Space: 24 bytes a facet and 36 a point. Nothing is done a
//! second time for a point, and nothing in an insertion grows with the surface.
//!
//! **Invariants.** In the terms of the perturbed kernel, where no four distinct points are coplanar:
//!
//! 1. Before each insertion the surface is the hull of the points inserted so far, copies left out.
//! 2. The eye is a point of the hull, since it was inserted first.
//! 3. A walk ends. Let the eye be the origin and n·x = 1 the plane of a facet that does not contain it; all of the hull
//!    has n·x ≤ 1. If p is beyond the plane through the eye and the side of facets f and g, on the side of g, then
//!    n(g)·p > n(f)·p: both functions agree on that plane, and at the third corner of g the first is 1 and the second
//!    less. So n·p grows with each step, and no facet comes twice. A facet at the eye is left by the side opposite; it is
//!    entered only if it is seen, because its own plane is that through the eye and the side, and then the walk is over.
//! 4. If no side is crossed from f, not at the eye, then p is in the cone of the eye over f. Not seen from p, f covers p.
//! 5. An orientation is zero exactly if two of the points are copies. A copy p of a corner sees no facet; it is in the
//!    cone of no facet but those at that corner, or is the eye; so where its walk ends, the corner is found.
//!
//! There is no arithmetic here that decides: the grid of the curve rounds, but bears on the order alone.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** When most points are interior: each takes a walk where a filter or quickhull drops it for a
//! few multiplications.

mod hilbert;
mod line;
mod noting;
mod region;
mod rounds;
mod walk;

use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::{TriMesh, TriangleId};
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Point3, Points, Step};
use noting::Noting;
use region::Region;
use walk::Place;

/// Where this file departs from the papers, and why.
pub const DEPARTURES: &[&str] = &[
    "the paper inserts for Delaunay triangulations, and leaves the order within a round and the search open: here it is \
     Hilbert's curve, and a walk seen from a vertex of the hull, which needs no point inside with exact coordinates",
    "the coin of the paper is a fixed permutation of the indices, so that the order is the same everywhere",
    "coplanar points are told apart by a symbolic perturbation, and exactly coplanar facets are merged at the end; a set \
     that does not span space has its flat hull",
];

/// The convex hull by insertion in a biased random order along Hilbert's curve.
///
/// # Errors
///
/// [`HullError::Contradiction`] if four points that span space are not four, a walk goes in circles, or what a point
/// sees is not one region; cannot happen with an exact kernel.
///
/// # Cost
///
/// Expected O(n log n) time for points along a surface, of which the sort has the logarithm: about fifteen orientations a
/// point. Space: O(n), on a sphere about 120 bytes a point with the result.
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent, Tally};
///
/// // A cube: its six square facets are cut into twelve triangles on the way.
/// let points: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
/// let mut tally = Tally::default();
/// let hull = incremental::incremental_brio(Points::new(&points)?, &Exact, &mut tally)?;
/// assert_eq!(hull.facets().count(), 6);
/// assert_eq!(tally.facets - tally.drops, 12);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn incremental_brio<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let simplex = match AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        Ok(flat) => return Ok(flat),
        Err(simplex) => simplex,
    };
    let names = rounds::order(points, simplex).ok_or(HullError::Contradiction {
        what: "four points that span space are not four",
    })?;
    let moved: Vec<Point3> = names.iter().map(|&id| points[id]).collect();
    let moved = Points::new(&moved)?;
    let kernel = Noting::new(kernel);
    let mut surface = Surface::of_first_four(moved, names, Perturbed(&kernel), observer);
    let mut region = Region::default();
    for p in moved.ids().skip(4) {
        match surface.locate(p)? {
            Place::Outside(side, behind) => surface.insert(p, side, behind, &mut region)?,
            Place::CoveredBy(facet) => surface.discard(p, facet),
        }
    }
    debug_assert!(surface.mesh.is_sound());
    let Surface { mesh, names, .. } = surface;
    let edges = kernel.edges();
    Ok(Hull3::from_renumbered_mesh(
        moved,
        &names,
        mesh,
        edges,
        kernel.kernel,
    ))
}

/// The first corner of the first tetrahedron, from which all is seen (invariant 2).
const EYE: u32 = 0;

/// The hull of the points inserted so far (invariant 1). Points are numbered by their places in the order of insertion.
struct Surface<'a, K, O> {
    points: Points<'a, 3>,
    /// The caller's index of each point; of copies the one on the surface has the smallest.
    names: Vec<u32>,
    kernel: K,
    observer: &'a mut O,
    mesh: TriMesh,
    /// The facet made or met last, where the next walk begins.
    latest: TriangleId,
}

impl<'a, K: Kernel3, O: Observer> Surface<'a, K, O> {
    /// Step 1, when all is in order.
    fn of_first_four(
        points: Points<'a, 3>,
        names: Vec<u32>,
        kernel: K,
        observer: &'a mut O,
    ) -> Self {
        let mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
        for facet in mesh.triangles() {
            let [a, b, c] = mesh.corners(facet).map(|id| names[id as usize]);
            observer.step(|| Step::Facet(a, b, c));
        }
        Self {
            points,
            names,
            kernel,
            observer,
            mesh,
            latest: TriangleId(0),
        }
    }

    /// Whether the point `p` sees the facet.
    #[inline(always)]
    fn sees(&mut self, p: u32, facet: TriangleId) -> bool {
        let names = &self.names;
        self.observer.step(|| Step::Visit(names[p as usize]));
        let [a, b, c] = self.mesh.corners(facet).map(|id| self.points[id]);
        // From p, as most corners are close to it: differences are small, and the filter is certain.
        self.kernel.orient3(self.points[p], b, a, c).is_positive()
    }

    /// Leaves out `p`, which the facet covers; of copies the smallest index remains (invariant 5).
    fn discard(&mut self, p: u32, facet: TriangleId) {
        self.latest = facet;
        let name = self.names[p as usize];
        self.observer.step(|| Step::Discard(name));
        let [a, b, c] = self.mesh.corners(facet);
        for corner in [a, b, c, EYE] {
            let [copy, of] = [p, corner].map(|id| self.points[id]);
            if name < self.names[corner as usize] && self.kernel.lexicographic3(copy, of).is_eq() {
                self.names.swap(p as usize, corner as usize);
            }
        }
    }
}
