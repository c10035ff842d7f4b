//! Points of the unit sphere, flattened onto the plane z = 0.
//!
//! ```text
//!        , ∴ ~ ∴ ,
//!      ∴  ·     ·  ∴         (x + offset, y + offset) of points uniform on the unit sphere
//!     :     ·       :        the distance r from the centre has P(r < t) = 1 - sqrt(1 - t²):
//!      ∴  ·    ·   ∴         dense at the rim
//!        ' ∴ . ∴ '
//! ```
//!
//! Far from the origin x² + y² has no bits left for where a point is: by 1e7 half of the in-circle questions that
//! lift points to rounded heights are answered wrongly. The offset takes a set there.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "flattened-sphere",
    summary: "on the unit sphere, flattened onto the plane",
    parameters: &[Parameter {
        name: "offset",
        default: "0",
        meaning: "what is added to both coordinates",
        kind: Kind::Number,
    }],
    source: "Nathan 2015, Figure 1, 1024 points (the paper does not say whether on the sphere or in it)",
    generate: Generate::Plane(generate),
};

fn generate(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; 2]>, SpecError> {
    let offset = spec.number("offset");
    if offset.abs() > f64::MAX / 2.0 {
        return Err(SpecError::Conflict {
            set: spec.name(),
            problem: format!("offset={offset} leaves no room for the points; take at most 8e307"),
        });
    }
    let mut draw = Draw::new(seed);
    let points = (0..n).map(|_| {
        let [x, y, _] = draw.on_sphere();
        [x + offset, y + offset]
    });
    Ok(points.collect())
}
