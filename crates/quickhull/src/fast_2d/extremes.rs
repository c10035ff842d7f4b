//! The points furthest in some directions, in one pass without a branch.
//!
//! A running maximum in vector lanes knows the greatest value but not whose it is. So the index of a point replaces
//! the last 16 bits of its value: the order of values that agree to 2⁻³⁶ may change, which a corner of a polygon
//! can bear, and the index comes with the maximum.

use geometry_core::Point2;

/// How many directions are looked in at a time: few enough that the maxima stay in registers.
pub(super) const AT_A_TIME: usize = 4;

/// The directions of the axes and the diagonals, anticlockwise from that of x.
const COMPASS: usize = 8;

/// The most points that indices of 16 bits tell apart.
const MOST_POINTS: usize = 1 << 16;

const INDEX: u64 = MOST_POINTS as u64 - 1;
const LANES: usize = 4;

/// The point furthest in each direction among the first [`MOST_POINTS`], to within a few units of the 36th bit; none if
/// there are no points. A point whose value is not finite is passed over while there are others.
pub(super) fn furthest(
    points: &[Point2],
    directions: &[Point2; AT_A_TIME],
) -> Option<[Point2; AT_A_TIME]> {
    let values = |[x, y]: Point2| directions.map(|[dx, dy]| dx * x + dy * y);
    extremes(points, values)
}

/// The same for the eight directions of the axes and the diagonals.
pub(super) fn furthest_by_compass(points: &[Point2]) -> Option<[Point2; COMPASS]> {
    extremes(points, |[x, y]: Point2| {
        let (sum, difference) = (x + y, x - y);
        [x, sum, y, -difference, -x, -sum, -y, difference]
    })
}

fn extremes<const N: usize, V: Fn(Point2) -> [f64; N]>(
    points: &[Point2],
    values: V,
) -> Option<[Point2; N]> {
    let points = &points[..points.len().min(MOST_POINTS)];
    let last = points.len().checked_sub(1)?;
    let most = pulp::Arch::new().dispatch(Pass { points, values });
    Some(most.map(|lanes| {
        let most = lanes.into_iter().fold(f64::NEG_INFINITY, greater);
        points[((most.to_bits() & INDEX) as usize).min(last)]
    }))
}

struct Pass<'a, V: Fn(Point2) -> [f64; N], const N: usize> {
    points: &'a [Point2],
    values: V,
}

impl<const N: usize, V: Fn(Point2) -> [f64; N]> pulp::NullaryFnOnce for Pass<'_, V, N> {
    type Output = [[f64; LANES]; N];

    #[inline(always)]
    fn call(self) -> Self::Output {
        let mut most = [[f64::NEG_INFINITY; LANES]; N];
        let mut index: [u64; LANES] = std::array::from_fn(|lane| lane as u64);
        let (fours, rest) = self.points.as_chunks::<LANES>();
        for four in fours {
            take(four, &index, &self.values, &mut most);
            index = index.map(|index| index + LANES as u64);
        }
        if let Some(&last) = rest.last() {
            // Copies of the last point fill up; indices beyond its own are brought back to it.
            let mut four = [last; LANES];
            four[..rest.len()].copy_from_slice(rest);
            take(&four, &index, &self.values, &mut most);
        }
        most
    }
}

#[inline(always)]
fn take<const N: usize, V: Fn(Point2) -> [f64; N]>(
    points: &[Point2; LANES],
    index: &[u64; LANES],
    values: &V,
    most: &mut [[f64; LANES]; N],
) {
    let values = points.map(values);
    for (direction, most) in most.iter_mut().enumerate() {
        for lane in 0..LANES {
            let bits = values[lane][direction].to_bits() & !INDEX | index[lane];
            most[lane] = greater(most[lane], f64::from_bits(bits));
        }
    }
}

/// The greater value; the first if the second is NaN.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}
