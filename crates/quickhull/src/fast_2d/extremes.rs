//! The points furthest along some axes, in one pass without a branch.
//!
//! A running maximum in vector lanes knows the greatest value but not whose it is. So the index of a point replaces
//! the last 16 bits of its value: the order of values that agree to 2⁻³⁶ may change, which a corner of a polygon
//! of witnesses can bear, and the index comes with the maximum.

use geometry_core::Point2;

/// How many axes are looked at side by side: their extremes fit the registers of every machine.
pub(super) const AXES: usize = 4;

/// The most points that indices of 16 bits tell apart.
pub(super) const MOST_POINTS: usize = 1 << 16;

const INDEX: u64 = MOST_POINTS as u64 - 1;
const LANES: usize = 4;

/// The indices of the points with about the greatest and the least value along each axis.
pub(super) struct Extremes {
    pub(super) most: [usize; AXES],
    pub(super) least: [usize; AXES],
}

impl Extremes {
    /// Of the first [`MOST_POINTS`] points; none if there are no points. Points whose values are not finite are passed
    /// over while there are others.
    pub(super) fn along(points: &[Point2], axes: &[Point2; AXES]) -> Option<Self> {
        let points = &points[..points.len().min(MOST_POINTS)];
        let last = points.len().checked_sub(1)?;
        let (most, least) = pulp::Arch::new().dispatch(Pass { points, axes });
        let index = |value: f64| ((value.to_bits() & INDEX) as usize).min(last);
        Some(Self {
            most: most.map(|lanes| index(lanes.into_iter().fold(f64::NEG_INFINITY, greater))),
            least: least.map(|lanes| index(lanes.into_iter().fold(f64::INFINITY, less))),
        })
    }
}

type Running = [[f64; LANES]; AXES];

struct Pass<'a> {
    points: &'a [Point2],
    axes: &'a [Point2; AXES],
}

impl pulp::NullaryFnOnce for Pass<'_> {
    type Output = (Running, Running);

    #[inline(always)]
    fn call(self) -> Self::Output {
        let mut most = [[f64::NEG_INFINITY; LANES]; AXES];
        let mut least = [[f64::INFINITY; LANES]; AXES];
        let mut index: [u64; LANES] = std::array::from_fn(|lane| lane as u64);
        let (fours, rest) = self.points.as_chunks::<LANES>();
        for four in fours {
            take(four, &index, self.axes, &mut most, &mut least);
            index = index.map(|index| index + LANES as u64);
        }
        if let Some(&last) = rest.last() {
            // Copies of the last point fill up; their indices are those of no point and are brought back to the last.
            let mut four = [last; LANES];
            four[..rest.len()].copy_from_slice(rest);
            take(&four, &index, self.axes, &mut most, &mut least);
        }
        (most, least)
    }
}

#[inline(always)]
fn take(
    points: &[Point2; LANES],
    index: &[u64; LANES],
    axes: &[Point2; AXES],
    most: &mut Running,
    least: &mut Running,
) {
    for (axis, [dx, dy]) in axes.iter().enumerate() {
        for lane in 0..LANES {
            let [x, y] = points[lane];
            let bits = (dx * x + dy * y).to_bits() & !INDEX | index[lane];
            let value = f64::from_bits(bits);
            most[axis][lane] = greater(most[axis][lane], value);
            least[axis][lane] = less(least[axis][lane], value);
        }
    }
}

/// The greater value; the first if the second is NaN.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The lesser value; the first if the second is NaN.
#[inline(always)]
fn less(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}
