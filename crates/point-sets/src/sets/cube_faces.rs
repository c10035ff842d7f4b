//! Points on the faces of a cube.
//!
//! ```text
//!        + · · · · · +
//!       · ·   ·   · ·|       random: uniform on the six faces of the unit cube
//!      + · · · · · + ·       lattice: the integer points on the surface of the smallest cube that has n of
//!      · ·   ·   · ·|·                them, in lexicographic order
//!      ·   ·   ·   · +
//!      · ·    ·  · ·/        every face is full of exactly coplanar points
//!      + · · · · · +
//! ```
//!
//! Eight points of the whole lattice are extreme. Of random points only those near the edges of the cube are, and
//! each face has one facet that lies exactly in it.

use crate::catalogue::{Entry, Generate, Kind, Parameter};
use crate::draw::Draw;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "cube-faces",
    summary: "on the faces of a cube, at random or an integer lattice",
    parameters: &[Parameter {
        name: "spacing",
        default: "random",
        meaning: "uniform on the faces of the unit cube, or the lattice of integers on the surface of a larger one",
        kind: Kind::Word(&["random", "lattice"]),
    }],
    source: "a standard degenerate case",
    generate: Generate::Space(|spec: &Spec, n, seed| {
        Ok(match spec.word("spacing") {
            "lattice" => surface(side_for(n)).take(n).collect(),
            _ => {
                let mut draw = Draw::new(seed);
                (0..n).map(|_| on_a_face(&mut draw)).collect()
            }
        })
    }),
};

fn on_a_face(draw: &mut Draw) -> [f64; 3] {
    let face = draw.below(6) as usize;
    let mut point = [(); 3].map(|()| draw.unit());
    point[face / 2] = (face % 2) as f64;
    point
}

/// The smallest side s whose cube has n integer points on its surface: 6s² + 2 of them.
fn side_for(n: usize) -> u32 {
    let has_room = |side: &u32| 6 * u64::from(*side).pow(2) + 2 >= n as u64;
    let near = ((n / 6).isqrt() as u32).saturating_sub(1).max(1);
    (near..).find(has_room).unwrap_or(near)
}

/// The integer points on the surface of the cube [0, side]³.
fn surface(side: u32) -> impl Iterator<Item = [f64; 3]> {
    let is_end = move |t: u32| t == 0 || t == side;
    let base = (0..=side).flat_map(move |x| (0..=side).map(move |y| (x, y)));
    base.flat_map(move |(x, y)| {
        let step = if is_end(x) || is_end(y) { 1 } else { side };
        let heights = (0..=side).step_by(step as usize);
        heights.map(move |z| [x, y, z].map(f64::from))
    })
}
