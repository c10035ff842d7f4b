//! Quickhull on the points left, with the points of each outside set side by side in memory.
//!
//! As in [`quickhull_3d`](crate::quickhull_3d()), with two differences:
//!
//! * The points themselves are moved from set to set, so a partition streams through memory, and the
//!   side of a point comes from the facet's [`Plane`] unless that is unsure.
//! * A point in the plane of a facet counts as *not* outside it, where the other asks a perturbed kernel.
//!
//! # Why a point in the plane may count as inside
//!
//! Let the points be inserted in the order p₁, p₂, …, and let c be a point strictly inside the first tetrahedron. Move pₖ
//! towards c by δₖ, where 0 < δ₁ ≪ δ₂ ≪ …, each far more than all before it, and each point that is never inserted
//! by far more than these. Then no four points are coplanar, and a point that lies in the plane of a facet of inserted points
//! has moved below it. So the answers are those of points in general position, and all that is known of quickhull
//! there holds: the facets that a point sees are one region with one rim, and a point outside the new surface is
//! outside of a new facet. Letting all δ go to 0 gives back the points as they are:
//!
//! 1. The surface is that of a convex polyhedron, the hull of the points inserted, but neighbouring triangles may be coplanar
//!    and a corner need not be extreme.
//! 2. No triangle is flat: a point on the line of an edge of the rim is in the plane of the visible facet there, and
//!    does not see it.
//! 3. At the end no point is strictly outside of a facet.
//!
//! [`Hull3::from_known_mesh`](geometry_core::Hull3::from_known_mesh) merges the coplanar triangles and drops the corners that
//! are not extreme. That thousands of points in one plane are not inserted but dropped at once is what makes lattices and the faces
//! of a cube as fast as other points.

use super::plane::{Plane, Side, Span};
use super::sets::{OutsideSets, Site};
use super::simplex;
use crate::horizon::Horizon;
use crate::pending::Pending;
use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::{TriMesh, TriangleId};
use geometry_core::{Edges, Hull3, HullError, Kernel3, Observer, Point3, Points, Step};

/// The hull of points, before its facets are merged.
pub(super) enum Surface {
    /// The points do not span space, and this is their hull.
    Flat(Hull3),
    /// A triangulated surface (invariants 1 to 3), and what is known of its edges.
    Solid(TriMesh, Edges),
}

impl Surface {
    /// The hull of `points`, of which this is the surface.
    pub(super) fn hull<K: Kernel3>(self, points: Points<'_, 3>, kernel: &K) -> Hull3 {
        match self {
            Surface::Flat(hull) => hull,
            Surface::Solid(mesh, edges) => Hull3::from_known_mesh(points, &mesh, edges, kernel),
        }
    }
}

/// Finds the surface of `points`.
///
/// # Errors
///
/// [`HullError::Contradiction`], only with a kernel that is not exact.
pub(super) fn surface<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Surface, HullError> {
    if points.is_empty() {
        return Ok(Surface::Flat(Hull3::Empty));
    }
    let span = Span::of(points.as_slice());
    let spread = simplex::spread(points.as_slice(), kernel, &span);
    let simplex = match spread {
        Some(simplex) => simplex,
        None => match AffineBasis::of(points, kernel).flat_hull(points, kernel) {
            Ok(flat) => return Ok(Surface::Flat(flat)),
            Err(basis) => basis,
        },
    };
    let mut quickhull = Quickhull::of_simplex(points, kernel, observer, span, simplex);
    while let Some((facet, apex)) = quickhull.next_apex() {
        quickhull.add(facet, apex)?;
    }
    Ok(Surface::Solid(quickhull.mesh, quickhull.edges))
}

struct Quickhull<'a, K, O> {
    points: Points<'a, 3>,
    kernel: &'a K,
    observer: &'a mut O,
    span: Span,
    mesh: TriMesh,
    /// The plane of each facet, by facet.
    planes: Vec<Plane>,
    outside: OutsideSets,
    pending: Pending,
    horizon: Horizon,
    /// [`Edges::BentAtRims`] until an apex may have been in the plane of a facet beyond its rim.
    edges: Edges,
    /// The facets made by the step under way.
    made: Vec<TriangleId>,
    /// The points to partition.
    pool: Vec<Site>,
}

impl<'a, K: Kernel3, O: Observer> Quickhull<'a, K, O> {
    fn of_simplex(
        points: Points<'a, 3>,
        kernel: &'a K,
        observer: &'a mut O,
        span: Span,
        simplex: [u32; 4],
    ) -> Self {
        let mesh = TriMesh::tetrahedron(simplex);
        let corners = simplex.map(|id| points[id]);
        let all = points.as_slice().iter().zip(points.ids());
        let others = all.filter(|(at, _)| !corners.contains(at));
        let mut pool = Vec::with_capacity(points.len());
        pool.extend(others.map(|(&at, id)| Site { at, id }));
        let mut quickhull = Self {
            points,
            kernel,
            observer,
            span,
            made: mesh.triangles().collect(),
            mesh,
            planes: Vec::new(),
            outside: OutsideSets::default(),
            pending: Pending::default(),
            horizon: Horizon::default(),
            edges: Edges::BentAtRims,
            pool,
        };
        quickhull.partition();
        quickhull
    }

    /// A facet with a point outside, and the furthest such point.
    fn next_apex(&mut self) -> Option<(TriangleId, Site)> {
        loop {
            let facet = self.pending.next()?;
            let plane = self.planes[facet.0 as usize];
            let apex = self.outside.take_by(facet, |sites| furthest(sites, &plane));
            if let Some(apex) = apex {
                return Some((facet, apex));
            }
        }
    }

    /// Adds `apex`, which is outside `facet`, to the surface.
    fn add(&mut self, facet: TriangleId, apex: Site) -> Result<(), HullError> {
        self.observer.step(|| Step::Apex(apex.id));
        self.find_horizon(facet, apex.at)?;
        self.pool.clear();
        for &facet in &self.horizon.visible {
            let [a, b, c] = self.mesh.corners(facet);
            self.observer.step(|| Step::Drop(a, b, c));
            self.outside.take(facet, &mut self.pool);
            self.mesh.remove(facet);
        }
        self.mesh.close(&self.horizon.rim, apex.id, &mut self.made);
        self.observer.step(|| Step::Insert(apex.id));
        self.partition();
        Ok(())
    }

    fn find_horizon(&mut self, start: TriangleId, p: Point3) -> Result<(), HullError> {
        let (points, kernel, mesh, planes) = (self.points, self.kernel, &self.mesh, &self.planes);
        let edges = &mut self.edges;
        self.horizon.search(mesh, start, |facet| {
            let plane = &planes[facet.0 as usize];
            let height = plane.height(p);
            match plane.side(height) {
                Side::Outside => true,
                Side::Within => {
                    if height == 0.0 {
                        *edges = Edges::Unknown;
                    }
                    false
                }
                Side::Unsure => {
                    let is_outside = is_outside(points, kernel, mesh.corners(facet), &p);
                    if !is_outside {
                        *edges = Edges::Unknown;
                    }
                    is_outside
                }
            }
        })
    }

    /// Gives each point of the pool to the first facet made that it is outside of, and drops the others.
    fn partition(&mut self) {
        let made = std::mem::take(&mut self.made);
        self.planes.resize(self.mesh.slots(), Plane::NONE);
        for &facet in &made {
            let corners = self.mesh.corners(facet);
            let [a, b, c] = corners;
            self.observer.step(|| Step::Facet(a, b, c));
            self.planes[facet.0 as usize] =
                Plane::through(corners.map(|id| self.points[id]), &self.span);
        }
        for &facet in &made {
            if self.pool.is_empty() {
                break;
            }
            self.claim(facet);
        }
        for site in &self.pool {
            self.observer.step(|| Step::Discard(site.id));
        }
        self.made = made;
    }

    /// Moves the points of the pool that are outside `facet` to its outside set.
    ///
    /// The side of a point does not decide a branch: the processor could not foresee it.
    fn claim(&mut self, facet: TriangleId) {
        let corners = self.mesh.corners(facet);
        let plane = self.planes[facet.0 as usize];
        let len = self.pool.len();
        let pool = &mut self.pool[..len];
        let room = &mut self.outside.room(len)[..len];
        let (mut outside, mut rest) = (0, 0);
        for place in 0..len {
            self.observer.step(|| Step::Visit(pool[place].id));
            let height = plane.height(pool[place].at);
            let mut is_out = plane.is_outside(height);
            if plane.is_unsure(height) {
                is_out = is_outside(self.points, self.kernel, corners, &pool[place].at);
            }
            room[outside] = pool[place];
            pool[rest] = pool[place];
            outside += usize::from(is_out);
            rest += usize::from(!is_out);
        }
        self.pool.truncate(rest);
        if outside > 0 {
            self.outside.put(facet, outside);
            let stored = self.outside.stored();
            self.observer.step(|| Step::Storage(stored as u32));
            self.pending.put_off(facet);
        }
    }
}

/// The place of the furthest of some points outside a facet: of those at one height the lexicographically largest, which is
/// more often extreme than the others; of its copies the first, because the others are dropped. Copies are in the order of
/// their indices in every set, as they always go together.
fn furthest(sites: &[Site], plane: &Plane) -> usize {
    let (mut furthest, mut greatest, mut is_tied) = (0, f64::NEG_INFINITY, false);
    for (place, site) in sites.iter().enumerate() {
        let height = plane.height(site.at);
        is_tied |= height == greatest;
        let is_further = height > greatest;
        greatest = if is_further { height } else { greatest };
        furthest = if is_further { place } else { furthest };
    }
    if !is_tied {
        return furthest;
    }
    let as_high = (0..sites.len()).filter(|&place| plane.height(sites[place].at) == greatest);
    as_high.fold(furthest, |best, place| {
        if sites[place].at > sites[best].at {
            place
        } else {
            best
        }
    })
}

/// Whether the kernel finds p outside the facet with these corners. A corner is not, and its copies are common.
#[cold]
#[inline(never)]
fn is_outside<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    corners: [u32; 3],
    p: &Point3,
) -> bool {
    let ([a, b, c], p) = (corners.map(|id| points[id]), *p);
    p != a && p != b && p != c && kernel.orient3(a, b, c, p).is_positive()
}
