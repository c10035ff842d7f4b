//! Points uniform on the unit square.
//!
//! ```text
//!    1 +-----------+
//!      | ·   ·   · |         each coordinate uniform on [0, 1), independent of the other
//!      |   ·   ·   |         about (8/3) ln n points are extreme
//!      | ·    ·  · |
//!    0 +-----------+
//!      0           1
//! ```

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "square",
    summary: "uniform on the unit square",
    parameters: &[],
    source: "Green and Silverman 1979, Fig. 1 and Table 1, random data",
    generate: Generate::Plane(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| [draw.unit(), draw.unit()]).collect())
    }),
};
