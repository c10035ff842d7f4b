//! CONE(m): two hulls whose merge turns about one vertex from beginning to end.
//!
//! ```text
//!     y = 2   b  b  b  b  b   2m + 1 points on the cone of slope 2.5 round the y-axis
//!     y = 1      a a a a      2m points on the cone of slope 0.5
//!     y = 0         v
//! ```
//!
//! n = 4m + 2 points. The lower half, v and the a_i, and the upper half are the two sets of the last merge of a
//! method that splits by the median of y. Only the tip v is left of the lower half, and it stays the pivot for all
//! of the 2m + 1 steps of the wrap. A method that looks at the whole star of v at each step does Θ(n²); one that
//! goes on where it left off, O(n).
//!
//! Both rings are at equal angles; each point is scaled towards v by a factor drawn from [0.9, 1), so that no ring
//! is planar. Of n that is no 4m + 2, the surplus joins the upper ring; of n below 14 the set is the beginning of
//! CONE(3).

use super::circle::at_turn;
use super::fan::{AXIS, along_axis, half_sides};
use crate::catalogue::{Entry, Generate};
use crate::draw::Draw;
use crate::error::SpecError;
use crate::spec::Spec;

pub(crate) const ENTRY: Entry = Entry {
    name: "cone",
    summary: "CONE(m), n = 4m + 2: a merge by wrapping that turns about one vertex all the time",
    parameters: &[AXIS],
    source: "a worst case for the merge that Day 1990, Figure 18, suspects of being quadratic",
    generate: Generate::Space(generate),
};

fn generate(spec: &Spec, n: usize, seed: u64) -> Result<Vec<[f64; 3]>, SpecError> {
    let lower = 2 * half_sides(n, 3);
    let upper = n.saturating_sub(lower + 1).max(3);
    let mut draw = Draw::new(seed);
    let mut points = Vec::with_capacity(1 + lower + upper);
    points.push([0.0; 3]);
    for (count, height, slope) in [(lower, 1.0, 0.5), (upper, 2.0, 2.5)] {
        for index in 0..count {
            let height = height * (0.9 + 0.1 * draw.unit());
            let around = at_turn(index as f64 / count as f64);
            points.push(along_axis(
                spec,
                height,
                around.map(|coordinate| slope * height * coordinate),
            ));
        }
    }
    points.truncate(n);
    Ok(points)
}
