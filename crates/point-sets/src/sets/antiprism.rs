//! A stack of antiprisms over a regular polygon.
//!
//! ```text
//!       .-·----·-.
//!      ·'--·---·-'·          rings of ceil(n/levels) corners at equal angles, one over the other,
//!      |\ / \ / \/|          at heights 0, 1, ..., levels - 1, every other ring turned by half a step;
//!      |.·---·--·.|          the last ring may be short
//!      '-·-----·--'
//! ```
//!
//! All points are extreme, and with many corners the triangles of the walls are coplanar but for a few last bits.

use super::circle::at_turn;
use super::prism::LEVELS;
use crate::catalogue::{Entry, Generate};

pub(crate) const ENTRY: Entry = Entry {
    name: "antiprism",
    summary: "a stack of antiprisms over a regular polygon: all extreme, nearly coplanar walls",
    parameters: &[LEVELS],
    source: "near degeneracy without chance",
    generate: Generate::Space(|spec, n, _| {
        let corners = n.div_ceil(spec.integer("levels") as usize).max(1);
        let point = |index: usize| {
            let (corner, level) = (index % corners, index / corners);
            let half_steps = 2 * corner + level % 2;
            let [x, y] = at_turn(half_steps as f64 / (2 * corners) as f64);
            [x, y, level as f64]
        };
        Ok((0..n).map(point).collect())
    }),
};
