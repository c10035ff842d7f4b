//! Joins the hulls of two sets that a plane separates.
//!
//! **Essence.**
//!
//! 1. Keep the facets of either hull that have all of the other strictly below them ([`facets_above`]).
//! 2. The corners of the other facets are few, those along the seam. Find their hull by itself.
//! 3. Put the part of that hull that lies beyond the rims of what is kept in the place of what is not.
//!
//! ```text
//!       kept of one |  not   |   not   | kept of the other
//!     --.--.--.--.--.--.--.--.         .--.--.--.--.--.--
//!                   |        \ .     . /        |
//!     --.--.--.--.--.---.----.---.---.----.-----.--.--.--
//!                   |  from the hull of these   |
//!                 rim                          rim
//! ```
//!
//! **Why that is the hull of both.** Kept facets have no point above them, in either set, so they are on the hull H of both. Let F be
//! another facet of H, of which no triangle is kept. A corner v of F belongs to one of the sets, is extreme in it, and at least one of the
//! triangles around v in the hull of its set is not kept: else all of H around v would be kept, and F with it. So v is among
//! the corners of step 2, and as this goes for all corners of F, and no point is above F, it is a facet of the hull of those,
//! too. The rims are chains of edges of H, and of that hull, and divide both.
//!
//! **Coplanar triangles.** Some triangles of a facet may be kept and others not, where rounding leaves it open. If
//! the hull of step 2 has all sides of the rims, what lies beyond them is the same all the same: a facet of H is divided
//! by the rim in it. If it has not, as it may divide the facet into other triangles, there is no seam, and the caller is told so.

use super::below::{Stars, facets_above};
use super::left::Left;
use super::plane::{Plane, Span};
use super::surface::{Surface, surface};
use geometry_core::mesh::{SideId, TriMesh, TriangleId};
use geometry_core::{Edges, HullError, Kernel3, Points, Silent};

/// A surface, what is known of its edges, and where its points begin among those of both.
pub(super) struct Shell<'a> {
    pub(super) left: &'a Left,
    pub(super) mesh: &'a TriMesh,
    pub(super) edges: Edges,
    pub(super) first: u32,
}

const NONE: u32 = u32::MAX;

/// The surface of the hull of both, and what is known of its edges, with corners numbered as in `all`, the points of both one
/// behind the other; none if they could not be joined this way.
///
/// # Errors
///
/// [`HullError::Contradiction`], only with a kernel that is not exact.
pub(super) fn joined<K: Kernel3>(
    [near, far]: [Shell; 2],
    all: &Left,
    kernel: &K,
) -> Result<Option<(TriMesh, Edges)>, HullError> {
    let span = Span::of(&all.points);
    let (of_near, of_far) = rayon::join(
        || Stars::of(near.mesh, near.left.points.len()),
        || Stars::of(far.mesh, far.left.points.len()),
    );
    let (near_kept, far_kept) = rayon::join(
        || near.facets_above(&far, &of_far, &span),
        || far.facets_above(&near, &of_near, &span),
    );
    let kept = [(&near, &*near_kept), (&far, &*far_kept)];
    let ids = corners_of_others(kept, all.points.len());
    let points: Vec<_> = ids.iter().map(|&id| all.points[id as usize]).collect();
    let belt = surface(Points::new(&points)?, kernel, &mut Silent)?;
    let Surface::Solid(mut belt, edges) = belt else {
        return Ok(None);
    };
    belt.renumber(|id| ids[id as usize]);
    let mut seam = Seam::new(near.mesh.clone(), &belt, all.points.len());
    if !(seam.keep(&near_kept) && seam.take_over(&far, &far_kept)) {
        return Ok(None);
    }
    seam.fill();
    if !seam.is_closed() {
        return Ok(None);
    }
    let is_bent = [near.edges, far.edges, edges] == [Edges::BentAtRims; 3]
        && seam.is_bent_at_rims(Points::new(&all.points)?, kernel);
    let edges = if is_bent {
        Edges::BentAtRims
    } else {
        Edges::Unknown
    };
    Ok(Some((seam.whole, edges)))
}

impl Shell<'_> {
    fn facets_above(&self, other: &Shell, stars: &Stars, span: &Span) -> Vec<bool> {
        let points = &self.left.points;
        let plane = |facet| {
            let corners = self.mesh.corners(facet).map(|id| points[id as usize]);
            Plane::through(corners, span)
        };
        facets_above(self.mesh, plane, &other.left.points, stars)
    }
}

/// The corners of the facets that are not kept, numbered as among the `count` points of both.
fn corners_of_others(kept: [(&Shell, &[bool]); 2], count: usize) -> Vec<u32> {
    let mut is_among = vec![false; count];
    let mut ids = Vec::new();
    for (shell, kept) in kept {
        for facet in shell.mesh.triangles().filter(|t| !kept[t.0 as usize]) {
            for corner in shell.mesh.corners(facet) {
                let id = shell.first + corner;
                if !std::mem::replace(&mut is_among[id as usize], true) {
                    ids.push(id);
                }
            }
        }
    }
    ids
}

/// The surface under construction.
struct Seam<'a> {
    whole: TriMesh,
    belt: &'a TriMesh,
    stars: Stars<'a>,
    /// For each triangle of the belt, its number in the whole, or [`NONE`].
    placed: Vec<u32>,
    /// For each side of the belt, the side of a kept facet to which it is to be linked, or [`NONE`].
    rims: Vec<u32>,
    /// Triangles of the belt that are placed, whose neighbours are not yet.
    to_visit: Vec<TriangleId>,
    /// Corners are numbers below this.
    count: usize,
}

impl<'a> Seam<'a> {
    /// To be made of the first surface.
    fn new(whole: TriMesh, belt: &'a TriMesh, count: usize) -> Self {
        Self {
            whole,
            belt,
            stars: Stars::of(belt, count),
            placed: vec![NONE; belt.slots()],
            rims: vec![NONE; 4 * belt.slots()],
            to_visit: Vec::new(),
            count,
        }
    }

    /// Removes the facets of the first surface that are not kept; whether the belt has all sides of their rims.
    fn keep(&mut self, kept: &[bool]) -> bool {
        let others: Vec<TriangleId> = {
            let facets = self.whole.triangles();
            facets.filter(|t| !kept[t.0 as usize]).collect()
        };
        let mut rim = Vec::new();
        for &facet in &others {
            let twins = self.whole.twins(facet).into_iter();
            rim.extend(twins.filter(|side| kept[side.triangle().0 as usize]));
            self.whole.remove(facet);
        }
        rim.into_iter().all(|side| self.meet(side))
    }

    /// Takes over the facets of the other surface that are kept; whether the belt has all sides of their rims.
    fn take_over(&mut self, shell: &Shell, kept: &[bool]) -> bool {
        let mut numbers = vec![NONE; shell.mesh.slots()];
        let facets = || shell.mesh.triangles().filter(|t| kept[t.0 as usize]);
        for facet in facets() {
            let corners = shell.mesh.corners(facet).map(|id| shell.first + id);
            numbers[facet.0 as usize] = self.whole.add(corners).0;
        }
        for facet in facets() {
            let number = TriangleId(numbers[facet.0 as usize]);
            for (side, twin) in number.sides().into_iter().zip(shell.mesh.twins(facet)) {
                let neighbour = TriangleId(numbers[twin.triangle().0 as usize]);
                if neighbour.0 != NONE {
                    self.whole.link(side, neighbour.side(twin.corner()));
                } else if !self.meet(side) {
                    return false;
                }
            }
        }
        true
    }

    /// Finds the side of the belt that is the twin of `side`, on a rim.
    fn meet(&mut self, side: SideId) -> bool {
        let [from, to] = [self.whole.target(side), self.whole.origin(side)];
        let twin = self.stars.sides(from).find(|&s| self.belt.target(s) == to);
        let Some(twin) = twin else {
            return false;
        };
        self.rims[twin.0 as usize] = side.0;
        self.place(twin.triangle());
        true
    }

    fn place(&mut self, triangle: TriangleId) {
        let slot = triangle.0 as usize;
        if self.placed[slot] == NONE {
            self.placed[slot] = self.whole.add(self.belt.corners(triangle)).0;
            self.to_visit.push(triangle);
        }
    }

    /// Places what lies beyond the rims.
    fn fill(&mut self) {
        while let Some(triangle) = self.to_visit.pop() {
            let number = TriangleId(self.placed[triangle.0 as usize]);
            for corner in 0..3 {
                let [here, side] = [number, triangle].map(|t| t.side(corner));
                let rim = self.rims[side.0 as usize];
                if rim != NONE {
                    self.whole.link(here, SideId(rim));
                    continue;
                }
                let twin = self.belt.twin(side);
                self.place(twin.triangle());
                let neighbour = TriangleId(self.placed[twin.triangle().0 as usize]);
                self.whole.link(here, neighbour.side(twin.corner()));
            }
        }
    }

    /// Whether no two triangles beside a rim are coplanar.
    fn is_bent_at_rims<K: Kernel3>(&self, points: Points<'_, 3>, kernel: &K) -> bool {
        let belt = (0..).map(SideId).zip(&self.rims);
        let mut rims = belt.filter(|&(_, &rim)| rim != NONE);
        rims.all(|(side, &rim)| {
            let corners = self.whole.corners(SideId(rim).triangle());
            let [a, b, c] = corners.map(|id| points[id]);
            !kernel
                .orient3(points[self.belt.apex(side)], a, b, c)
                .is_zero()
        })
    }

    /// Whether this is one surface without a handle, by Euler's formula.
    fn is_closed(&self) -> bool {
        let mut is_corner = vec![false; self.count];
        let mut vertices = 0;
        for triangle in self.whole.triangles() {
            for corner in self.whole.corners(triangle) {
                vertices += usize::from(!std::mem::replace(&mut is_corner[corner as usize], true));
            }
        }
        self.whole.len() + 4 == 2 * vertices
    }
}
