//! Points uniform on the unit disc.
//!
//! ```text
//!        . - ~ - .
//!     .  ·    ·     .        centre (0, 0), radius 1
//!    ·  ·   ·   ·  ·  ,      the distance r of a point has P(r < t) = t²
//!    '    ·    ·      '      about 3.383 n^(1/3) points are extreme
//!     ' ·   ·   ·   '
//!        ' - . - '
//! ```

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "disc",
    summary: "uniform on the unit disc",
    parameters: &[],
    source: "Green and Silverman 1979, Table 2, column Uniform",
    generate: Generate::Plane(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| draw.in_disc().0).collect())
    }),
};
