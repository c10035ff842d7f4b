//! A prism over a regular polygon.
//!
//! ```text
//!       .-·----·-.
//!      ·'--·-----··          rings of ceil(n/levels) corners at equal angles, one over the other,
//!      |   |     | |         at heights 0, 1, ..., levels - 1; the last ring may be short
//!      |.-·|----·|.|
//!      ·'--·-----·'
//! ```
//!
//! Corners of all rings have the same x and y to the last bit, so the walls are exactly rectangles, and with more
//! than two levels every ring between the first and the last lies on upright edges. Extreme are the corners of the
//! first and the last ring.

use super::circle::at_turn;
use crate::catalogue::{Entry, Generate, Kind, Parameter};

pub(crate) const ENTRY: Entry = Entry {
    name: "prism",
    summary: "a prism over a regular polygon: exactly coplanar and collinear points",
    parameters: &[LEVELS],
    source: "a standard degenerate case",
    generate: Generate::Space(|spec, n, _| {
        let corners = n.div_ceil(spec.integer("levels") as usize).max(1);
        let point = |index: usize| {
            let [x, y] = at_turn((index % corners) as f64 / corners as f64);
            [x, y, (index / corners) as f64]
        };
        Ok((0..n).map(point).collect())
    }),
};

pub(crate) const LEVELS: Parameter = Parameter {
    name: "levels",
    default: "2",
    meaning: "how many rings there are, one over the other",
    kind: Kind::Integer {
        min: 1,
        max: u32::MAX as i64,
    },
};
