//! Quickhull as Balan, Munjal and Rao describe it.
//!
//! **Paper.** A. Balan, G. Munjal, T. R. Rao, "Implementation of Convex Hull Algorithms in 3D space", section 3.3,
//! with its cost in section 4.3. It follows Barber, Dobkin and Huhdanpaa "although not entirely".
//!
//! **Essence.** What is taken from the text, in its order:
//!
//! 1. (3.3.2) Six extreme points, two along each axis; the two of them furthest apart; the point furthest from the
//!    line through these; the point furthest from the plane through all three. They form the initial tetrahedron.
//! 2. (3.3.3) The *outside set* of a facet is the set of points in front of it. Those of the four first facets are
//!    found by testing all points against each, and the facets are put into the list of resultant faces.
//! 3. For every facet of the list, in order: if its outside set is not empty, scan it for the point furthest from the
//!    facet, the *apex*.
//! 4. A depth-first search along the edges of adjacent facets finds the horizon. The facets inside it are removed
//!    from the list, and the apex is joined to its edges by new facets.
//! 5. The outside sets of the removed facets are merged, every new facet is tested against the whole merged set to
//!    find its own, and the new facets are put at the end of the list.
//!
//! **How it differs from `quickhull_3d`.**
//!
//! | | here | `quickhull_3d` |
//! |---|---|---|
//! | a point in front of several facets | is in the outside set of each | is in that of the first |
//! | a new facet is tested against | all points of the merged set | those no earlier new facet has claimed |
//! | the furthest point of a facet | is scanned for when the facet's turn comes | is kept while partitioning |
//!
//! **Bound.** O(n) for each facet made, and so O(n m) for m facets: the text's own figure. Here m counts all facets
//! made, which is 2.5 to 3 times those of the hull, and the n of a late facet is the small merged set it is tested
//! against, so the bound is loose. Space: O(n) for the first facets; a point is stored once for every facet that it is
//! in front of.
//!
//! **Invariants.** In the terms of the perturbed kernel:
//!
//! 1. Before each step the surface is the hull of the vertices added so far.
//! 2. Each point outside the surface is in the outside set of at least one facet, and in that of no facet that it is
//!    not in front of. (Not of every facet it is in front of: a point in front of a new facet but of none of the
//!    removed ones is not in the merged set. It is in front of the facet beyond the horizon, and in that set.)
//! 3. Copies of a point are in the same sets, so the one with the smallest index is taken and the others are in front
//!    of nothing from then on.
//!
//! **Departures.** See [`DEPARTURES`].
//!
//! **When not to use it.** Whenever the hull is wanted and not the cost of this description: `quickhull_3d` does the
//! same with fewer questions.

mod start;

use crate::furthest::furthest;
use crate::horizon::Horizon;
use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::{TriMesh, TriangleId};
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Points, Step};
use std::collections::VecDeque;

/// Where this file departs from the text, and why.
pub const DEPARTURES: &[&str] = &[
    "the text computes normals and signed distances in floating point; here the kernel tells the side of a point \
     and the higher of two, exactly, and coplanar points are told apart by a symbolic perturbation",
    "which two of the six points are furthest apart, and which point is furthest from their line, is told by rounded \
     distances, as in the text: the start may be any four points that span space, and that these do is asked exactly",
    "the point furthest from the first plane is taken from one side, the other only if that one is empty: heights on \
     opposite sides are not compared",
    "the text takes the points to be distinct and to span space; here copies are allowed, and a flat set has its \
     flat hull",
];

/// The convex hull by quickhull as Balan, Munjal and Rao describe it.
///
/// # Errors
///
/// [`HullError::Contradiction`] if what a point sees is not one region with one rim, or if a vertex is found in
/// front of a facet; cannot happen with an exact kernel.
///
/// # Cost
///
/// O(n m) questions for m facets made. Space: O(n) ids, each point once for every facet it is in front of.
///
/// # Example
///
/// ```
/// use geometry_core::{Exact, Points, Silent};
/// let points = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0], [1.0; 3], [2.0; 3]];
/// let points = Points::new(&points)?;
/// let hull = quickhull::balan_quickhull(points, &Exact, &mut Silent)?;
/// assert_eq!(hull.vertices(), [0, 1, 2, 3, 5]);
/// assert_eq!(hull, quickhull::quickhull_3d(points, &Exact, &mut Silent)?);
/// # Ok::<(), geometry_core::HullError>(())
/// ```
pub fn balan_quickhull<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let basis = match AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        Ok(flat) => return Ok(flat),
        Err(basis) => basis,
    };
    let tetrahedron = start::tetrahedron(points, kernel, basis);
    let mut quickhull = Quickhull::of_tetrahedron(points, Perturbed(kernel), observer, tetrahedron);
    while let Some(facet) = quickhull.faces.pop_front() {
        if let Some(apex) = quickhull.find_apex(facet) {
            quickhull.add(facet, apex)?;
        }
    }
    Ok(Hull3::from_mesh(points, &quickhull.mesh, kernel))
}

struct Quickhull<'a, K, O> {
    points: Points<'a, 3>,
    kernel: K,
    observer: &'a mut O,
    mesh: TriMesh,
    /// The list of resultant faces not yet looked at. A face that was removed has an empty outside set.
    faces: VecDeque<TriangleId>,
    /// The outside set of each facet.
    outside: Vec<Vec<u32>>,
    horizon: Horizon,
    /// For each point, whether it is not to be put into a merged set: it is there already, or is a vertex.
    taken: Vec<bool>,
}

impl<'a, K: Kernel3, O: Observer> Quickhull<'a, K, O> {
    /// Step 2.
    fn of_tetrahedron(
        points: Points<'a, 3>,
        kernel: K,
        observer: &'a mut O,
        tetrahedron: [u32; 4],
    ) -> Self {
        let mut taken = vec![false; points.len()];
        for id in tetrahedron {
            taken[id as usize] = true;
        }
        let all: Vec<u32> = points.ids().filter(|&id| !taken[id as usize]).collect();
        let mut quickhull = Self {
            points,
            kernel,
            observer,
            mesh: TriMesh::tetrahedron(tetrahedron),
            faces: VecDeque::new(),
            outside: Vec::new(),
            horizon: Horizon::default(),
            taken,
        };
        let first: Vec<TriangleId> = quickhull.mesh.triangles().collect();
        quickhull.find_outside_sets(&first, &all);
        quickhull
    }

    /// Step 3.
    fn find_apex(&mut self, facet: TriangleId) -> Option<u32> {
        let set = &self.outside[facet.0 as usize];
        if set.is_empty() {
            return None;
        }
        let plane = self.mesh.corners(facet).map(|id| self.points[id]);
        let ids = set.iter().copied();
        let apex = furthest(self.points.as_slice(), &self.kernel, plane, ids)?;
        self.observer.step(|| Step::Apex(apex));
        Some(apex)
    }

    /// Steps 4 and 5.
    fn add(&mut self, facet: TriangleId, apex: u32) -> Result<(), HullError> {
        if std::mem::replace(&mut self.taken[apex as usize], true) {
            return Err(HullError::Contradiction {
                what: "a vertex of the surface lies in front of a facet",
            });
        }
        let Self {
            points,
            kernel,
            mesh,
            horizon,
            ..
        } = self;
        horizon.search(mesh, facet, |facet| {
            let [a, b, c] = mesh.corners(facet).map(|id| points[id]);
            kernel.orient3(a, b, c, points[apex]).is_positive()
        })?;
        let merged = self.remove_visible();
        let mut made = Vec::new();
        self.mesh.close(&self.horizon.rim, apex, &mut made);
        self.observer.step(|| Step::Insert(apex));
        self.find_outside_sets(&made, &merged);
        Ok(())
    }

    /// Removes the facets inside the horizon; returns the union of their outside sets, less the vertices.
    fn remove_visible(&mut self) -> Vec<u32> {
        let mut merged = Vec::new();
        for &facet in &self.horizon.visible {
            let [a, b, c] = self.mesh.corners(facet);
            self.observer.step(|| Step::Drop(a, b, c));
            self.mesh.remove(facet);
            for id in std::mem::take(&mut self.outside[facet.0 as usize]) {
                if !std::mem::replace(&mut self.taken[id as usize], true) {
                    merged.push(id);
                }
            }
        }
        for &id in &merged {
            self.taken[id as usize] = false;
        }
        merged
    }

    /// Finds the outside set of each of `facets` among `candidates`, and puts the facets into the list.
    fn find_outside_sets(&mut self, facets: &[TriangleId], candidates: &[u32]) {
        self.outside.resize(self.mesh.slots(), Vec::new());
        for &facet in facets {
            let [p, q, r] = self.mesh.corners(facet);
            self.observer.step(|| Step::Facet(p, q, r));
            let [a, b, c] = [p, q, r].map(|id| self.points[id]);
            let set = &mut self.outside[facet.0 as usize];
            for &id in candidates {
                self.observer.step(|| Step::Visit(id));
                if self.kernel.orient3(a, b, c, self.points[id]).is_positive() {
                    set.push(id);
                }
            }
            self.faces.push_back(facet);
        }
    }
}
