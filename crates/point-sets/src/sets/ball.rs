//! Points uniform on the unit ball.
//!
//! ```text
//!        . - ~ - .
//!     .  ·    ·     .        centre (0, 0, 0), radius 1
//!    ·  ·   ·   ·  ·  ,      the distance r of a point has P(r < t) = t³
//!    '    ·    ·      '      about 4.4771 sqrt n - 5.8 points are extreme
//!     ' ·   ·   ·   '
//!        ' - . - '
//! ```

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "ball",
    summary: "uniform on the unit ball",
    parameters: &[],
    source: "the usual random set of space; the disc of Green and Silverman one dimension up",
    generate: Generate::Space(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| draw.in_ball().0).collect())
    }),
};
