//! A polygon of input points, and the certificate that a point lies strictly inside it.
//!
//! A corner is the point furthest in one of k directions, so the corners run anticlockwise. A point is certified if it
//! lies to the left of every edge by more than rounding can account for. Nothing else is asked of the corners: they
//! may be chosen with any error, and the polygon may be flat or fold over itself.
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

use super::extremes::{AXES, Extremes};
use geometry_core::Point2;
use smallvec::SmallVec;

/// 2⁻⁴⁸: bounds the error of an edge's function relative to M.
pub(super) const ERROR: f64 = 32.0 * (f64::EPSILON / 2.0);

/// The range of M in which the bound holds.
const SMALLEST: f64 = f64::from_bits((1023 - 900) << 52);
const LARGEST: f64 = f64::from_bits((1023 + 1000) << 52);

/// How many directions corners are sought in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Directions {
    Eight,
    Sixteen,
    ThirtyTwo,
    SixtyFour,
}

impl Directions {
    pub(super) fn count(self) -> usize {
        match self {
            Directions::Eight => 8,
            Directions::Sixteen => 16,
            Directions::ThirtyTwo => 32,
            Directions::SixtyFour => 64,
        }
    }

    pub(super) fn doubled(self) -> Option<Self> {
        match self {
            Directions::Eight => Some(Directions::Sixteen),
            Directions::Sixteen => Some(Directions::ThirtyTwo),
            Directions::ThirtyTwo => Some(Directions::SixtyFour),
            Directions::SixtyFour => None,
        }
    }

    /// The `place`-th direction anticlockwise from that of the x axis.
    fn direction(self, place: usize) -> Point2 {
        /// A quarter turn in 16 steps. Six digits: a corner may be any point.
        #[rustfmt::skip]
        const QUARTER: [Point2; 16] = [
            [1.000000, 0.000000], [0.995185, 0.098017], [0.980785, 0.195090], [0.956940, 0.290285],
            [0.923880, 0.382683], [0.881921, 0.471397], [0.831470, 0.555570], [0.773010, 0.634393],
            [0.707107, 0.707107], [0.634393, 0.773010], [0.555570, 0.831470], [0.471397, 0.881921],
            [0.382683, 0.923880], [0.290285, 0.956940], [0.195090, 0.980785], [0.098017, 0.995185],
        ];
        let step = place * (64 / self.count());
        let [x, y] = QUARTER[step % 16];
        if step < 16 { [x, y] } else { [-y, x] }
    }
}

/// An edge's function a x + b y - c.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Edge {
    a: f64,
    b: f64,
    c: f64,
}

impl Edge {
    /// The function of from→to, scaled so that |a|, |b| ≤ 1; coordinates of magnitude at most [`LARGEST`].
    fn through(from: Point2, to: Point2) -> Self {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let exponent = (dx.abs().max(dy.abs()).to_bits() >> 52).max(1);
        let scale = f64::from_bits((2045 - exponent) << 52);
        let (a, b) = (-dy * scale, dx * scale);
        let c = a * from[0] + b * from[1];
        Self { a, b, c }
    }
}

/// The edges between the extreme points of a set, and the bound on their errors.
#[derive(Debug)]
pub(super) struct Polygon {
    edges: SmallVec<[Edge; 8]>,
    /// 2 M.
    reach: f64,
    /// [`ERROR`] · M.
    bound: f64,
}

impl Polygon {
    /// The polygon of the points furthest in the directions, of at most 2¹⁶ points; none if it has fewer than three
    /// edges or is out of the range of the bound.
    pub(super) fn around(points: &[Point2], directions: Directions) -> Option<Self> {
        let axes = directions.count() / 2;
        let mut corners = [[0.0; 2]; 64];
        for group in (0..axes).step_by(AXES) {
            let axis = std::array::from_fn(|i| directions.direction(group + i));
            let Extremes { most, least } = Extremes::along(points, &axis)?;
            for i in 0..AXES {
                corners[group + i] = points[most[i]];
                corners[axes + group + i] = points[least[i]];
            }
        }
        Self::with_corners(&corners[..2 * axes])
    }

    /// The polygon with these corners in this order.
    pub(super) fn with_corners(corners: &[Point2]) -> Option<Self> {
        let most =
            corners.as_flattened().iter().fold(
                0.0,
                |most: f64, x| if x.abs() <= most { most } else { x.abs() },
            );
        // False for NaN, too.
        if !(SMALLEST..=LARGEST).contains(&most) {
            return None;
        }
        let next = corners.iter().cycle().skip(1);
        let edges: SmallVec<[Edge; 8]> = corners
            .iter()
            .zip(next)
            .filter(|(from, to)| from != to)
            .map(|(&from, &to)| Edge::through(from, to))
            .collect();
        (edges.len() >= 3).then_some(Self {
            edges,
            reach: 2.0 * most,
            bound: ERROR * most,
        })
    }

    /// The least of an upper bound of 2 M - |x| - |y| and the edges' functions; NaN if a coordinate is.
    ///
    /// In lanes, so that the compiler makes vectors of any width of them.
    #[inline(always)]
    fn least<const LANES: usize>(&self, points: &[Point2; LANES]) -> [f64; LANES] {
        let mut least = points.map(|[x, y]| self.reach - (x.abs() + y.abs()));
        for &Edge { a, b, c } in &self.edges {
            for (least, [x, y]) in least.iter_mut().zip(points) {
                let t = a * x + b * y - c;
                *least = if t < *least { t } else { *least };
            }
        }
        least
    }

    /// Which of the points are not certified to lie inside: bit i for point i.
    #[inline(always)]
    pub(super) fn not_inside(&self, points: &[Point2; 64]) -> u64 {
        let (octets, _) = points.as_chunks::<8>();
        let mut bits = 0;
        for (place, octet) in octets.iter().enumerate() {
            for (lane, least) in self.least(octet).into_iter().enumerate() {
                // NaN is not inside.
                let inside = least > self.bound;
                bits |= u64::from(!inside) << (8 * place + lane);
            }
        }
        bits
    }
}
