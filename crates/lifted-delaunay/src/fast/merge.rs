//! Joining two triangulations that a line separates (Guibas and Stolfi 1985, figure 23).
//!
//! 1. From the two vertices nearest to the line go down both hulls to their lower common tangent: the first edge across.
//! 2. On either end of the edge across, look at the next edge upwards. While the circle through the edge across and that
//!    edge's far end holds the far end of the next but one, the edge is not Delaunay: remove it.
//! 3. Of the two far ends left, the one whose circle does not hold the other makes a triangle with the edge across.
//!    Its new side is the edge across from now on. Repeat from 2 until both ends see nothing above: that is the upper tangent.
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

use super::asking::Asking;
use super::part::{Across, Corner, Part};
use super::rings::{NONE, Rings};
use super::site::{Site, Sited};
use super::tie::is_inside_if_first_is_lowered;
use geometry_core::{InCircle, Kernel2, Point2, Sign};

/// Joins `right` to `left`, or the upper part to the lower.
pub(super) fn merge(
    sites: &[Site],
    rings: &mut Rings<'_>,
    asking: &mut impl Asking,
    [left, right]: [&Part; 2],
    across: Across,
) -> Part {
    let mut joined = left.joined(right, sites, across);
    let [width, height] = joined.sides(sites);
    let kernel = asking.in_box(width, height);
    let mut seam = Seam {
        sites,
        rings,
        kernel,
    };
    let nearest = [left.last[across as usize], right.first[across as usize]];
    let tangent = seam.lower_tangent(nearest);
    let bottom = seam.first_edge(tangent);
    let top = seam.rise(bottom);
    joined.turn(seam.rings.origin(bottom), bottom);
    joined.turn(seam.rings.target(top), top ^ 1);
    asking.done(seam.kernel);
    joined
}

/// Where two triangulations are joined.
struct Seam<'a, 'b, K> {
    sites: &'a [Site],
    rings: &'a mut Rings<'b>,
    kernel: K,
}

/// An edge upwards from one end of the edge across, and its far end.
#[derive(Clone, Copy)]
struct Upward {
    edge: u32,
    vertex: u32,
    at: Point2,
}

/// An edge that leads above the edge across, and the next one, if there is one before the edges across.
#[derive(Clone, Copy)]
struct Candidate {
    first: Upward,
    second: Option<Upward>,
}

/// On which end of the edge across a candidate is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
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
                let back = self.rings.prev(l.out);
                let vertex = self.rings.target(back);
                let below = self.at(vertex);
                if self.kernel.orient(p, q, below).is_negative() {
                    let out = back ^ 1;
                    (l, p) = (Corner { vertex, out }, below);
                    continue;
                }
            }
            if r.out != NONE {
                let vertex = self.rings.target(r.out);
                let below = self.at(vertex);
                if self.kernel.orient(p, q, below).is_negative() {
                    let out = self.rings.next(r.out ^ 1);
                    (r, q) = (Corner { vertex, out }, below);
                    continue;
                }
            }
            return [l, r];
        }
    }

    /// The edge from l to r, in the gaps where they see the outside.
    #[inline(always)]
    fn first_edge(&mut self, [l, r]: [Corner; 2]) -> u32 {
        let e = self.rings.allocate();
        for (half, corner) in [(e, l), (e ^ 1, r)] {
            if corner.out == NONE {
                self.rings.put_alone(half, corner.vertex);
            } else {
                self.rings.put_before(half, corner.out, corner.vertex);
            }
        }
        e
    }

    /// From the lowest edge across to the highest, which is returned.
    #[inline(always)]
    fn rise(&mut self, bottom: u32) -> u32 {
        let mut base = bottom;
        let [mut l, mut r] = [self.rings.origin(base), self.rings.target(base)];
        let [mut p, mut q] = [self.at(l), self.at(r)];
        let [mut left, mut right] = [None; 2];
        loop {
            left = self.candidate(Side::Left, left, base, p, q);
            right = self.candidate(Side::Right, right, base ^ 1, p, q);
            let [s, t] = [left, right].map(|candidate| candidate.map(|found| found.first));
            // The candidate on the end that stays is kept (invariant 3).
            base = match (s, t) {
                (Some(s), t) if t.is_none_or(|t| !self.is_inside(p, q, s.at, t.at)) => {
                    let new = self.rings.allocate();
                    self.rings.put_before(new ^ 1, base ^ 1, r);
                    self.rings.put_after(new, s.edge ^ 1, s.vertex);
                    (l, p, left) = (s.vertex, s.at, None);
                    new
                }
                (_, Some(t)) => {
                    let new = self.rings.allocate();
                    self.rings.put_after(new, base, l);
                    self.rings.put_before(new ^ 1, t.edge ^ 1, t.vertex);
                    (r, q, right) = (t.vertex, t.at, None);
                    new
                }
                _ => return base,
            };
        }
    }

    /// The next edge upwards at the origin of `base`, after those that are not Delaunay are removed; if there is one that
    /// leads above the edge across, from p to q. It is looked for from the one that is `known` to.
    #[inline(always)]
    fn candidate(
        &mut self,
        side: Side,
        known: Option<Candidate>,
        base: u32,
        p: Point2,
        q: Point2,
    ) -> Option<Candidate> {
        let Candidate {
            mut first,
            mut second,
        } = match known {
            Some(candidate) => candidate,
            None => {
                let first = self.upwards(side, base, base)?;
                if !self.kernel.orient(p, q, first.at).is_positive() {
                    return None;
                }
                let second = self.upwards(side, first.edge, base);
                Candidate { first, second }
            }
        };
        while let Some(beyond) = second
            && self.is_inside(p, q, first.at, beyond.at)
        {
            self.rings.remove(first.edge);
            first = beyond;
            second = self.upwards(side, first.edge, base);
        }
        Some(Candidate { first, second })
    }

    /// The edge that follows `edge` around its origin, going up; none if it is the edge across.
    #[inline(always)]
    fn upwards(&self, side: Side, edge: u32, base: u32) -> Option<Upward> {
        let edge = match side {
            Side::Left => self.rings.next(edge),
            Side::Right => self.rings.prev(edge),
        };
        if edge == base {
            return None;
        }
        let vertex = self.rings.target(edge);
        let at = self.at(vertex);
        Some(Upward { edge, vertex, at })
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
