//! Points of the line y = x, each coordinate moved up by a few units in the last place.
//!
//! ```text
//!                 ·
//!              ·'            (t + i ulp, t + j ulp), t uniform on [0.5, 24),
//!           .·               i and j uniform on 0, ..., ulps
//!        ·'
//!      ·
//! ```
//!
//! No tolerance tells these points from collinear ones, and an orientation computed by rounded arithmetic is
//! often wrong: the neighbourhood pictured by Kettner and others, with many points in it.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "near-collinear",
    summary: "on the line y = x but for a few units in the last place",
    parameters: &[Parameter {
        name: "ulps",
        default: "2",
        meaning: "the most units in the last place by which a coordinate is moved up",
        kind: Kind::Integer { min: 0, max: 1024 },
    }],
    source: "after Kettner, Mehlhorn, Pion, Schirra and Yap 2008, Classroom examples of robustness problems \
             in geometric computations, Computational Geometry 40, 61-78",
    generate: Generate::Plane(|spec, n, seed| {
        let choices = spec.integer("ulps") as u64 + 1;
        let mut draw = Draw::new(seed);
        let points = (0..n).map(|_| {
            let t = 0.5 + 23.5 * draw.unit();
            [(); 2].map(|()| moved_up(t, draw.below(choices)))
        });
        Ok(points.collect())
    }),
};

/// The double so many units in the last place above `value`.
pub(crate) fn moved_up(value: f64, ulps: u64) -> f64 {
    (0..ulps).fold(value, |value, _| value.next_up())
}
