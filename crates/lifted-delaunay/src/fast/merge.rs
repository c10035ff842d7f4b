//! Joining two triangulations that a line separates (Guibas and Stolfi 1985, figure 23; with ghosts, Shewchuk 1996).
//!
//! 1. From the two vertices nearest to the line go down both hulls to their lower common tangent: the first edge across.
//! 2. Above either end of the edge across there is a ghost, between it and the next vertex upwards. While the circle through
//!    the edge across and that vertex holds the apex of the triangle behind, the edge between is not Delaunay: flip it, so that the apex
//!    becomes the next vertex upwards.
//! 3. Of the two vertices left, the one whose circle does not hold the other makes a triangle with the edge across: its ghost becomes
//!    that triangle. Its new side is the edge across from now on. Repeat from 2 until both ends see nothing above: that is the upper
//!    tangent.
//!
//! ```text
//!        s .                 . t
//!           \ '.         .' /
//!            \  l ----- r  /        l r: the edge across; s, t: the candidates
//!             '/         \'
//!      left   /           \   right
//! ```
//!
//! The figure is the same turned by a quarter, for a lower set on the left and an upper one on the right.
//!
//! **Invariants.**
//!
//! 1. Below the edge across, nothing changes any more: every edge there is Delaunay in the union.
//! 2. The circle through the edge across and any point above it that no circle holds is free of points below.
//! 3. If t makes the triangle, a candidate s on the other end remains one, above the new edge across, from l to t. For where s
//!    is not to the left of l t, it lies in the triangle, and so in its circle, unless the segments l s and r t cross; but each
//!    lies in the hull of its own part, and these have no point in common. So it is not looked up and not asked about again.
//! 4. Flips are made between the tangents, on the side of a part that faces the other, and the edge across passes all of that side
//!    on its way up: every ghost there becomes a triangle. The ghosts left are those of the union's hull, and but for the two new
//!    ones no flip has touched them: so those noted with the extremes of a part are where they were.

use super::asking::Asking;
use super::faces::{EDGES_PER_FACE, FACES_PER_VERTEX, Faces, NONE, OUTSIDE, edge_of, next, prev};
use super::part::{Across, Corner, Part};
use super::site::{Site, Sited};
use super::tie::is_inside_if_first_is_lowered;
use geometry_core::{InCircle, Kernel2, Point2, Sign};

/// Joins `right` to `left`, or the upper part to the lower. The sites of the second begin at `middle`.
pub(super) fn merge(
    sites: &[Site],
    faces: &mut Faces<'_>,
    asking: &mut impl Asking,
    [left, right]: [&Part; 2],
    middle: usize,
    across: Across,
) -> Part {
    let mut joined = left.joined(right, sites, across);
    let [width, height] = joined.sides(sites);
    let kernel = asking.in_box(width, height);
    let mut seam = Seam {
        sites,
        faces,
        kernel,
    };
    let nearest = [left.last[across as usize], right.first[across as usize]];
    let tangent = seam.lower_tangent(nearest);
    // The two faces between those of the parts: the ghosts of the lowest edge across and of the highest.
    let bottom = edge_of((FACES_PER_VERTEX * middle) as u32 - 2);
    let top = bottom + EDGES_PER_FACE;
    let ghosts = seam.first_edge(tangent, bottom, top);
    let [l, r] = tangent.map(|corner| corner.vertex);
    let [_, last] = seam.rise([l, r], ghosts, bottom, top);
    joined.turn(l, next(bottom));
    joined.turn(last, next(top));
    asking.done(seam.kernel);
    joined
}

/// Where two triangulations are joined.
struct Seam<'a, 'b, K> {
    sites: &'a [Site],
    faces: &'a mut Faces<'b>,
    kernel: K,
}

/// A vertex above the edge across, the apex of the ghost on one end, and the triangle behind that ghost, if it is one.
#[derive(Clone, Copy)]
struct Candidate {
    vertex: u32,
    at: Point2,
    behind: Option<Behind>,
}

/// The edge from one end of the edge across to a candidate, seen from within its part, and what is behind it.
#[derive(Clone, Copy)]
struct Behind {
    edge: u32,
    apex: u32,
    at: Point2,
}

/// On which end of the edge across a candidate is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

impl Side {
    /// The edge between the ghost and the triangle behind it. The ghost is known by its edge between the end of the edge across
    /// and the outside.
    #[inline(always)]
    fn inner(self, ghost: u32) -> u32 {
        match self {
            Self::Left => prev(ghost),
            Self::Right => next(ghost),
        }
    }

    /// The third edge of the ghost, between the candidate and the outside; likewise of a triangle behind, the one at the end of
    /// the edge across.
    #[inline(always)]
    fn outer(self, ghost: u32) -> u32 {
        match self {
            Self::Left => next(ghost),
            Self::Right => prev(ghost),
        }
    }
}

impl<K: Kernel2 + InCircle> Seam<'_, '_, K> {
    #[inline(always)]
    fn at(&self, vertex: u32) -> Point2 {
        self.sites[vertex as usize].at()
    }

    /// The ends of the lower common tangent. The first two corners see each other: nothing lies between.
    #[inline(always)]
    fn lower_tangent(&self, [mut l, mut r]: [Corner; 2]) -> [Corner; 2] {
        let [mut p, mut q] = [l, r].map(|corner| self.at(corner.vertex));
        loop {
            if l.out != NONE {
                let out = prev(self.faces.twin(l.out));
                let vertex = self.faces.origin(out);
                let below = self.at(vertex);
                if self.kernel.orient(p, q, below).is_negative() {
                    (l, p) = (Corner { vertex, out }, below);
                    continue;
                }
            }
            if r.out != NONE {
                let vertex = self.faces.apex(r.out);
                let below = self.at(vertex);
                if self.kernel.orient(p, q, below).is_negative() {
                    let out = self.faces.twin(next(r.out));
                    (r, q) = (Corner { vertex, out }, below);
                    continue;
                }
            }
            return [l, r];
        }
    }

    /// Puts the ghost of the first edge across between the ghosts around its ends. Returns those above it: the edges from l
    /// to the outside and from there to r.
    ///
    /// Around a vertex that is alone, there are only the ghosts of the lowest edge across and of the highest, which will be `top`.
    #[inline(always)]
    fn first_edge(&mut self, [l, r]: [Corner; 2], bottom: u32, top: u32) -> [u32; 2] {
        let faces = &mut *self.faces;
        faces.set_corners(bottom, [r.vertex, l.vertex, OUTSIDE]);
        let (above_l, below_l) = match l.out {
            NONE => (next(bottom), prev(top)),
            out => (out, faces.twin(out)),
        };
        let (above_r, below_r) = match r.out {
            NONE => (prev(bottom), next(top)),
            out => (faces.twin(out), out),
        };
        faces.glue(next(bottom), below_l);
        faces.glue(prev(bottom), below_r);
        [above_l, above_r]
    }

    /// From the lowest edge across, whose ghost is at `bottom`, to the highest, whose ghost will be at `top`, and whose ends are
    /// returned.
    #[inline(always)]
    fn rise(
        &mut self,
        [mut l, mut r]: [u32; 2],
        [mut left_ghost, mut right_ghost]: [u32; 2],
        bottom: u32,
        top: u32,
    ) -> [u32; 2] {
        // The edge across from r to l, seen from below.
        let mut base = bottom;
        let [mut p, mut q] = [self.at(l), self.at(r)];
        let [mut left, mut right] = [None; 2];
        loop {
            left = self.candidate(Side::Left, left, left_ghost, [l, r], [p, q]);
            right = self.candidate(Side::Right, right, right_ghost, [l, r], [p, q]);
            // The candidate on the end that stays is kept (invariant 3).
            match (left, right) {
                (Some(s), t) if t.is_none_or(|t| !self.is_inside(p, q, s.at, t.at)) => {
                    self.faces.glue(base, left_ghost);
                    base = next(left_ghost);
                    self.faces.set_origin(base, r);
                    left_ghost = self.faces.twin(base);
                    (l, p, left) = (s.vertex, s.at, None);
                }
                (_, Some(t)) => {
                    self.faces.glue(base, right_ghost);
                    self.faces.set_origin(right_ghost, l);
                    base = prev(right_ghost);
                    right_ghost = self.faces.twin(base);
                    (r, q, right) = (t.vertex, t.at, None);
                }
                _ => break,
            }
        }
        self.faces.set_corners(top, [l, r, OUTSIDE]);
        self.faces.glue(top, base);
        self.faces.glue(next(top), right_ghost);
        self.faces.glue(prev(top), left_ghost);
        [l, r]
    }

    /// The next vertex upwards on one end of the edge across, after edges that are not Delaunay are flipped; if there is one
    /// above the edge across. What is `known` need not be looked up.
    #[inline(always)]
    fn candidate(
        &mut self,
        side: Side,
        known: Option<Candidate>,
        ghost: u32,
        ends: [u32; 2],
        [p, q]: [Point2; 2],
    ) -> Option<Candidate> {
        let mut candidate = match known {
            Some(candidate) => candidate,
            None => {
                let vertex = self.faces.apex(ghost);
                let at = self.at(vertex);
                // At a vertex that is alone, the ghost above is that of the first edge across.
                if ends.contains(&vertex) || !self.kernel.orient(p, q, at).is_positive() {
                    return None;
                }
                let behind = self.behind(self.faces.twin(side.inner(ghost)));
                Candidate { vertex, at, behind }
            }
        };
        while let Some(behind) = candidate.behind
            && self.is_inside(p, q, candidate.at, behind.at)
        {
            let beyond = self.flip(side, ghost, behind);
            candidate = Candidate {
                vertex: behind.apex,
                at: behind.at,
                behind: self.behind(beyond),
            };
        }
        Some(candidate)
    }

    /// What is behind this edge, unless it is the outside.
    #[inline(always)]
    fn behind(&self, edge: u32) -> Option<Behind> {
        let apex = self.faces.apex(edge);
        (apex != OUTSIDE).then(|| Behind {
            edge,
            apex,
            at: self.at(apex),
        })
    }

    /// Flips the edge between the ghost and the triangle behind it, which becomes the ghost above. Returns the next edge
    /// around the end of the edge across.
    ///
    /// ```text
    ///     s _____ O               s _____ O
    ///      |\    |                 |    /|
    ///      | \ A |                 | C / |      A: the ghost, C: the triangle behind it,
    ///      |  \  |       =>        |  /  |      l: the end of the edge across,
    ///      | C \ |                 | / A |      s: the candidate, n: the apex, O: the outside;
    ///     n|____\| l              n|/____| l    mirrored on the right
    /// ```
    #[inline(always)]
    fn flip(&mut self, side: Side, ghost: u32, behind: Behind) -> u32 {
        let Behind { edge, apex, .. } = behind;
        let [inner, outer] = [side.inner(ghost), side.outer(ghost)];
        let near = side.inner(edge);
        let faces = &mut *self.faces;
        let [beyond, above] = [faces.twin(near), faces.twin(outer)];
        match side {
            Side::Left => {
                faces.set_origin(inner, apex);
                faces.set_origin(edge, OUTSIDE);
            }
            Side::Right => {
                faces.set_origin(outer, apex);
                faces.set_origin(near, OUTSIDE);
            }
        }
        faces.glue(inner, beyond);
        faces.glue(edge, above);
        faces.glue(near, outer);
        beyond
    }

    /// Whether d lies inside the circle through a, b, c, which are anticlockwise. A tie goes by the rule.
    #[inline(always)]
    fn is_inside(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> bool {
        match self.kernel.in_circle(a, b, c, d) {
            Sign::Positive => true,
            Sign::Negative => false,
            Sign::Zero => is_inside_if_first_is_lowered(&self.kernel, a, b, c, d),
        }
    }
}
