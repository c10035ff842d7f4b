//! Points on the unit circle.
//!
//! ```text
//!        , · ~ · ,
//!      ·           ·         directions uniform at random, or at equal angles anticlockwise from (1, 0)
//!     ·             ·
//!      ·           ·
//!        ' · . · '
//! ```
//!
//! Nearly every point is extreme: the worst case of methods whose cost grows with the hull. Coordinates are
//! rounded, so the points lie next to the circle; of a million, about a dozen are not extreme, which is right.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;
use std::f64::consts::TAU;

pub(crate) const ENTRY: Entry = Entry {
    name: "circle",
    summary: "on the unit circle",
    parameters: &[Parameter {
        name: "spacing",
        default: "random",
        meaning: "random directions, or equal angles between neighbours",
        kind: Kind::Word(&["random", "equal"]),
    }],
    source: "the classical worst case of gift wrapping (h = n)",
    generate: Generate::Plane(|spec, n, seed| {
        Ok(match spec.word("spacing") {
            "equal" => (0..n)
                .map(|index| at_turn(index as f64 / n as f64))
                .collect(),
            _ => {
                let mut draw = Draw::new(seed);
                (0..n).map(|_| random_direction(&mut draw)).collect()
            }
        })
    }),
};

/// The point of the unit circle at this fraction of a turn from (1, 0), rounded.
pub(crate) fn at_turn(turn: f64) -> [f64; 2] {
    let (sine, cosine) = libm::sincos(TAU * turn);
    [cosine, sine]
}

/// A point of the disc pushed out to the circle; points near the centre, whose direction is coarse, are
/// drawn again.
fn random_direction(draw: &mut Draw) -> [f64; 2] {
    loop {
        let ([x, y], squared) = draw.in_disc();
        if squared > 1e-4 {
            let distance = squared.sqrt();
            return [x / distance, y / distance];
        }
    }
}
