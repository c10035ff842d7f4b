//! From a triangulated surface that is convex up to an infinitesimal displacement to the true facets.
//!
//! Where a perturbed kernel told coplanar points apart, the surface has coplanar neighbours, corners that are not
//! extreme, and flat triangles (three collinear corners). A true facet is the union of the triangles in one plane:
//!
//! 1. Take a triangle that is not flat and not yet used. Its plane is that of a facet.
//! 2. Walk from it to all neighbours that lie in the plane. Flat triangles are walked through but not used up: one
//!    along an edge of the hull lies in the planes of both facets there.
//! 3. The facet is the planar hull of all corners met.

use crate::dimension::planar_hull;
use crate::kernel::space::Kernel3;
use crate::mesh::{SideId, TriMesh, TriangleId};
use crate::points::Points;

/// Polygons one behind the other in one vector.
#[derive(Debug)]
pub(super) struct Loops {
    /// Polygon i is `corners[starts[i]..starts[i + 1]]`.
    pub(super) starts: Vec<u32>,
    pub(super) corners: Vec<u32>,
}

impl Loops {
    pub(super) fn with_capacity(polygons: usize, corners: usize) -> Self {
        let mut starts = Vec::with_capacity(polygons + 1);
        starts.push(0);
        Self {
            starts,
            corners: Vec::with_capacity(corners),
        }
    }

    pub(super) fn push(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.starts.push(self.corners.len() as u32);
    }

    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn range(&self, i: usize) -> std::ops::Range<usize> {
        self.starts[i] as usize..self.starts[i + 1] as usize
    }
}

/// The facets, each anticlockwise seen from outside.
pub(super) fn facets<K: Kernel3>(points: Points<'_, 3>, mesh: &TriMesh, kernel: &K) -> Loops {
    let merger = Merger {
        points,
        mesh,
        kernel,
    };
    let mut used = vec![false; mesh.slots()];
    // The number of the facet, plus one, whose walk last met a triangle.
    let mut met = vec![0_u32; mesh.slots()];
    let mut facets = Loops::with_capacity(mesh.len(), 3 * mesh.len());
    for triangle in mesh.triangles() {
        if used[triangle.0 as usize] {
            continue;
        }
        used[triangle.0 as usize] = true;
        if triangle
            .sides()
            .into_iter()
            .all(|side| !merger.is_coplanar_across(side))
        {
            facets.push(&mesh.corners(triangle));
        } else if !merger.is_flat(triangle) {
            let walk = facets.len() as u32 + 1;
            facets.push(&merger.facet_around(triangle, walk, &mut met, &mut used));
        }
    }
    facets
}

struct Merger<'a, K> {
    points: Points<'a, 3>,
    mesh: &'a TriMesh,
    kernel: &'a K,
}

impl<K: Kernel3> Merger<'_, K> {
    fn is_coplanar_across(&self, side: SideId) -> bool {
        let apex = self.mesh.apex(self.mesh.twin(side));
        self.is_on_plane(self.mesh.corners(side.triangle()), apex)
    }

    fn is_on_plane(&self, plane: [u32; 3], id: u32) -> bool {
        let [a, b, c] = plane.map(|id| self.points[id]);
        self.kernel.orient3(a, b, c, self.points[id]).is_zero()
    }

    fn is_flat(&self, triangle: TriangleId) -> bool {
        let [a, b, c] = self.mesh.corners(triangle).map(|id| self.points[id]);
        self.kernel.collinear3(a, b, c)
    }

    /// Steps 2 and 3, from the triangle `start`.
    fn facet_around(
        &self,
        start: TriangleId,
        walk: u32,
        met: &mut [u32],
        used: &mut [bool],
    ) -> Vec<u32> {
        let plane = self.mesh.corners(start);
        let mut corners = Vec::new();
        let mut to_visit = vec![start];
        met[start.0 as usize] = walk;
        while let Some(triangle) = to_visit.pop() {
            corners.extend(self.mesh.corners(triangle));
            for side in triangle.sides() {
                let beyond = self.mesh.twin(side);
                let neighbour = beyond.triangle();
                let slot = neighbour.0 as usize;
                if met[slot] == walk || !self.is_on_plane(plane, self.mesh.apex(beyond)) {
                    continue;
                }
                met[slot] = walk;
                used[slot] |= !self.is_flat(neighbour);
                to_visit.push(neighbour);
            }
        }
        corners.sort_unstable();
        corners.dedup();
        planar_hull(self.points, corners, plane, self.kernel).0
    }
}
