//! FAN(m): two hulls whose merge passes one vertex again and again.
//!
//! ```text
//!     y = 2.5     ·           m + 1 points inside a pyramid over the b_j, its tip the last of them
//!     y = 2    b·····b        m points, each above every other side of the cone
//!     y = 1    a·a·a·a        N = 2m points at equal angles: a cone with its tip at v
//!     y = 0       v
//! ```
//!
//! n = 4m + 2 points. The lower half, v and the a_i, and the upper half are the two sets of the last merge of a
//! method that splits by the median of y. The tip v is a vertex of degree N, and the points b_j take away every
//! other side of the cone, so the path of the merge runs v, a, a, v, a, a, v, ... and visits v about m times. A
//! method that looks at the whole star of v at each visit does Θ(n²); one that goes on where it left off, O(n).
//!
//! b_j lies at distance s from the axis, where s is halfway between the plane of the side it takes away and the
//! planes of the sides next to that. Of n that is no 4m + 2, the surplus of up to three points joins those inside
//! the pyramid; of n below 14 the set is the beginning of FAN(3).

use super::circle::at_turn;
use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::spec::Spec;
use std::f64::consts::TAU;

pub(crate) const ENTRY: Entry = Entry {
    name: "fan",
    summary: "FAN(m), n = 4m + 2: a merge by wrapping that passes one vertex m times",
    parameters: &[AXIS],
    source: "a worst case for the merge that Day 1990, Figure 18, suspects of being quadratic",
    generate: Generate::Space(generate),
};

pub(crate) const AXIS: Parameter = Parameter {
    name: "axis",
    default: "y",
    meaning: "the coordinate whose median separates the two hulls; the others follow in turn",
    kind: Kind::Word(&["x", "y", "z"]),
};

/// m for n points.
pub(crate) fn half_sides(n: usize, least: usize) -> usize {
    (n.saturating_sub(2) / 4).max(least)
}

/// The point at `height` along the axis of `spec` and at [u, v] across it, so that no mirror image is made.
pub(crate) fn along_axis(spec: &Spec, height: f64, [u, v]: [f64; 2]) -> [f64; 3] {
    match spec.word("axis") {
        "x" => [height, v, u],
        "z" => [v, u, height],
        _ => [u, height, v],
    }
}

fn generate(spec: &Spec, n: usize, _seed: u64) -> Result<Vec<[f64; 3]>, crate::SpecError> {
    let m = half_sides(n, 3);
    let sides = 2 * m;
    let place = |height, radius: f64, turn| {
        along_axis(
            spec,
            height,
            at_turn(turn).map(|coordinate| radius * coordinate),
        )
    };
    let between = {
        let step = TAU / sides as f64;
        let apothem = 2.0 * libm::cos(step / 2.0);
        apothem * (1.0 + 1.0 / libm::cos(step)) / 2.0
    };
    let tip = std::iter::once(place(0.0, 0.0, 0.0));
    let ring = (0..sides).map(|i| place(1.0, 1.0, i as f64 / sides as f64));
    let above = (0..m).map(|j| {
        place(
            2.0,
            between,
            (2 * j) as f64 / sides as f64 + 0.5 / sides as f64,
        )
    });
    let inside = n.saturating_sub(3 * m + 1);
    let pyramid = (1..=inside).map(|k| {
        // Less than half of `between` times what is left of the height: inside over any polygon.
        let risen = k as f64 / inside as f64;
        place(2.0 + risen / 2.0, (1.0 - risen) / 2.0, GOLDEN * k as f64)
    });
    Ok(tip
        .chain(ring)
        .chain(above)
        .chain(pyramid)
        .take(n)
        .collect())
}

/// The golden section, whose multiples are spread evenly round a turn.
const GOLDEN: f64 = 0.618_033_988_749_894_8;
