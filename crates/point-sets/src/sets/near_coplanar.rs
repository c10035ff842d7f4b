//! Points of the plane z = x + y, each coordinate moved up by a few units in the last place.
//!
//! ```text
//!            ·   ·
//!         ·.   .·   ·        (x + i ulp, y + j ulp, x + y + k ulp), x and y uniform on [1, 2),
//!       ·   ·'  .·           i, j and k uniform on 0, ..., ulps
//!     ·  .·   ·
//! ```
//!
//! x + y is exact before anything is moved. No tolerance tells these points from coplanar ones, and a volume
//! computed by rounded arithmetic often has the wrong sign.

use super::near_collinear::moved_up;
use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;

pub(crate) const ENTRY: Entry = Entry {
    name: "near-coplanar",
    summary: "on the plane z = x + y but for a few units in the last place",
    parameters: &[Parameter {
        name: "ulps",
        default: "1",
        meaning: "the most units in the last place by which a coordinate is moved up",
        kind: Kind::Integer { min: 0, max: 1024 },
    }],
    source: "after Kettner, Mehlhorn, Pion, Schirra and Yap 2008, Classroom examples of robustness problems \
             in geometric computations, Computational Geometry 40, 61-78",
    generate: Generate::Space(|spec, n, seed| {
        let choices = spec.integer("ulps") as u64 + 1;
        let mut draw = Draw::new(seed);
        let points = (0..n).map(|_| {
            let [x, y] = [(); 2].map(|()| 1.0 + draw.below(1 << 51) as f64 * STEP);
            [x, y, x + y].map(|coordinate| moved_up(coordinate, draw.below(choices)))
        });
        Ok(points.collect())
    }),
};

/// 2⁻⁵¹, one unit in the last place of a sum between 2 and 4.
const STEP: f64 = 1.0 / (1_u64 << 51) as f64;
