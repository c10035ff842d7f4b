//! The validated view of the caller's points.

use crate::error::HullError;
use std::ops::Index;

/// A point of the plane: x to the right, y up.
pub type Point2 = [f64; 2];

/// A point of space.
pub type Point3 = [f64; 3];

/// A slice of points whose coordinates are known to be finite and whose indices fit `u32`.
///
/// Made once at the door, so that no algorithm has a branch for NaN. Nothing is copied.
///
/// ```
/// use geometry_core::{HullError, Points};
/// let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
/// let points = Points::new(&square)?;
/// assert_eq!(points.len(), 4);
/// assert_eq!(points[2], [1.0, 1.0]);
///
/// let error = Points::new(&[[0.0, 0.0], [1.0, f64::NAN]]).unwrap_err();
/// assert!(matches!(error, HullError::NotFinite { index: 1, axis: 1, .. }));
/// # Ok::<(), HullError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Points<'a, const D: usize> {
    slice: &'a [[f64; D]],
}

impl<'a, const D: usize> Points<'a, D> {
    /// Validates `slice`: every coordinate finite, fewer than 2³² points.
    ///
    /// # Errors
    ///
    /// [`HullError::NotFinite`] names the first offending index and axis; [`HullError::TooManyPoints`]
    /// the count.
    ///
    /// # Cost
    ///
    /// One pass, no allocation.
    pub fn new(slice: &'a [[f64; D]]) -> Result<Self, HullError> {
        if u32::try_from(slice.len()).is_err() {
            return Err(HullError::TooManyPoints { count: slice.len() });
        }
        for (number, block) in slice.chunks(Self::BLOCK).enumerate() {
            if !all_finite(block.as_flattened()) {
                return Err(Self::first_not_finite(slice, number * Self::BLOCK));
            }
        }
        Ok(Self { slice })
    }

    /// The view of `slice` when its parts have been validated one by one, perhaps by several threads; `None` unless the
    /// parts, one behind the other, are the slice.
    ///
    /// # Cost
    ///
    /// O(parts).
    ///
    /// ```
    /// use geometry_core::Points;
    /// let points = [[0.0], [1.0], [2.0]];
    /// let parts = [Points::new(&points[..2])?, Points::new(&points[2..])?];
    /// assert!(Points::joined(&points, &parts).is_some());
    /// assert!(Points::joined(&points, &parts[..1]).is_none());
    /// # Ok::<(), geometry_core::HullError>(())
    /// ```
    pub fn joined(slice: &'a [[f64; D]], parts: &[Self]) -> Option<Self> {
        let mut rest = slice;
        for part in parts {
            let (start, end) = rest.split_at_checked(part.len())?;
            if !std::ptr::eq(start, part.slice) {
                return None;
            }
            rest = end;
        }
        let fits = u32::try_from(slice.len()).is_ok();
        (rest.is_empty() && fits).then_some(Self { slice })
    }

    const BLOCK: usize = 256;

    #[cold]
    fn first_not_finite(slice: &[[f64; D]], from: usize) -> HullError {
        for (index, point) in slice.iter().enumerate().skip(from) {
            for (axis, &value) in point.iter().enumerate() {
                if !value.is_finite() {
                    return HullError::NotFinite { index, axis, value };
                }
            }
        }
        unreachable!("called only for a block that holds a coordinate that is not finite")
    }

    /// How many points there are.
    #[inline(always)]
    pub fn len(self) -> usize {
        self.slice.len()
    }

    /// Whether there are none.
    #[inline(always)]
    pub fn is_empty(self) -> bool {
        self.slice.is_empty()
    }

    /// The indices of all points, in order.
    #[inline(always)]
    pub fn ids(self) -> std::ops::Range<u32> {
        0..self.slice.len() as u32
    }

    /// The caller's slice.
    #[inline(always)]
    pub fn as_slice(self) -> &'a [[f64; D]] {
        self.slice
    }
}

/// Whether every coordinate is finite. 0 · x is zero for a finite x and NaN otherwise, and a NaN survives every
/// addition; eight sums side by side leave no chain of dependent additions.
fn all_finite(coordinates: &[f64]) -> bool {
    let (octets, rest) = coordinates.as_chunks::<8>();
    let mut sums = [0.0; 8];
    for octet in octets {
        for (sum, x) in sums.iter_mut().zip(octet) {
            *sum += 0.0 * x;
        }
    }
    !sums.iter().any(|sum| sum.is_nan()) && rest.iter().all(|x| x.is_finite())
}

impl<const D: usize> Index<u32> for Points<'_, D> {
    type Output = [f64; D];
    #[inline(always)]
    fn index(&self, id: u32) -> &[f64; D] {
        &self.slice[id as usize]
    }
}
