//! The plane of a facet, and the side of it that a point is on, in plain floating point with a proved bound.
//!
//! Thousands of points are asked about one facet, so everything that depends on the facet alone is computed once: the
//! normal n = (b-a) × (c-a) and one bound on the error of the height n · (p-a), for every p of the set. Then a point
//! costs three differences, three products, two sums and a comparison.
//!
//! # The bound
//!
//! Write ε = 2⁻⁵³, u = b-a, v = c-a, w = p-a, and fl for what is computed. The height is the sum of six products such
//! as u_y v_z w_x. Each goes through at most eight roundings (three differences, one product, one difference of
//! products, one product, two sums), so what is computed is off by at most ((1+ε)⁸ - 1) Σ |u_j v_k w_i| as long as nothing
//! under- or overflows. In terms of the computed magnitudes
//!
//! ```text
//!     m_i = fl(|u_j v_k| + |u_k v_j|)     and     e_i ≥ |fl(p_i - a_i)| for every point p
//! ```
//!
//! the error is at most (8 ε + 100 ε²) Σ m_i e_i, and evaluating that sum, of positive terms, is off by less than 10 ε
//! of itself. So 9 ε · fl(Σ m_i e_i) is a bound. For e_i stands the rounded extent of the set along axis i: rounding is
//! monotone, so no rounded difference exceeds it.
//!
//! *Underflow.* Sums and differences do not underflow. A product does by at most 2⁻¹⁰⁷⁵: four of them in the normal,
//! times |w_i|, and three in the height. 2⁻¹⁰⁰⁰ is added to each m_i and to the sum; times 9 ε, that is more than 2⁻¹⁰⁵⁰.
//!
//! *Overflow.* No partial sum of the height exceeds fl(Σ m_i e_i) by more than rounding. If that is more than a quarter of the
//! largest number, infinite or NaN, the bound is made NaN: then every comparison fails and the question goes to the kernel.
//! (An infinite bound would not do: a height of -∞ is not above -∞.)
//!
//! # Where there is no error
//!
//! Points that lie exactly in the planes of facets (a lattice, the faces of a cube) are never beyond a bound. Two cases
//! make the bound zero:
//!
//! 1. *Small integers*: all coordinates are multiples of a power of two 2^k, and the extents are at most 2¹⁶ of
//!    them, with |k| ≤ 300. Then the m_i are at most 2³³, the products 2⁴⁹ and the height 2⁵¹ units, and all are integers:
//!    nothing is rounded.
//! 2. *Axis-parallel planes*: a, b and c have one coordinate in common. Then the normal is taken to be ± a unit vector, and
//!    the height is a difference of two coordinates, whose sign is right even if it overflows. Which sign the
//!    normal has is that of one minor, if that is certain.

use geometry_core::Point3;

/// 9 · 2⁻⁵³.
const RELATIVE: f64 = 9.0 * (f64::EPSILON / 2.0);

/// 2⁻¹⁰⁰⁰.
const UNDERFLOW: f64 = f64::from_bits((1023 - 1000) << 52);

/// See [`Plane::doubt`].
pub(super) const NO_DOUBT: f64 = -1.0;

/// How far the points of a set are apart along each axis, and whether heights are exact (case 1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) low: Point3,
    pub(super) high: Point3,
    extents: Point3,
    relative: f64,
}

impl Span {
    /// The span of `points`, of which there is at least one.
    pub(super) fn of(points: &[Point3]) -> Self {
        let (low, high) = extremes(points);
        let extents = [0, 1, 2].map(|i| high[i] - low[i]);
        let relative = if are_small_integers(points, low, extents) {
            0.0
        } else {
            RELATIVE
        };
        Self {
            low,
            high,
            extents,
            relative,
        }
    }

    /// The axis along which the points are furthest apart.
    pub(super) fn widest_axis(&self) -> usize {
        (0..3).fold(0, |widest, axis| {
            if self.extents[axis] > self.extents[widest] {
                axis
            } else {
                widest
            }
        })
    }
}

/// The least and the greatest coordinates along each axis.
fn extremes(points: &[Point3]) -> (Point3, Point3) {
    // Four points side by side, so that the compiler finds whole vectors.
    let (quads, rest) = points.as_flattened().as_chunks::<12>();
    let (mut low, mut high) = ([f64::INFINITY; 12], [f64::NEG_INFINITY; 12]);
    let mut take = |lane: usize, x: f64| {
        low[lane] = if x < low[lane] { x } else { low[lane] };
        high[lane] = if x > high[lane] { x } else { high[lane] };
    };
    for quad in quads {
        (0..12).for_each(|lane| take(lane, quad[lane]));
    }
    rest.iter().enumerate().for_each(|(lane, &x)| take(lane, x));
    let fold = |lanes: [f64; 12], better: fn(f64, f64) -> f64| {
        [0, 1, 2].map(|axis| {
            lanes
                .into_iter()
                .skip(axis)
                .step_by(3)
                .fold(lanes[axis], better)
        })
    };
    (fold(low, f64::min), fold(high, f64::max))
}

/// Case 1 of the header. On ordinary points it looks at one or two.
fn are_small_integers(points: &[Point3], low: Point3, extents: Point3) -> bool {
    let widest = extents.into_iter().fold(0.0, f64::max);
    // 2^k: the widest extent is less than 2^(k + 16).
    let exponent = (widest.to_bits() >> 52) as i64 - 1023 - 15;
    if exponent.abs() > 300 {
        return false;
    }
    let power = |k: i64| f64::from_bits(((1023 + k) as u64) << 52);
    let (unit, per_unit) = (power(exponent), power(-exponent));
    // Offsets from the low corner that are multiples of the unit and come out exactly: differences then do, too.
    let is_multiple = |x: f64, low: f64| {
        let offset = (x - low) * per_unit;
        offset.trunc() == offset && (x - low) + low == x && x - (x - low) == low
    };
    let on_grid = |p: &Point3| (0..3).all(|i| is_multiple(p[i], low[i]));
    unit > 0.0 && points.iter().all(on_grid)
}

/// The plane of a facet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub(super) normal: Point3,
    through: Point3,
    /// No height is off by more than this.
    pub(super) bound: f64,
    /// Heights no greater than this in magnitude are unsure: the bound, or less than nothing where that is zero, as then heights are
    /// exact, zero too.
    pub(super) doubt: f64,
}

/// What a rounded height tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// The point is strictly outside.
    Outside,
    /// The point is inside or in the plane.
    Within,
    /// The height is within the bound of zero: ask the kernel.
    Unsure,
}

impl Plane {
    /// A plane that is sure of nothing.
    pub(super) const NONE: Self = Self {
        normal: [0.0; 3],
        through: [0.0; 3],
        bound: f64::NAN,
        doubt: f64::NAN,
    };

    /// The plane through a, b, c, which run anticlockwise seen from outside, for points of the set with this span.
    // Inlined, because returning seven numbers through memory takes as long as computing them.
    #[inline(always)]
    pub(super) fn through([a, b, c]: [Point3; 3], span: &Span) -> Self {
        let u = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let v = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
        let (yz, zy) = (u[1] * v[2], u[2] * v[1]);
        let (zx, xz) = (u[2] * v[0], u[0] * v[2]);
        let (xy, yx) = (u[0] * v[1], u[1] * v[0]);
        let magnitudes = [
            yz.abs() + zy.abs() + UNDERFLOW,
            zx.abs() + xz.abs() + UNDERFLOW,
            xy.abs() + yx.abs() + UNDERFLOW,
        ];
        let normal = [yz - zy, zx - xz, xy - yx];
        if let Some(normal) = axis_parallel(u, v, normal, magnitudes) {
            return Self {
                normal,
                through: a,
                bound: 0.0,
                doubt: NO_DOUBT,
            };
        }
        let sum = magnitudes[0] * span.extents[0]
            + magnitudes[1] * span.extents[1]
            + magnitudes[2] * span.extents[2]
            + UNDERFLOW;
        let bound = if sum <= f64::MAX / 4.0 {
            span.relative * sum
        } else {
            f64::NAN
        };
        Self {
            normal,
            through: a,
            bound,
            doubt: if bound == 0.0 { NO_DOUBT } else { bound },
        }
    }

    /// The height of `p` over the plane, in a unit of the plane's own, positive outside; rounded.
    #[inline(always)]
    pub(super) fn height(&self, p: Point3) -> f64 {
        self.normal[0] * (p[0] - self.through[0])
            + self.normal[1] * (p[1] - self.through[1])
            + self.normal[2] * (p[2] - self.through[2])
    }

    /// How far it is up along the normal from one point to another, in the same unit; rounded, and off by less than the
    /// bound.
    #[inline(always)]
    pub(super) fn rise(&self, from: Point3, to: Point3) -> f64 {
        self.normal[0] * (to[0] - from[0])
            + self.normal[1] * (to[1] - from[1])
            + self.normal[2] * (to[2] - from[2])
    }

    /// Whether a [`rise`](Self::rise) is certainly one.
    #[inline(always)]
    pub(super) fn is_surely_up(&self, rise: f64) -> bool {
        rise > self.bound
    }

    /// Whether a [`rise`](Self::rise) is certainly none.
    #[inline(always)]
    pub(super) fn is_surely_not_up(&self, rise: f64) -> bool {
        rise <= -self.bound
    }

    /// Of the corners of the box around a set, one that is highest along the normal.
    #[inline(always)]
    pub(super) fn highest_corner(&self, span: &Span) -> Point3 {
        [0, 1, 2].map(|axis| {
            if self.normal[axis] > 0.0 {
                span.high[axis]
            } else {
                span.low[axis]
            }
        })
    }

    /// Whether all points that are not higher along the rounded normal than one of this height are strictly below the plane.
    #[inline(always)]
    pub(super) fn is_surely_beneath(&self, height: f64) -> bool {
        height < -4.0 * self.bound
    }

    /// What this height of a point tells for certain.
    #[inline(always)]
    pub(super) fn side(&self, height: f64) -> Side {
        if self.is_unsure(height) {
            Side::Unsure
        } else if self.is_outside(height) {
            Side::Outside
        } else {
            Side::Within
        }
    }

    /// Whether a point of this height is outside, if that is [sure](Self::is_unsure).
    #[inline(always)]
    pub(super) fn is_outside(&self, height: f64) -> bool {
        height > self.bound
    }

    /// Whether this height leaves it open which side the point is on, as NaN does.
    ///
    /// Not told by comparing with the bound on either side, as compilers make a jump of that which nobody can foresee.
    #[inline(always)]
    pub(super) fn is_unsure(&self, height: f64) -> bool {
        !is_above(height.abs(), self.doubt)
    }
}

/// False if one of them is NaN.
#[inline(always)]
fn is_above(x: f64, y: f64) -> bool {
    x > y
}

/// Case 2 of the header: the unit normal.
#[inline]
fn axis_parallel(u: Point3, v: Point3, normal: Point3, magnitudes: Point3) -> Option<Point3> {
    let axis = (0..3).find(|&i| u[i] == 0.0 && v[i] == 0.0)?;
    let mut unit = [0.0; 3];
    // The minor is a difference of two products of two differences: off by at most 4 roundings, and underflow.
    if normal[axis].abs() > RELATIVE * magnitudes[axis] {
        unit[axis] = normal[axis].signum();
        return Some(unit);
    }
    None
}

#[cfg(test)]
mod tests;
