//! Points of the circular normal distribution.
//!
//! ```text
//!            ·
//!       ·   ···   ·          each coordinate standard normal, independent of the other
//!     ·   ·······    ·       the distance r has P(r < t) = 1 - exp(-t²/2)
//!        · ····· ·           about 2 sqrt(2π ln n) points are extreme
//!      ·     ·   ·
//! ```

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "normal",
    summary: "circular normal: two independent standard normal coordinates",
    parameters: &[],
    source: "Green and Silverman 1979, Table 2, column Normal",
    generate: Generate::Plane(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| [draw.normal(), draw.normal()]).collect())
    }),
};
