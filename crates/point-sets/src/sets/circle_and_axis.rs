//! A circle, and then the axis above it from below, in the worst order to insert them.
//!
//! ```text
//!               · n - 1
//!               ·
//!               · ceil(n/2) + 1        ceil(n/2) points at equal angles on the unit circle of the plane z = 0,
//!           , · · · ,                  then (0, 0, 1), (0, 0, 2), ..., floor(n/2) of them
//!          ·         ·
//!           ' · . · '
//! ```
//!
//! Inserted in this order, every point of the axis sees all the facets of the one before: about n²/4 facets are
//! made to be dropped. `shuffled:of=circle-and-axis` takes O(n log n). Extreme are the circle and the last point.

use super::circle::at_turn;
use crate::catalogue::{Entry, Generate};

pub(crate) const ENTRY: Entry = Entry {
    name: "circle-and-axis",
    summary: "a circle, then points up its axis: the worst order of insertion",
    parameters: &[],
    source: "the quadratic case of insertion in a given order",
    generate: Generate::Space(|_, n, _| {
        let around = n.div_ceil(2);
        let point = |index: usize| {
            if index < around {
                let [x, y] = at_turn(index as f64 / around as f64);
                [x, y, 0.0]
            } else {
                [0.0, 0.0, (index - around + 1) as f64]
            }
        };
        Ok((0..n).map(point).collect())
    }),
};
