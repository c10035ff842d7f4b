//! The convex hull of a point set in space, as a canonical value.

mod facets;
mod measure;

pub use measure::Location;

use crate::kernel::space::{Kernel3, lexicographic3};
use crate::mesh::TriMesh;
use crate::points::Points;
use facets::Loops;

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
    /// Facet i is `corners[starts[i]..starts[i + 1]]`.
    starts: Vec<u32>,
    corners: Vec<u32>,
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
    /// O(f) orientations and O(f log f) time for f triangles; O(k log k) more for a facet of k triangles.
    pub fn from_mesh<K: Kernel3>(points: Points<'_, 3>, mesh: &TriMesh, kernel: &K) -> Self {
        let facets = facets::facets(points, mesh, kernel);
        // Sorting what there is takes less than looking through all points where few of them are corners.
        if 16 * facets.corners.len() < points.len() {
            let mut vertices = facets.corners.clone();
            vertices.sort_unstable();
            vertices.dedup();
            return Hull3::Solid(Solid::in_order(facets, vertices));
        }
        let mut is_vertex = vec![false; points.len()];
        for &id in &facets.corners {
            is_vertex[id as usize] = true;
        }
        let vertices = points.ids().filter(|&id| is_vertex[id as usize]).collect();
        Hull3::Solid(Solid::in_order(facets, vertices))
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
            Hull3::Solid(solid) => &mut [&mut solid.vertices, &mut solid.corners],
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
        Self::in_order(facets, vertices)
    }

    /// The solid with these facets, starting anywhere and in any order; `vertices` are all their corners, ascending.
    ///
    /// The facets are sorted by their first two corners, side by side in memory: no two facets of a surface share both.
    fn in_order(mut facets: Loops, vertices: Vec<u32>) -> Self {
        let mut order: Vec<(u64, u32)> = Vec::with_capacity(facets.len());
        for i in 0..facets.len() {
            let range = facets.range(i);
            let corners = &mut facets.corners[range];
            let first = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap_or(0);
            corners.rotate_left(first);
            let [first, second] = [0, 1].map(|i| u64::from(corners.get(i).copied().unwrap_or(0)));
            order.push((first << 32 | second, i as u32));
        }
        let corners = |i: u32| &facets.corners[facets.range(i as usize)];
        order.sort_unstable_by(|(key, i), (other, j)| {
            key.cmp(other).then_with(|| corners(*i).cmp(corners(*j)))
        });
        let mut sorted = Loops::with_capacity(facets.len(), facets.corners.len());
        for &(_, i) in &order {
            sorted.push(corners(i));
        }
        Self {
            vertices,
            starts: sorted.starts,
            corners: sorted.corners,
        }
    }

    /// The facets in canonical order.
    pub fn facets(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.starts
            .windows(2)
            .map(|range| &self.corners[range[0] as usize..range[1] as usize])
    }

    /// The vertices in ascending order.
    pub fn vertices(&self) -> &[u32] {
        &self.vertices
    }

    /// The number of facets.
    pub fn facet_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The number of edges.
    pub fn edge_count(&self) -> usize {
        self.corners.len() / 2
    }
}
