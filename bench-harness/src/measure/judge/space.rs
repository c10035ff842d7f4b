//! Whether an answer about a hull in space is right, and how wrong a wrong one is.

use super::difference::{Difference, Far, largest};
use super::view;
use crate::engine::answer::Answer;
use crate::engine::cut::cuts_up;
use crate::engine::protocol::Kind;
use geometry_core::{Hull3, Point3};

/// No more heights of points over planes than this: 10⁶ planes with 100 points.
const HEIGHTS: usize = 100_000_000;

/// What there is to say of a right answer, or what is wrong with another.
pub(super) fn judge(points: &[Point3], proved: &Hull3, answer: &Answer) -> Result<String, String> {
    if answer.hull3(view(points)?).as_ref() == Some(proved) {
        return Ok(String::new());
    }
    let difference = Difference::of(proved.vertices(), answer);
    if answer.kind() == Kind::Vertices && difference.is_none() {
        return Ok("the set of vertices only".to_owned());
    }
    if difference.is_none() {
        let cut = answer
            .triangles()
            .ok_or("the right vertices, but other facets")?;
        cuts_up(&cut, proved).map_err(|what| format!("the right vertices; {what}"))?;
        return Ok("facets cut into triangles".to_owned());
    }
    let far = furthest(points, answer, &difference.misses);
    Err(difference.said(far, largest(points.as_flattened())))
}

/// How far the furthest of the points `misses` lies outside the facets of `answer`, in plain floating point: a measure,
/// not a decision. Of too many points every so manieth is looked at.
fn furthest(points: &[Point3], answer: &Answer, misses: &[u32]) -> Far {
    let planes = answer
        .parts()
        .filter_map(|part| Plane::through(points, part));
    let planes: Vec<Plane> = planes.collect();
    let most = (HEIGHTS / planes.len().max(1)).max(1);
    let step = misses.len().div_ceil(most).max(1);
    let looked_at = misses.iter().step_by(step).map(|&id| points[id as usize]);
    let heights = looked_at.flat_map(|point| planes.iter().map(move |plane| plane.height(point)));
    let far = heights.fold(0.0, f64::max);
    if step == 1 {
        Far::Exactly(far)
    } else {
        Far::AtLeast(far)
    }
}

/// The plane of a facet, in plain floating point.
struct Plane {
    normal: Point3,
    through: Point3,
}

impl Plane {
    fn through(points: &[Point3], facet: &[u32]) -> Option<Self> {
        let [a, b, c, ..] = facet else { return None };
        let [a, b, c] = [a, b, c].map(|id| points[*id as usize]);
        let (u, v) = (minus(b, a), minus(c, a));
        let normal: Point3 = std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            u[j] * v[k] - u[k] * v[j]
        });
        let length = dot(normal, normal).sqrt();
        (length > 0.0).then(|| Self {
            normal: normal.map(|x| x / length),
            through: a,
        })
    }

    fn height(&self, p: Point3) -> f64 {
        dot(self.normal, minus(p, self.through))
    }
}

fn minus(p: Point3, q: Point3) -> Point3 {
    std::array::from_fn(|i| p[i] - q[i])
}

fn dot(p: Point3, q: Point3) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
