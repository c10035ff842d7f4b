//! Points uniform on the unit cube.
//!
//! ```text
//!        +-----------+
//!       / ·   ·   · /|       each coordinate uniform on [0, 1), independent of the others
//!    1 +-----------+ |       about (3/2) ln² n points are extreme
//!      | ·   ·   · |·|
//!      |   ·   ·   | +
//!      | ·    ·  · |/
//!    0 +-----------+
//!      0           1
//! ```

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "cube",
    summary: "uniform on the unit cube",
    parameters: &[],
    source: "the random set of Day 1990, and of rbox",
    generate: Generate::Space(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| [(); 3].map(|()| draw.unit())).collect())
    }),
};
