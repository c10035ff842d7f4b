//! From a triangulated surface that is convex up to an infinitesimal displacement to the true facets.
//!
//! Where a perturbed kernel told coplanar points apart, the surface has coplanar neighbours, corners that are not
//! extreme, and flat triangles (three collinear corners). A true facet is the union of the triangles in one plane:
//!
//! 1. Take a triangle that is not flat and not yet used. Its plane is that of a facet.
//! 2. Walk from it to all neighbours that lie in the plane. Flat triangles are walked through but not used up: one
//!    along an edge of the hull lies in the planes of both facets there.
//! 3. The facet is the planar hull of all corners met.

use super::Edges;
use super::marks::Marks;
use crate::dimension::planar_hull;
use crate::kernel::space::Kernel3;
use crate::mesh::{SideId, TriMesh, TriangleId};
use crate::points::Points;
use std::ops::Range;

/// Polygons one behind the other in one vector.
///
/// Two rows of the same polygons are equal.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(super) struct Loops {
    /// Polygon i is `corners[starts[i]..starts[i + 1]]`; empty as long as all are triangles.
    starts: Vec<u32>,
    pub(super) corners: Vec<u32>,
}

impl Loops {
    pub(super) fn with_capacity(polygons: usize, corners: usize) -> Self {
        Self {
            starts: Vec::with_capacity(polygons + 1),
            corners: Vec::with_capacity(corners),
        }
    }

    pub(super) fn of_triangles(triangles: Vec<[u32; 3]>) -> Self {
        Self {
            starts: Vec::new(),
            corners: triangles.into_flattened(),
        }
    }

    pub(super) fn push(&mut self, corners: &[u32]) {
        if self.starts.is_empty() && corners.len() != 3 {
            self.starts
                .extend((0..=self.corners.len() as u32).step_by(3));
        }
        self.corners.extend_from_slice(corners);
        if !self.starts.is_empty() {
            self.starts.push(self.corners.len() as u32);
        }
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        if self.starts.is_empty() {
            self.corners.len() / 3
        } else {
            self.starts.len() - 1
        }
    }

    #[inline]
    pub(super) fn range(&self, i: usize) -> Range<usize> {
        if self.starts.is_empty() {
            3 * i..3 * i + 3
        } else {
            self.starts[i] as usize..self.starts[i + 1] as usize
        }
    }

    #[inline]
    pub(super) fn polygon(&self, i: usize) -> &[u32] {
        &self.corners[self.range(i)]
    }
}

/// The facets, each anticlockwise seen from outside: the slots of the mesh whose triangles are not facets by themselves,
/// and the facets of which they are parts.
///
/// One orientation an edge tells which are which, if nothing is known of the edges.
pub(super) fn facets<K: Kernel3>(
    points: Points<'_, 3>,
    mesh: &TriMesh,
    edges: Edges,
    kernel: &K,
) -> (Marks, Loops) {
    let merger = Merger {
        points,
        mesh,
        kernel,
    };
    let merged = merger.with_coplanar_neighbours(edges);
    let mut larger = Loops::default();
    if merged.is_empty() {
        return (merged, larger);
    }
    let mut used = vec![false; mesh.slots()];
    // The number of the facet, plus one, whose walk last met a triangle.
    let mut met = vec![0; mesh.slots()];
    for triangle in mesh
        .triangles()
        .filter(|triangle| merged.contains(triangle.0))
    {
        let slot = triangle.0 as usize;
        if !used[slot] && !merger.is_flat(triangle) {
            used[slot] = true;
            let walk = larger.len() as u32 + 1;
            larger.push(&merger.facet_around(triangle, walk, &mut met, &mut used));
        }
    }
    (merged, larger)
}

struct Merger<'a, K> {
    points: Points<'a, 3>,
    mesh: &'a TriMesh,
    kernel: &'a K,
}

impl<K: Kernel3> Merger<'_, K> {
    /// The slots of the triangles that are coplanar with a neighbour.
    fn with_coplanar_neighbours(&self, edges: Edges) -> Marks {
        let mut found = Marks::default();
        // Which edges are to be asked about is as good as random: chosen without a branch, in batches.
        let mut batch = [(TriangleId(0), SideId(0)); 256];
        let mut filled = 0;
        for triangle in self.mesh.triangles() {
            match edges {
                // Each edge once, from the triangle with the greater number.
                Edges::Unknown => {
                    for twin in self.mesh.twins(triangle) {
                        batch[filled] = (triangle, twin);
                        filled += usize::from(twin.triangle() < triangle);
                    }
                }
                // In a cone, the side after the rim is that of the next triangle, its last; a triangle made later has its first there.
                Edges::BentAtRims => {
                    let twin = self.mesh.twin(triangle.side(1));
                    batch[filled] = (triangle, twin);
                    filled += usize::from(twin.corner() == 2);
                }
            }
            if filled + 3 > batch.len() {
                self.note_coplanar(&batch[..filled], &mut found);
                filled = 0;
            }
        }
        self.note_coplanar(&batch[..filled], &mut found);
        found
    }

    /// Adds the triangles that are coplanar with the one at the other end of a pair.
    fn note_coplanar(&self, pairs: &[(TriangleId, SideId)], found: &mut Marks) {
        for &(triangle, twin) in pairs {
            if self.is_on_plane(self.mesh.corners(triangle), self.mesh.apex(twin)) {
                for triangle in [triangle, twin.triangle()] {
                    found.insert(triangle.0, self.mesh.slots());
                }
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
