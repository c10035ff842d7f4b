//! The points furthest in some directions, in one pass without a branch.
//!
//! A running maximum in vector lanes knows the greatest value but not whose it is. So the index of a point replaces
//! the last 16 bits of its value: the order of values that agree to 2⁻³⁶ may change, which a corner of a polygon
//! can bear, and the index comes with the maximum.

use super::sample::{LONGEST_PART, Sample};
use geometry_core::Point2;

/// How many directions are looked in at a time: few enough that the maxima stay in registers.
pub(super) const AT_A_TIME: usize = 4;

/// The directions of the axes and the diagonals, anticlockwise from that of x.
const COMPASS: usize = 8;

const INDEX: u64 = LONGEST_PART as u64 - 1;
const LANES: usize = 4;

/// The point furthest in each direction, to within a few units of the 36th bit; none if there are no points. A point whose
/// value is not finite is passed over while there are others.
pub(super) fn furthest(
    sample: Sample<'_>,
    directions: &[Point2; AT_A_TIME],
) -> Option<[Point2; AT_A_TIME]> {
    let values = |[x, y]: Point2| directions.map(|[dx, dy]| dx * x + dy * y);
    extremes(sample, values)
}

/// The same for the eight directions of the axes and the diagonals.
pub(super) fn furthest_by_compass(sample: Sample<'_>) -> Option<[Point2; COMPASS]> {
    extremes(sample, |[x, y]: Point2| {
        let (sum, difference) = (x + y, x - y);
        [x, sum, y, -difference, -x, -sum, -y, difference]
    })
}

fn extremes<const N: usize, V: Fn(Point2) -> [f64; N]>(
    sample: Sample<'_>,
    values: V,
) -> Option<[Point2; N]> {
    let mut furthest = [sample.first()?; N];
    let mut most = [f64::NEG_INFINITY; N];
    sample.in_parts(|points| {
        let values = &values;
        let most_of_part = pulp::Arch::new().dispatch(Pass { points, values });
        for (direction, lanes) in most_of_part.into_iter().enumerate() {
            let value = lanes.into_iter().fold(f64::NEG_INFINITY, greater);
            if value > most[direction] {
                most[direction] = value;
                let index = (value.to_bits() & INDEX) as usize;
                furthest[direction] = points[index.min(points.len() - 1)];
            }
        }
    });
    Some(furthest)
}

struct Pass<'a, V: Fn(Point2) -> [f64; N], const N: usize> {
    points: &'a [Point2],
    values: &'a V,
}

impl<const N: usize, V: Fn(Point2) -> [f64; N]> pulp::NullaryFnOnce for Pass<'_, V, N> {
    type Output = [[f64; LANES]; N];

    #[inline(always)]
    fn call(self) -> Self::Output {
        let mut most = [[f64::NEG_INFINITY; LANES]; N];
        let mut index: [u64; LANES] = std::array::from_fn(|lane| lane as u64);
        let (fours, rest) = self.points.as_chunks::<LANES>();
        for four in fours {
            take(four, &index, self.values, &mut most);
            index = index.map(|index| index + LANES as u64);
        }
        if let Some(&last) = rest.last() {
            // Copies of the last point fill up; indices beyond its own are brought back to it.
            let mut four = [last; LANES];
            four[..rest.len()].copy_from_slice(rest);
            take(&four, &index, self.values, &mut most);
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
