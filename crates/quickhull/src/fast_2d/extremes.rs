//! The points furthest in some directions, in one pass without a branch.
//!
//! A running maximum in vector lanes knows the greatest value but not whose it is. So the index of a point replaces
//! the last 16 bits of its value: the order of values that agree to 2⁻³⁶ may change, which a corner of a polygon
//! can bear, and the index comes with the maximum.

use geometry_core::Point2;

/// How many directions are looked in at a time: their maxima fit the registers of every machine.
pub(super) const AT_A_TIME: usize = 4;

/// The most points that indices of 16 bits tell apart.
pub(super) const MOST_POINTS: usize = 1 << 16;

const INDEX: u64 = MOST_POINTS as u64 - 1;
const LANES: usize = 4;

/// The first [`MOST_POINTS`] points' furthest in each direction, to within a few units of the 36th bit; none if there
/// are no points. A point whose value is not finite is passed over while there are others.
pub(super) fn furthest(
    points: &[Point2],
    directions: &[Point2; AT_A_TIME],
) -> Option<[Point2; AT_A_TIME]> {
    let points = &points[..points.len().min(MOST_POINTS)];
    let last = points.len().checked_sub(1)?;
    let most = pulp::Arch::new().dispatch(Pass { points, directions });
    Some(most.map(|lanes| {
        let most = lanes.into_iter().fold(f64::NEG_INFINITY, greater);
        points[((most.to_bits() & INDEX) as usize).min(last)]
    }))
}

type Running = [[f64; LANES]; AT_A_TIME];

struct Pass<'a> {
    points: &'a [Point2],
    directions: &'a [Point2; AT_A_TIME],
}

impl pulp::NullaryFnOnce for Pass<'_> {
    type Output = Running;

    #[inline(always)]
    fn call(self) -> Running {
        let mut most = [[f64::NEG_INFINITY; LANES]; AT_A_TIME];
        let mut index: [u64; LANES] = std::array::from_fn(|lane| lane as u64);
        let (fours, rest) = self.points.as_chunks::<LANES>();
        for four in fours {
            take(four, &index, self.directions, &mut most);
            index = index.map(|index| index + LANES as u64);
        }
        if let Some(&last) = rest.last() {
            // Copies of the last point fill up; indices beyond its own are brought back to it.
            let mut four = [last; LANES];
            four[..rest.len()].copy_from_slice(rest);
            take(&four, &index, self.directions, &mut most);
        }
        most
    }
}

#[inline(always)]
fn take(
    points: &[Point2; LANES],
    index: &[u64; LANES],
    directions: &[Point2; AT_A_TIME],
    most: &mut Running,
) {
    for (most, [dx, dy]) in most.iter_mut().zip(directions) {
        for lane in 0..LANES {
            let [x, y] = points[lane];
            let bits = (dx * x + dy * y).to_bits() & !INDEX | index[lane];
            most[lane] = greater(most[lane], f64::from_bits(bits));
        }
    }
}

/// The greater value; the first if the second is NaN.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}
