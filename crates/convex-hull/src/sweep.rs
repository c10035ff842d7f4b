//! The volume swept by a part that moves in a straight line, and the obstacles in it.
//!
//! **Source.** P. Nathan, "Obtaining the convex hull from a set of points using the gift wrapping algorithm", 2015:
//! instead of moving the part in small steps, which may step over an obstacle, test once against the hull of its
//! corners at the start and at the end. No obstacle is missed; one may be reported that passes through a hollow of
//! the part.
//!
//! ```text
//!        start                          end
//!        .-----.------------------.-----.
//!       / part /                 /     /       o   an obstacle between the steps
//!      '-----'-----------o------'-----'
//! ```
//!
//! **Rounding.** The end of a corner, start + by, is not always representable. Rounded to the nearest, it could lie inside
//! the true swept volume, and an obstacle there would be missed. So each coordinate that is rounded is taken twice, as
//! the representable numbers just below and just above, and the corner becomes the corners of the smallest box
//! that holds the true one. The hull then contains the true swept volume, and is equal to it if nothing was rounded.

use geometry_core::hull3::Location;
use geometry_core::{Exact, Hull3, HullError, Point3, Points};

/// The convex volume swept by a part.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    points: Vec<Point3>,
    hull: Hull3,
    is_exact: bool,
}

/// The convex hull of the corners of a part before and after it moves by `by`.
///
/// # Errors
///
/// [`HullError::NotFinite`] if a coordinate of a corner or of `by` is not finite, or a sum overflows. It names the
/// corner by its index in [`Sweep::points`].
///
/// # Cost
///
/// That of one hull of at least 2 n points, at most 9 n if every sum is rounded.
///
/// ```
/// use hullkit::sweep::swept_volume;
/// use hullkit::Location;
/// let cube: Vec<[f64; 3]> = (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from)).collect();
/// let sweep = swept_volume(&cube, [10.0, 5.0, 0.0])?;
/// assert!(sweep.is_exact());
/// assert_eq!(sweep.hull().facets().count(), 8);
/// assert_eq!(sweep.locate([5.5, 3.0, 0.5])?, Location::Inside); // between any two steps, and not missed
/// assert_eq!(sweep.locate([5.5, 5.0, 0.5])?, Location::Outside);
/// # Ok::<(), hullkit::HullError>(())
/// ```
pub fn swept_volume(part: &[Point3], by: [f64; 3]) -> Result<Sweep, HullError> {
    let mut points = part.to_vec();
    let mut is_exact = true;
    for &start in part {
        let enclosures = [0, 1, 2].map(|axis| Enclosure::of_sum(start[axis], by[axis]));
        is_exact &= enclosures.iter().all(Enclosure::is_exact);
        for x in enclosures[0].bounds() {
            for y in enclosures[1].bounds() {
                points.extend(enclosures[2].bounds().map(|z| [x, y, z]));
            }
        }
    }
    let hull = crate::convex_hull_3d(&points)?;
    Ok(Sweep {
        points,
        hull,
        is_exact,
    })
}

impl Sweep {
    /// The corners at the start, in the order given, then those at the end. The indices of the hull refer to these.
    pub fn points(&self) -> &[Point3] {
        &self.points
    }

    /// The hull of [`points`](Self::points).
    pub fn hull(&self) -> &Hull3 {
        &self.hull
    }

    /// Whether every corner at the end is representable, so that the hull is the swept volume and no more.
    pub fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// Where an obstacle lies with regard to the hull, exactly. Only [`Location::Outside`] is out of the way.
    ///
    /// # Errors
    ///
    /// [`HullError::NotFinite`] if a coordinate of the obstacle is not finite.
    ///
    /// # Cost
    ///
    /// One orientation a facet.
    pub fn locate(&self, obstacle: Point3) -> Result<Location, HullError> {
        Points::new(&[obstacle])?;
        let points = Points::new(&self.points)?;
        Ok(self.hull.locate(points, obstacle, &Exact))
    }
}

/// The representable numbers on either side of a sum, or the sum itself twice.
struct Enclosure {
    below: f64,
    above: f64,
}

impl Enclosure {
    fn of_sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        // What was rounded away, exactly (Knuth 1969); zero, NaN or infinite where the sum overflowed.
        let b_share = sum - a;
        let rest = (a - (sum - b_share)) + (b - b_share);
        Self {
            below: if rest < 0.0 { sum.next_down() } else { sum },
            above: if rest > 0.0 { sum.next_up() } else { sum },
        }
    }

    fn is_exact(&self) -> bool {
        self.below == self.above
    }

    /// Both bounds, once if they are equal.
    fn bounds(&self) -> impl Iterator<Item = f64> + use<> {
        let above = (!self.is_exact()).then_some(self.above);
        std::iter::once(self.below).chain(above)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounded_sum_is_enclosed() {
        let tiny = Enclosure::of_sum(1.0, 1e-30);
        assert_eq!((tiny.below, tiny.above), (1.0, 1.0 + f64::EPSILON));
        let third = Enclosure::of_sum(0.1, 0.2);
        assert_eq!(third.above, third.below.next_up());
        for [a, b] in [[0.5, 0.25], [-3.0, 3.0], [1e308, -1e308], [5e-324, 5e-324]] {
            assert!(Enclosure::of_sum(a, b).is_exact(), "{a} + {b}");
        }
    }

    #[test]
    fn rounding_never_lets_an_obstacle_through() {
        let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // The end of the second corner is 1 + 2⁻⁶⁰, which rounds to 1.
        let by = [2.0_f64.powi(-60), 0.0, 0.0];
        let sweep = swept_volume(&corner, by).expect("finite");
        assert!(!sweep.is_exact());
        let beyond = sweep
            .locate([1.0 + f64::EPSILON, 0.0, 0.0])
            .expect("finite");
        assert_eq!(beyond, Location::Boundary);
    }

    #[test]
    fn what_is_not_finite_is_an_error() {
        assert!(swept_volume(&[[1e308; 3]], [1e308; 3]).is_err());
        assert!(swept_volume(&[[0.0; 3]], [f64::NAN, 0.0, 0.0]).is_err());
        let sweep = swept_volume(&[[0.0; 3]], [1.0; 3]).expect("finite");
        assert!(sweep.locate([f64::INFINITY; 3]).is_err());
    }

    #[test]
    fn flat_and_empty_parts_sweep_what_they_sweep() {
        let nothing = swept_volume(&[], [1.0; 3]).expect("finite");
        assert_eq!(nothing.locate([0.0; 3]), Ok(Location::Outside));
        let along = swept_volume(&[[0.0; 3], [1.0; 3]], [1.0; 3]).expect("finite");
        assert_eq!(along.locate([1.5; 3]), Ok(Location::Inside));
        assert_eq!(along.hull().dimension(), Some(1));
    }
}
