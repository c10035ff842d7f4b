//! Points of a parabola, exact integers from left to right.
//!
//! ```text
//!                   ·
//!                            (i, i²) for i = 0, 1, ..., n - 1
//!               ·
//!          ·                 every point is extreme, exactly
//!      ·  ·
//! ```
//!
//! The reduction that shows that a hull is as hard as sorting. Use `shuffled:of=parabola` to take the order
//! away.

use crate::catalogue::{Entry, Generate};
use crate::error::SpecError;

pub(crate) const ENTRY: Entry = Entry {
    name: "parabola",
    summary: "on a parabola, exact integers from left to right: all extreme",
    parameters: &[],
    source: "the reduction from sorting (Shamos 1978, Computational Geometry, thesis, Yale University)",
    generate: Generate::Plane(|spec, n, _| {
        if n > LIMIT {
            return Err(SpecError::TooMany {
                set: spec.name(),
                limit: LIMIT,
                asked: n,
                reason: "larger squares are not exact in double precision",
            });
        }
        Ok((0..n).map(|i| i as f64).map(|x| [x, x * x]).collect())
    }),
};

/// 94,906,265² is the largest square up to 2⁵³.
const LIMIT: usize = 94_906_266;
