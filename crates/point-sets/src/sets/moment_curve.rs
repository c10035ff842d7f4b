//! Points of the moment curve.
//!
//! ```text
//!                      ·
//!                            (t, t², t³), t = 0, 1, ..., n - 1 in exact integers,
//!                  ·         or t uniform on [-1, 1) and the powers rounded
//!             ·
//!      · · ·                 every point is extreme
//! ```
//!
//! The cyclic polytope: seen along a direction the curve is smooth, so neighbouring facets are nearly coplanar, and
//! coordinates grow as cubes. Rounded filters give up, and the exact stages work.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "moment-curve",
    summary: "on the curve (t, t², t³): all extreme, in exact integers or rounded",
    parameters: &[Parameter {
        name: "spacing",
        default: "integer",
        meaning: "t = 0, 1, 2, ... in exact integers, or random: uniform on [-1, 1)",
        kind: Kind::Word(&["integer", "random"]),
    }],
    source: "cyclic polytopes (Gale 1963, Neighborly and cyclic polytopes)",
    generate: Generate::Space(generate),
};

fn generate(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; 3]>, SpecError> {
    let point = |t: f64| [t, t * t, t * t * t];
    if spec.word("spacing") == "random" {
        let mut draw = Draw::new(seed);
        return Ok((0..n).map(|_| point(2.0 * draw.unit() - 1.0)).collect());
    }
    if n > LIMIT {
        return Err(SpecError::TooMany {
            set: spec.name(),
            limit: LIMIT,
            asked: n,
            reason: "larger cubes are not exact in double precision; for a larger set use \
                     `moment-curve:spacing=random`",
        });
    }
    Ok((0..n).map(|t| point(t as f64)).collect())
}

/// 208,063³ is the largest cube up to 2⁵³.
const LIMIT: usize = 208_064;
