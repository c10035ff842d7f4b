//! Joining two triangulations that a line separates.

use super::Site;
use super::part::{Across, Corner, Part};
use super::rings::{NONE, Rings};
use geometry_core::exact::{Boxed, Unit};
use geometry_core::kernel::lexicographic;
use geometry_core::{Exact, InCircle, Kernel2, Point2, Sign};

/// Joins `left` and `right` (or lower and upper).
pub(super) fn merge(
    sites: &[Site],
    rings: &mut Rings<'_>,
    unit: Unit,
    [left, right]: [&Part; 2],
    across: Across,
) -> Part {
    let mut joined = left.joined(right, sites, across);
    let kernel = Boxed::new(joined.extent(sites, 0), joined.extent(sites, 1), unit);
    let mut seam = Seam {
        sites,
        rings,
        kernel,
    };
    let near = [left.last[across as usize], right.first[across as usize]];
    let [l, r] = seam.lower_tangent(near);
    let bottom = seam.first_edge(l, r);
    let top = seam.rise(bottom);
    joined.turn(l.vertex, bottom);
    joined.turn(seam.rings.target(top), top ^ 1);
    joined
}

struct Seam<'a, 'b> {
    sites: &'a [Site],
    rings: &'a mut Rings<'b>,
    kernel: Boxed,
}

impl Seam<'_, '_> {
    #[inline(always)]
    fn at(&self, vertex: u32) -> Point2 {
        self.sites[vertex as usize].at
    }

    /// The ends of the lower common tangent, from corners that see each other.
    fn lower_tangent(&self, [mut l, mut r]: [Corner; 2]) -> [Corner; 2] {
        let [mut p, mut q] = [l, r].map(|corner| self.at(corner.vertex));
        loop {
            if l.out != NONE {
                let back = self.rings.prev(l.out);
                let vertex = self.rings.target(back);
                if self.kernel.orient(p, q, self.at(vertex)).is_negative() {
                    p = self.at(vertex);
                    l = Corner {
                        vertex,
                        out: back ^ 1,
                    };
                    continue;
                }
            }
            if r.out != NONE {
                let vertex = self.rings.target(r.out);
                if self.kernel.orient(p, q, self.at(vertex)).is_negative() {
                    q = self.at(vertex);
                    let out = self.rings.next(r.out ^ 1);
                    r = Corner { vertex, out };
                    continue;
                }
            }
            return [l, r];
        }
    }

    fn first_edge(&mut self, l: Corner, r: Corner) -> u32 {
        let e = self.rings.allocate();
        for (e, end) in [(e, l), (e ^ 1, r)] {
            if end.out == NONE {
                self.rings.put_alone(e, end.vertex);
            } else {
                self.rings.put_before(e, end.out, end.vertex);
            }
        }
        e
    }

    /// From the lowest edge across to the highest, which is returned.
    fn rise(&mut self, bottom: u32) -> u32 {
        let mut base = bottom;
        let (mut l, mut r) = (self.rings.origin(base), self.rings.target(base));
        let (mut p, mut q) = (self.at(l), self.at(r));
        loop {
            let left = self.left_candidate(base, p, q);
            let right = self.right_candidate(base, p, q);
            let take_right = match (left, right) {
                (None, None) => return base,
                (Some(_), None) => false,
                (None, Some(_)) => true,
                (Some((_, _, s)), Some((_, _, t))) => self.is_inside(p, q, s, t),
            };
            let new = self.rings.allocate();
            if take_right {
                let Some((e, vertex, place)) = right else {
                    unreachable!()
                };
                self.rings.put_after(new, base, l);
                self.rings.put_before(new ^ 1, e ^ 1, vertex);
                (r, q) = (vertex, place);
            } else {
                let Some((e, vertex, place)) = left else {
                    unreachable!()
                };
                self.rings.put_before(new ^ 1, base ^ 1, r);
                self.rings.put_after(new, e ^ 1, vertex);
                (l, p) = (vertex, place);
            }
            base = new;
        }
    }

    #[inline(always)]
    fn left_candidate(&mut self, base: u32, p: Point2, q: Point2) -> Option<(u32, u32, Point2)> {
        let mut e = self.rings.next(base);
        let mut vertex = self.rings.target(e);
        let mut place = self.at(vertex);
        if e == base || !self.kernel.orient(p, q, place).is_positive() {
            return None;
        }
        loop {
            let next = self.rings.next(e);
            if next == base {
                break;
            }
            let beyond = self.rings.target(next);
            let there = self.at(beyond);
            if !self.is_inside(p, q, place, there) {
                break;
            }
            self.rings.remove(e);
            (e, vertex, place) = (next, beyond, there);
        }
        Some((e, vertex, place))
    }

    #[inline(always)]
    fn right_candidate(&mut self, base: u32, p: Point2, q: Point2) -> Option<(u32, u32, Point2)> {
        let mut e = self.rings.prev(base ^ 1);
        let mut vertex = self.rings.target(e);
        let mut place = self.at(vertex);
        if e == base ^ 1 || !self.kernel.orient(p, q, place).is_positive() {
            return None;
        }
        loop {
            let next = self.rings.prev(e);
            if next == base ^ 1 {
                break;
            }
            let beyond = self.rings.target(next);
            let there = self.at(beyond);
            if !self.is_inside(p, q, place, there) {
                break;
            }
            self.rings.remove(e);
            (e, vertex, place) = (next, beyond, there);
        }
        Some((e, vertex, place))
    }

    /// Whether d lies inside the circle through a, b, c, anticlockwise; on the circle, whether it would after the first of the four was lowered.
    #[inline(always)]
    fn is_inside(&self, a: Point2, b: Point2, c: Point2, d: Point2) -> bool {
        match self.kernel.in_circle(a, b, c, d) {
            Sign::Positive => true,
            Sign::Negative => false,
            Sign::Zero => is_inside_when_first_is_lowered(a, b, c, d),
        }
    }
}

#[cold]
#[inline(never)]
fn is_inside_when_first_is_lowered(a: Point2, b: Point2, c: Point2, d: Point2) -> bool {
    let first = |p: Point2, others: [Point2; 3]| {
        others.iter().all(|&other| lexicographic(p, other).is_lt())
    };
    if first(d, [a, b, c]) {
        true
    } else if first(a, [b, c, d]) {
        Exact.orient(b, c, d).is_negative()
    } else if first(b, [a, c, d]) {
        Exact.orient(c, a, d).is_negative()
    } else {
        Exact.orient(a, b, d).is_negative()
    }
}
