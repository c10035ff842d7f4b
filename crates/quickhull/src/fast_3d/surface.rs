//! Quickhull on the points left.
//!
//! As in [`quickhull_3d`](crate::quickhull_3d()), with two differences:
//!
//! * A point is asked about all facets of a new cone at once ([`fan`](super::fan)), and goes to the list of the first that it
//!   is outside of ([`deal`]). Its side comes from rounded heights unless that is unsure.
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

use super::apex::before_furthest;
use super::deal::{Deal, is_outside};
use super::fan::LANES;
use super::lists::{Links, List, NIL};
use super::plane::{Plane, Side, Span};
use super::simplex;
use crate::horizon::{Horizon, NOT_ONE_REGION};
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
    /// The points outside each facet, by facet.
    outside: Vec<List>,
    links: Links,
    pending: Pending,
    horizon: Horizon,
    /// [`Edges::BentAtRims`] until an apex may have been in the plane of a facet beyond its rim.
    edges: Edges,
    arch: pulp::Arch,
}

impl<'a, K: Kernel3, O: Observer> Quickhull<'a, K, O> {
    fn of_simplex(
        points: Points<'a, 3>,
        kernel: &'a K,
        observer: &'a mut O,
        span: Span,
        simplex: [u32; 4],
    ) -> Self {
        let mut quickhull = Self {
            points,
            kernel,
            observer,
            span,
            mesh: TriMesh::tetrahedron(simplex),
            planes: Vec::new(),
            outside: Vec::new(),
            links: Links::of_all(points.len()),
            pending: Pending::default(),
            horizon: Horizon::default(),
            edges: Edges::BentAtRims,
            arch: pulp::Arch::new(),
        };
        quickhull.make_room();
        let [a, b, c, d] = simplex;
        let [base, walls @ ..] = [0, 1, 2, 3].map(TriangleId);
        let links = points.len() as u32;
        quickhull.observer.step(|| Step::Storage(links));
        let others = quickhull.links.first_without(simplex);
        let not_outside_walls = quickhull.deal(others, &walls, d, &[a, b, c, a]);
        let inside = quickhull.deal(not_outside_walls, &[base], b, &[a, c]);
        quickhull.discard(inside);
        quickhull
    }

    /// A facet with a point outside, and the furthest such point, taken off its list.
    fn next_apex(&mut self) -> Option<(TriangleId, u32)> {
        loop {
            let facet = self.pending.next()?;
            let list = &mut self.outside[facet.0 as usize];
            if list.first != NIL {
                let plane = &self.planes[facet.0 as usize];
                let before = before_furthest(&self.links, list.first, self.points, plane);
                return Some((facet, self.links.take_after(before, list)));
            }
        }
    }

    /// Adds `apex`, which is outside `facet`, to the surface.
    fn add(&mut self, facet: TriangleId, apex: u32) -> Result<(), HullError> {
        self.observer.step(|| Step::Apex(apex));
        self.find_horizon(facet, self.points[apex]);
        let mut first = self.take_visible();
        let Horizon { visible, rim, .. } = &mut self.horizon;
        let cone = self.mesh.replace(visible, rim, apex);
        cone.ok_or(NOT_ONE_REGION)?;
        self.observer.step(|| Step::Insert(apex));
        self.make_room();
        // The horizon's vector now holds the cone.
        let cone = std::mem::take(&mut self.horizon.visible);
        let mut rim = [0; LANES + 1];
        for facets in cone.chunks(LANES) {
            for (place, &facet) in facets.iter().enumerate() {
                [rim[place], rim[place + 1], _] = self.mesh.corners(facet);
            }
            first = self.deal(first, facets, apex, &rim[..=facets.len()]);
        }
        self.horizon.visible = cone;
        self.discard(first);
        Ok(())
    }

    fn find_horizon(&mut self, start: TriangleId, p: Point3) {
        let (points, kernel, mesh, planes) = (self.points, self.kernel, &self.mesh, &self.planes);
        let edges = &mut self.edges;
        self.horizon.explore(mesh, start, |facet| {
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
                    let is_outside = is_outside(points, kernel, mesh.corners(facet), p);
                    if !is_outside {
                        *edges = Edges::Unknown;
                    }
                    is_outside
                }
            }
        });
    }

    /// Takes the visible facets off the surface, and the points outside of them from their lists; the first of these.
    fn take_visible(&mut self) -> u32 {
        let (mesh, outside, observer) = (&mut self.mesh, &mut self.outside, &mut self.observer);
        let lists = self.horizon.visible.iter().map(|&facet| {
            let [a, b, c] = mesh.corners(facet);
            observer.step(|| Step::Drop(a, b, c));
            mesh.take_out(facet);
            std::mem::replace(&mut outside[facet.0 as usize], List::EMPTY)
        });
        self.links.joined(lists)
    }

    /// Room for all facets of the mesh.
    fn make_room(&mut self) {
        self.planes.resize(self.mesh.slots(), Plane::NONE);
        self.outside.resize(self.mesh.slots(), List::EMPTY);
    }

    /// Gives the points of the list that begins with `first` to the first of the new `facets` that they are outside of; the first
    /// of the others. The facets are side by side about `apex`, over the edges of the walk `rim`.
    fn deal(&mut self, first: u32, facets: &[TriangleId], apex: u32, rim: &[u32]) -> u32 {
        for &facet in facets {
            let [a, b, c] = self.mesh.corners(facet);
            self.observer.step(|| Step::Facet(a, b, c));
        }
        let mut corners = [self.points[apex]; LANES + 1];
        for (corner, &id) in corners.iter_mut().zip(rim) {
            *corner = self.points[id];
        }
        self.arch.dispatch(Deal {
            first,
            facets,
            apex: self.points[apex],
            rim: &corners,
            points: self.points,
            span: &self.span,
            kernel: self.kernel,
            observer: self.observer,
            mesh: &self.mesh,
            planes: &mut self.planes,
            outside: &mut self.outside,
            links: &mut self.links,
            pending: &mut self.pending,
        })
    }

    /// Tells that the points of a list are not extreme.
    fn discard(&mut self, first: u32) {
        if O::ACTIVE {
            for id in self.links.from(first) {
                self.observer.step(|| Step::Discard(id));
            }
        }
    }
}
