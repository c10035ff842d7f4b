//! The convex hull of a point set in space, as a canonical value.

mod canonical;
mod facets;
mod marks;
mod measure;

pub use measure::Location;

use crate::kernel::space::{Kernel3, lexicographic3};
use crate::mesh::TriMesh;
use crate::points::Points;
use facets::Loops;
use marks::Marks;

/// The convex hull of a point set in space.
///
/// Canonical: two right answers for the same points are equal values. Vertices are exactly the extreme points; of
/// equal points the smallest index stands for all.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Hull3 {
    /// The hull of no points.
    Empty,
    /// All points are copies of this one.
    Point(u32),
    /// All points are collinear: the lexicographically smallest and largest.
    Segment([u32; 2]),
    /// All points are in one plane: the corners in order, from the lexicographically smallest, towards the
    /// lexicographically smaller of its two neighbours.
    Planar(Vec<u32>),
    /// The points span space.
    Solid(Solid),
}

/// A polyhedron: its true facets, which are the maximal planar polygons, each anticlockwise seen from outside.
///
/// Each facet begins with its smallest index, and the facets are in lexicographic order as lists of indices.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Solid {
    vertices: Vec<u32>,
    facets: Loops,
}

/// What is known of the edges of a mesh before its coplanar triangles are merged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edges {
    /// Any two neighbours may be coplanar.
    Unknown,
    /// The mesh was grown by [`TriMesh::close`] or [`TriMesh::replace`] from a tetrahedron, and each apex was strictly
    /// inside of the facets just beyond its rim. So only triangles of one cone may be coplanar neighbours: the second side
    /// of the one is the third of the other. Or it was sewn together from such surfaces, and is bent along the seam.
    BentAtRims,
}

impl Hull3 {
    /// The hull bounded by `mesh`, whose triangles may be coplanar with their neighbours, and flat: the exact
    /// hull of points that a perturbed kernel told apart.
    ///
    /// Coplanar triangles are merged into facets, and corners that are not extreme are dropped. `kernel` must be
    /// exact and must not be perturbed; the surface must be that of a convex polyhedron, up to an infinitesimal
    /// displacement of its corners.
    ///
    /// # Cost
    ///
    /// One orientation an edge and O(f) time for f triangles; O(k log k) more for a facet of k triangles.
    pub fn from_mesh<K: Kernel3>(points: Points<'_, 3>, mesh: &TriMesh, kernel: &K) -> Self {
        Self::from_known_mesh(points, mesh, Edges::Unknown, kernel)
    }

    /// [`from_mesh`](Self::from_mesh), not asking about edges of which enough is known.
    pub fn from_known_mesh<K: Kernel3>(
        points: Points<'_, 3>,
        mesh: &TriMesh,
        edges: Edges,
        kernel: &K,
    ) -> Self {
        let (merged, larger) = facets::facets(points, mesh, edges, kernel);
        let vertices = vertices(points, None, mesh, &merged, &larger);
        Self::in_order(points.len(), vertices, mesh, &merged, larger)
    }

    /// [`from_known_mesh`](Self::from_known_mesh) for a mesh whose corners are indices into `points` in some order of its own;
    /// `names[i]` is the caller's index of `points[i]`.
    ///
    /// Of copies, `names` must give the one on the mesh the smallest index.
    ///
    /// # Panics
    ///
    /// If there are fewer names than points, or a name is not below the number of points.
    pub fn from_renumbered_mesh<K: Kernel3>(
        points: Points<'_, 3>,
        names: &[u32],
        mut mesh: TriMesh,
        edges: Edges,
        kernel: &K,
    ) -> Self {
        let (merged, mut larger) = facets::facets(points, &mesh, edges, kernel);
        let vertices = vertices(points, Some(names), &mesh, &merged, &larger);
        // Once, so that all that follows reads memory in order.
        let name = |id: u32| names[id as usize];
        mesh.renumber(name);
        for corner in &mut larger.corners {
            *corner = name(*corner);
        }
        Self::in_order(points.len(), vertices, &mesh, &merged, larger)
    }

    /// The solid with these vertices, whose facets are the triangles of `mesh` not `merged`, and the `larger` ones.
    fn in_order(
        count: usize,
        vertices: Vec<u32>,
        mesh: &TriMesh,
        merged: &Marks,
        larger: Loops,
    ) -> Self {
        let triangles = || whole_triangles(mesh, merged);
        let facets = canonical::in_order(count, triangles, larger);
        Hull3::Solid(Solid { vertices, facets })
    }

    /// The hull with every index i replaced by `ids[i]`: the hull of a set from the hull of those of its points that may be
    /// extreme.
    ///
    /// `ids` must be ascending, so that what is canonical remains so.
    ///
    /// # Panics
    ///
    /// If `ids` is too short.
    ///
    /// ```
    /// use geometry_core::Hull3;
    /// assert_eq!(Hull3::Segment([0, 1]).renumbered(&[3, 7]), Hull3::Segment([3, 7]));
    /// ```
    #[must_use]
    pub fn renumbered(mut self, ids: &[u32]) -> Self {
        let all: &mut [&mut [u32]] = match &mut self {
            Hull3::Empty => &mut [],
            Hull3::Point(id) => &mut [std::slice::from_mut(id)],
            Hull3::Segment(ends) => &mut [ends],
            Hull3::Planar(corners) => &mut [corners],
            Hull3::Solid(solid) => &mut [&mut solid.vertices, &mut solid.facets.corners],
        };
        for list in all {
            list.iter_mut().for_each(|id| *id = ids[*id as usize]);
        }
        self
    }

    /// The planar hull with these corners in cyclic order, in either direction.
    pub(crate) fn of_polygon(points: Points<'_, 3>, mut ids: Vec<u32>) -> Self {
        let by_place = |&i: &usize, &j: &usize| lexicographic3(points[ids[i]], points[ids[j]]);
        let first = (0..ids.len()).min_by(by_place).unwrap_or(0);
        ids.rotate_left(first);
        if let [_, second, .., last] = ids[..]
            && lexicographic3(points[last], points[second]).is_lt()
        {
            ids[1..].reverse();
        }
        Hull3::Planar(ids)
    }

    /// The vertices: ascending for a solid, otherwise in the order of the variant.
    pub fn vertices(&self) -> &[u32] {
        match self {
            Hull3::Empty => &[],
            Hull3::Point(id) => std::slice::from_ref(id),
            Hull3::Segment(ends) => ends,
            Hull3::Planar(ids) => ids,
            Hull3::Solid(solid) => &solid.vertices,
        }
    }

    /// The number of vertices, h.
    pub fn len(&self) -> usize {
        self.vertices().len()
    }

    /// Whether there is no vertex: the hull of no points.
    pub fn is_empty(&self) -> bool {
        self.vertices().is_empty()
    }

    /// The dimension of the hull: `None` if empty, otherwise 0 to 3.
    pub fn dimension(&self) -> Option<usize> {
        match self {
            Hull3::Empty => None,
            Hull3::Point(_) => Some(0),
            Hull3::Segment(_) => Some(1),
            Hull3::Planar(_) => Some(2),
            Hull3::Solid(_) => Some(3),
        }
    }

    /// The facets of a solid, or none.
    pub fn facets(&self) -> impl Iterator<Item = &[u32]> {
        let solid = if let Hull3::Solid(solid) = self {
            Some(solid)
        } else {
            None
        };
        solid.into_iter().flat_map(Solid::facets)
    }

    /// The boundary as triangles, anticlockwise seen from outside: each facet of a solid as a fan from its first
    /// corner. Empty below dimension 3.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.facets().flat_map(|facet| {
            facet
                .windows(2)
                .skip(1)
                .map(|edge| [facet[0], edge[0], edge[1]])
        })
    }
}

impl Solid {
    /// The solid with these facets, each a list of corners anticlockwise seen from outside, starting anywhere.
    ///
    /// Only puts them in canonical order; that they bound a convex polyhedron is for the caller to know, or for a
    /// checker to find out.
    ///
    /// # Cost
    ///
    /// O(m log m) time for m corners in all.
    pub fn from_loops(loops: Vec<Vec<u32>>) -> Self {
        let mut facets = Loops::with_capacity(loops.len(), loops.iter().map(Vec::len).sum());
        for corners in &loops {
            facets.push(corners);
        }
        let mut vertices = facets.corners.clone();
        vertices.sort_unstable();
        vertices.dedup();
        Self {
            vertices,
            facets: canonical::sorted(facets),
        }
    }

    /// The facets in canonical order.
    pub fn facets(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        (0..self.facets.len()).map(|i| self.facets.polygon(i))
    }

    /// The vertices in ascending order.
    pub fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The number of facets.
    pub fn facet_count(&self) -> usize {
        self.facets.len()
    }

    /// The number of edges.
    pub fn edge_count(&self) -> usize {
        self.facets.corners.len() / 2
    }
}

/// The triangles that are facets by themselves.
fn whole_triangles<'a>(
    mesh: &'a TriMesh,
    merged: &'a Marks,
) -> impl Iterator<Item = [u32; 3]> + 'a {
    let whole = mesh
        .triangles()
        .filter(|triangle| !merged.contains(triangle.0));
    whole.map(|triangle| mesh.corners(triangle))
}

/// The names of the corners of all facets, ascending.
fn vertices(
    points: Points<'_, 3>,
    names: Option<&[u32]>,
    mesh: &TriMesh,
    merged: &Marks,
    larger: &Loops,
) -> Vec<u32> {
    if merged.is_empty() && mesh.len() / 2 + 2 == points.len() {
        // By Euler's formula all points are corners.
        return points.ids().collect();
    }
    let larger = larger.corners.iter().copied();
    let corners = whole_triangles(mesh, merged).flatten().chain(larger);
    named(points, names, corners)
}

/// The names of `corners`, ascending.
fn named(
    points: Points<'_, 3>,
    names: Option<&[u32]>,
    corners: impl Iterator<Item = u32>,
) -> Vec<u32> {
    let mut named = Marks::default();
    match names {
        None => corners.for_each(|corner| named.insert(corner, points.len())),
        Some(names) => {
            // First by the numbers of the mesh, where neighbours are close.
            let mut is_corner = vec![false; points.len()];
            corners.for_each(|corner| is_corner[corner as usize] = true);
            for (&name, is_corner) in names.iter().zip(is_corner) {
                if is_corner {
                    named.insert(name, points.len());
                }
            }
        }
    }
    named.ascending()
}
