//! Points on the unit sphere.
//!
//! ```text
//!        , · ~ · ,
//!      ·  ·     ·  ·         directions uniform at random
//!     ·     ·       ·
//!      ·  ·    ·   ·         every point is extreme
//!        ' · . · '
//! ```
//!
//! The worst case of methods whose cost grows with the hull. Coordinates are rounded, so the points lie next to
//! the sphere, but the cap of a point is so much higher than a rounding error that all of a million stay extreme.

use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "sphere",
    summary: "on the unit sphere: all extreme",
    parameters: &[],
    source: "the classical worst case of gift wrapping (h = n); the data of Nathan 2015",
    generate: Generate::Space(|_, n, seed| {
        let mut draw = Draw::new(seed);
        Ok((0..n).map(|_| draw.on_sphere()).collect())
    }),
};
