//! Draft.

mod hilbert;
mod region;
mod rounds;
mod walk;

use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::{TriMesh, TriangleId};
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Point3, Points, Sign, Step};
use region::Region;
use walk::Place;

/// Where this file departs from the paper, and why.
pub const DEPARTURES: &[&str] = &[];

/// Draft.
pub fn incremental_brio<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    let simplex = match AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        Ok(flat) => return Ok(flat),
        Err(simplex) => simplex,
    };
    let mut names = Vec::with_capacity(points.len());
    names.extend(simplex);
    names.extend(rounds::order(points, simplex));
    let moved: Vec<Point3> = names.iter().map(|&id| points[id]).collect();
    let moved = Points::new(&moved)?;
    let mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
    let latest = TriangleId(0);
    let mut surface = Surface {
        points: moved,
        names,
        kernel: Perturbed(kernel),
        observer,
        mesh,
        latest,
        region: Region::default(),
    };
    for facet in [0, 1, 2, 3].map(TriangleId) {
        let [a, b, c] = surface.mesh.corners(facet).map(|id| surface.names[id as usize]);
        surface.observer.step(|| Step::Facet(a, b, c));
    }
    for p in moved.ids().skip(4) {
        match surface.locate(p)? {
            Place::Sees(facet) => surface.insert(p, facet)?,
            Place::Behind(facet) => {
                surface.latest = facet;
                surface.name_copy(p, facet);
                let name = surface.names[p as usize];
                surface.observer.step(|| Step::Discard(name));
            }
        }
    }
    Ok(Hull3::from_renumbered_mesh(
        moved,
        &surface.names,
        &surface.mesh,
        kernel,
    ))
}

struct Surface<'a, K, O> {
    points: Points<'a, 3>,
    names: Vec<u32>,
    kernel: K,
    observer: &'a mut O,
    mesh: TriMesh,
    latest: TriangleId,
    region: Region,
}

impl<K: Kernel3, O: Observer> Surface<'_, K, O> {
    /// Whether `p` sees the facet.
    #[inline(always)]
    fn sees(&mut self, p: u32, facet: TriangleId) -> bool {
        let name = &self.names;
        self.observer.step(|| Step::Visit(name[p as usize]));
        let [a, b, c] = self.mesh.corners(facet).map(|id| self.points[id]);
        self.kernel.orient3(self.points[p], b, a, c) == Sign::Positive
    }

    fn name_copy(&mut self, p: u32, facet: TriangleId) {
        for corner in self.mesh.corners(facet) {
            if self
                .kernel
                .lexicographic3(self.points[p], self.points[corner])
                .is_eq()
                && self.names[p as usize] < self.names[corner as usize]
            {
                self.names.swap(p as usize, corner as usize);
            }
        }
    }
}
