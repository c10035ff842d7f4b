//! A polygon of input points, and the certificate that a point lies strictly inside it.
//!
//! The first corners are the points furthest along the axes and the diagonals. Then each edge gets a new corner, the point furthest
//! outside it, so the corners double, still run anticlockwise, and follow the shape of the set, however long and
//! slanted. A point is certified if it lies to the left of every edge by more than rounding can account for. Nothing
//! else is asked of the corners: they may be chosen with any error, and the polygon may be flat or fold over itself.
//!
//! # Left of every edge is inside
//!
//! Let p lie strictly to the left of every edge of a closed chain of points. Seen from p, each corner lies
//! anticlockwise of the one before by an angle strictly between 0 and π. If a closed half-plane through p held all
//! corners, their angles in it would lie in [0, π] and, as a step below π cannot lead from there across the other half,
//! grow along the chain for ever; but the chain closes. So no line through p has all corners on one side, and p is an
//! inner point of their convex hull: no corner of the hull of all points and no boundary point either.
//!
//! # The bound
//!
//! Let u = 2⁻⁵³, M the largest magnitude of a coordinate of a corner, 2⁻⁹⁰⁰ ≤ M ≤ 2¹⁰⁰⁰, and P → Q an edge. Its
//! function is T(p) = b (y - Py) + a (x - Px), where (b, a) is (Qx - Px, Py - Qy) times the power of two that brings the
//! larger of the two into [1/2, 1): positive exactly to the left. What is computed is
//!
//! ```text
//!     t = ((a' x + b' y) - c'),   a', b' = a, b rounded,   c' = a' Px + b' Py rounded
//! ```
//!
//! for a point with |x| + |y| < 2 M, a test that is made first and whose own rounding is a factor of 1 + u. The errors,
//! each to first order in u:
//!
//! | cause | at most |
//! |---|---|
//! | a', b': each is off by u, times the differences x - Px, y - Py, whose magnitudes sum to 4 M | 4 u M |
//! | c': two products, u each of magnitudes that sum to 2 M, and a sum of at most 2 M | 4 u M |
//! | a' x + b' y: the same | 4 u M |
//! | the last difference, of at most 4 M | 4 u M |
//!
//! together 16 u M. Terms of second order add less than 2⁻⁴⁰ of that, underflow less than 2⁻¹⁰⁷⁰ (1 + M), which is
//! below u M / 2⁶⁰. So t > 2⁻⁴⁸ M = 32 u M implies T(p) > 0.
//!
//! # What never passes
//!
//! The first test compares 2 M with |x| + |y|, which is infinite or NaN if a coordinate is, or if the sum overflows. The
//! least of all differences is then not positive, whatever the edges say: **a coordinate that is not finite is never
//! inside**, so a set whose every other point was thrown away need not be searched for NaN. No product overflows, as
//! |a'|, |b'| ≤ 1; a sum that does belongs to a point that failed already.

use super::extremes::{AT_A_TIME, furthest, furthest_by_compass};
use super::region::{BLOCK, Block, Region, lesser};
use super::sample::Sample;
use geometry_core::Point2;
use smallvec::SmallVec;

/// 2⁻⁴⁸: bounds the error of an edge's function relative to M.
const ERROR: f64 = 32.0 * (f64::EPSILON / 2.0);

/// The range of M in which the bound holds.
const SMALLEST: f64 = f64::from_bits((1023 - 900) << 52);
const LARGEST: f64 = f64::from_bits((1023 + 1000) << 52);

const GROUP: usize = 4;

/// An edge's function a x + b y - c.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Edge {
    a: f64,
    b: f64,
    c: f64,
}

impl Edge {
    /// The function of from→to, scaled so that |a|, |b| ≤ 1 if no coordinate exceeds [`LARGEST`].
    pub(super) fn through(from: Point2, to: Point2) -> Self {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let exponent = (dx.abs().max(dy.abs()).to_bits() >> 52).max(1);
        let scale = f64::from_bits(2045_u64.saturating_sub(exponent) << 52);
        let (a, b) = (-dy * scale, dx * scale);
        let c = a * from[0] + b * from[1];
        Self { a, b, c }
    }

    #[inline(always)]
    pub(super) fn at(self, [x, y]: Point2) -> f64 {
        self.a * x + self.b * y - self.c
    }
}

/// Corners in anticlockwise order, no two neighbours equal.
#[derive(Clone, Debug)]
pub(super) struct Corners(SmallVec<[Point2; 8]>);

impl Corners {
    /// The points furthest along the axes and the diagonals; none if there are no points.
    pub(super) fn of(sample: Sample<'_>) -> Option<Self> {
        furthest_by_compass(sample).map(Self::distinct)
    }

    /// These corners and, between each two, the point furthest outside their edge.
    pub(super) fn refined(&self, sample: Sample<'_>) -> Self {
        let edges: SmallVec<[Edge; 8]> = self.edges().collect();
        let mut corners = SmallVec::<[Point2; 8]>::new();
        for (corners_of_group, group) in self.0.chunks(AT_A_TIME).zip(edges.chunks(AT_A_TIME)) {
            let mut outward = [[0.0; 2]; AT_A_TIME];
            for (outward, edge) in outward.iter_mut().zip(group) {
                *outward = [-edge.a, -edge.b];
            }
            let apexes = furthest(sample, &outward).unwrap_or_default();
            for ((&corner, edge), apex) in corners_of_group.iter().zip(group).zip(apexes) {
                corners.push(corner);
                if edge.at(apex) < 0.0 {
                    corners.push(apex);
                }
            }
        }
        Self::distinct(corners).without_dents()
    }

    /// Without corners that the polygon turns right at, as far as rounding can tell: a scan from the rightmost one.
    fn without_dents(mut self) -> Self {
        let along_x = |i: &usize, j: &usize| self.0[*i][0].total_cmp(&self.0[*j][0]);
        let rightmost = (0..self.0.len()).max_by(along_x).unwrap_or(0);
        self.0.rotate_left(rightmost);
        let mut convex = SmallVec::<[Point2; 8]>::new();
        for &corner in self.0.iter().chain(self.0.first()) {
            while let [.., a, b] = convex[..]
                && Edge::through(a, b).at(corner) <= 0.0
            {
                convex.pop();
            }
            convex.push(corner);
        }
        Self::distinct(convex)
    }

    pub(super) fn distinct(corners: impl IntoIterator<Item = Point2>) -> Self {
        let mut distinct = SmallVec::<[Point2; 8]>::new();
        distinct.extend(corners);
        distinct.dedup();
        while distinct.len() > 1 && distinct.first() == distinct.last() {
            distinct.pop();
        }
        Self(distinct)
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// How far they are apart along either axis.
    pub(super) fn extents(&self) -> [f64; 2] {
        [0, 1].map(|axis| {
            let along = || self.0.iter().map(|corner| corner[axis]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        })
    }

    pub(super) fn as_slice(&self) -> &[Point2] {
        &self.0
    }

    fn edges(&self) -> impl Iterator<Item = Edge> {
        let next = self.0.iter().cycle().skip(1);
        self.0
            .iter()
            .zip(next)
            .map(|(&from, &to)| Edge::through(from, to))
    }
}

/// Edges, and the bound on the errors of their functions.
#[derive(Debug)]
pub(super) struct Polygon {
    /// In groups that are evaluated together; the last is filled up with copies of the last edge.
    edges: SmallVec<[[Edge; GROUP]; 2]>,
    /// 2 M.
    reach: f64,
    /// [`ERROR`] · M.
    bound: f64,
}

impl Polygon {
    /// The polygon with these corners; none if they are fewer than three or out of the range of the bound.
    pub(super) fn of(corners: &Corners) -> Option<Self> {
        let magnitudes = || corners.0.as_flattened().iter().map(|x| x.abs());
        let most = magnitudes().fold(0.0, f64::max);
        let in_range = most >= SMALLEST && magnitudes().all(|x| x <= LARGEST);
        (in_range && corners.len() >= 3).then(|| Self {
            edges: in_groups(corners.edges()),
            reach: 2.0 * most,
            bound: ERROR * most,
        })
    }

    /// Whether the octagon whose corners are within u M of these lies inside: where a computed function is beyond twice
    /// the bound, the true one at a point so near is positive.
    pub(super) fn contains_about(&self, corners: &[Point2; 8]) -> bool {
        let inside = |edge: &Edge, corner: Point2| edge.at(corner) > 2.0 * self.bound;
        let near = |[x, y]: Point2| x.abs() + y.abs() <= self.reach;
        corners.iter().all(|&corner| {
            near(corner)
                && self
                    .edges
                    .as_flattened()
                    .iter()
                    .all(|edge| inside(edge, corner))
        })
    }

    /// A factor by which the ellipse about the centre with these half axes can be made larger without reaching an edge, but for
    /// roundings of the factor itself; not positive if the centre is not inside.
    pub(super) fn room_for_ellipse(&self, centre: Point2, [level, upright]: [f64; 2]) -> f64 {
        if centre[0].abs() + centre[1].abs() > self.reach {
            return 0.0;
        }
        let room = |edge: &Edge| {
            let (along, across) = (edge.a * level, edge.b * upright);
            (edge.at(centre) - self.bound) / (along * along + across * across).sqrt()
        };
        let edges = self.edges.as_flattened().iter();
        edges.map(room).fold(f64::INFINITY, lesser)
    }

    /// About the largest factor by which the points can be moved away from the centre, as a part of their distance
    /// from it, without leaving the polygon; not positive if the centre is outside.
    pub(super) fn room(&self, centre: Point2, points: &[Point2; 8]) -> f64 {
        let mut room: f64 = 1.0;
        for edge in self.edges.as_flattened() {
            let depth = edge.at(centre) - 4.0 * self.bound;
            for &point in points {
                let loss = edge.at(centre) - edge.at(point);
                if depth < room * loss {
                    room = depth / loss;
                }
            }
        }
        room
    }
}

fn in_groups(edges: impl Iterator<Item = Edge>) -> SmallVec<[[Edge; GROUP]; 2]> {
    let mut groups = SmallVec::new();
    let mut edges = edges.fuse();
    while let Some(first) = edges.next() {
        let mut group = [first; GROUP];
        for place in 1..GROUP {
            group[place] = edges.next().unwrap_or(group[place - 1]);
        }
        groups.push(group);
    }
    groups
}

impl Region for Polygon {
    /// The least of 2 M - |x| - |y| and the edges' functions; NaN if a coordinate is.
    #[inline(always)]
    #[allow(clippy::needless_range_loop)] // three arrays side by side
    fn measure(&self, block: &Block) -> [f64; BLOCK] {
        let mut measures = [0.0; BLOCK];
        for i in 0..BLOCK {
            measures[i] = self.reach - (block.x[i].abs() + block.y[i].abs());
        }
        for edges in &self.edges {
            for i in 0..BLOCK {
                let mut measure = measures[i];
                for edge in edges {
                    measure = lesser(edge.at([block.x[i], block.y[i]]), measure);
                }
                measures[i] = measure;
            }
        }
        measures
    }

    fn bound(&self) -> f64 {
        self.bound
    }
}
