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

/// The facets, each anticlockwise seen from outside: for each slot of the mesh, whether its triangle is a facet by
/// itself, and the larger facets.
///
/// One orientation an edge tells which are which.
pub(super) fn facets<K: Kernel3>(
    points: Points<'_, 3>,
    mesh: &TriMesh,
    kernel: &K,
) -> (Vec<bool>, Loops) {
    let merger = Merger {
        points,
        mesh,
        kernel,
    };
    let is_whole = merger.without_coplanar_neighbours();
    let mut larger = Loops::with_capacity(0, 0);
    let mut used = Vec::new();
    // The number of the facet, plus one, whose walk last met a triangle.
    let mut met = Vec::new();
    for triangle in mesh.triangles() {
        let slot = triangle.0 as usize;
        if is_whole[slot] {
            continue;
        }
        // Only now, as in general position nothing is to be merged.
        used.resize(mesh.slots(), false);
        met.resize(mesh.slots(), 0_u32);
        if !used[slot] && !merger.is_flat(triangle) {
            used[slot] = true;
            let walk = larger.len() as u32 + 1;
            larger.push(&merger.facet_around(triangle, walk, &mut met, &mut used));
        }
    }
    (is_whole, larger)
}

struct Merger<'a, K> {
    points: Points<'a, 3>,
    mesh: &'a TriMesh,
    kernel: &'a K,
}

impl<K: Kernel3> Merger<'_, K> {
    /// For each slot of the mesh, whether it has a triangle, and none of its neighbours is coplanar with it.
    fn without_coplanar_neighbours(&self) -> Vec<bool> {
        let slots = self.mesh.slots() as u32;
        let mut found: Vec<bool> = (0..slots)
            .map(|slot| self.mesh.is_alive(TriangleId(slot)))
            .collect();
        // Each edge once, from the triangle with the greater number, which is as good as random: chosen without a
        // branch, in batches.
        let mut batch = [(TriangleId(0), SideId(0)); 256];
        let mut filled = 0;
        for triangle in self.mesh.triangles() {
            for twin in self.mesh.twins(triangle) {
                batch[filled] = (triangle, twin);
                filled += usize::from(twin.triangle() < triangle);
            }
            if filled + 3 > batch.len() {
                self.strike_coplanar(&batch[..filled], &mut found);
                filled = 0;
            }
        }
        self.strike_coplanar(&batch[..filled], &mut found);
        found
    }

    /// Clears the marks of the triangles that are coplanar with the one at the other end of a pair.
    fn strike_coplanar(&self, pairs: &[(TriangleId, SideId)], is_whole: &mut [bool]) {
        for &(triangle, twin) in pairs {
            if self.is_on_plane(self.mesh.corners(triangle), self.mesh.apex(twin)) {
                is_whole[triangle.0 as usize] = false;
                is_whole[twin.triangle().0 as usize] = false;
            }
        }
    }

    /// The point comes first in the question, as the one close to the corners of which two are close together and one
    /// is far away: differences from it are small, and the filter is certain.
    fn is_on_plane(&self, plane: [u32; 3], id: u32) -> bool {
        let [a, b, c] = plane.map(|id| self.points[id]);
        self.kernel.orient3(self.points[id], a, b, c).is_zero()
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
