//! Points of the spherical normal distribution.
//!
//! ```text
//!            ·
//!       ·   ···   ·          each coordinate standard normal, independent of the others
//!     ·   ·······    ·       about (4π/sqrt 3) ln n points are extreme, for n beyond all practice
//!        · ····· ·           (50 where the truth is 37 at n = 1000)
//!      ·     ·   ·
//! ```

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "normal3",
    summary: "spherical normal: three independent standard normal coordinates",
    parameters: &[],
    source: "the normal column of Green and Silverman 1979, Table 2, one dimension up",
    generate: Generate::Space(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| [(); 3].map(|()| draw.normal())).collect())
    }),
};
