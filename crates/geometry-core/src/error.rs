//! Why a hull could not be given.

use std::fmt;

/// What stands between a slice of points and its hull.
///
/// Degenerate input is never an error: a hull of no points, of one point, of collinear points is a value
/// of [`Hull2`](crate::Hull2).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum HullError {
    /// A coordinate is NaN or infinite.
    NotFinite {
        /// Index of the point in the caller's slice.
        index: usize,
        /// Axis of the coordinate: 0 is x, 1 is y, 2 is z.
        axis: usize,
        /// The coordinate as given.
        value: f64,
    },
    /// More points than `u32` indices can name.
    TooManyPoints {
        /// How many were given.
        count: usize,
    },
    /// The kernel's answers contradict each other, so the method cannot go on. Rounded kernels such as
    /// [`Tolerance`](crate::Tolerance) may cause this; [`Exact`](crate::Exact) never does.
    Contradiction {
        /// What could not be, in a few words.
        what: &'static str,
    },
}

impl fmt::Display for HullError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            HullError::NotFinite { index, axis, value } => {
                let axis = ["x", "y", "z"].get(*axis).copied().unwrap_or("?");
                write!(
                    f,
                    "point {index}: {axis} is {value}; every coordinate must be finite"
                )
            }
            HullError::TooManyPoints { count } => {
                write!(
                    f,
                    "{count} points given; at most {} can be indexed",
                    u32::MAX
                )
            }
            HullError::Contradiction { what } => {
                write!(f, "the kernel's answers contradict each other: {what}")
            }
        }
    }
}

impl std::error::Error for HullError {}
