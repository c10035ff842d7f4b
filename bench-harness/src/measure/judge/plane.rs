//! Whether an answer about a hull of the plane is right, and how wrong a wrong one is.

use super::difference::{Difference, Far, largest};
use super::{first, view};
use crate::engine::answer::Answer;
use crate::engine::protocol::Kind;
use geometry_core::{Boundary, Hull2, Point2};
use hull_verify::check;
use std::cell::OnceCell;
use std::collections::HashMap;

/// What the checker has proved of a set.
#[derive(Clone, Debug)]
pub(super) struct Reference {
    hull: Hull2,
    /// The place of each point of the boundary on its way round, made when it is first asked for.
    places: OnceCell<Result<HashMap<u32, usize>, String>>,
}

impl Reference {
    /// The hull of `points`, proved.
    pub(super) fn prove(points: &[Point2], boundary: Boundary) -> Result<Self, String> {
        Ok(Self {
            hull: proved(points, boundary)?,
            places: OnceCell::new(),
        })
    }

    /// What there is to say of a right answer, or what is wrong with another.
    pub(super) fn judge(&self, points: &[Point2], answer: &Answer) -> Result<String, String> {
        let found = answer.hull2(view(points)?);
        if found.as_ref() == Some(&self.hull) {
            return Ok(String::new());
        }
        let difference = Difference::of(self.hull.vertices(), answer);
        if answer.kind() == Kind::Vertices && difference.is_none() {
            return Ok("the set of vertices only".to_owned());
        }
        if found.is_some() && difference.misses.is_empty() && self.goes_round(points, answer)? {
            return Ok("points on edges beside the corners".to_owned());
        }
        let far = furthest(points, self.hull.vertices(), &difference.misses);
        Err(difference.said(Far::Exactly(far), largest(points.as_flattened())))
    }

    /// Whether the cycle of `answer` visits points on the boundary only, in the order in which they lie on it.
    fn goes_round(&self, points: &[Point2], answer: &Answer) -> Result<bool, String> {
        let places = self.places.get_or_init(|| {
            let ring = proved(points, Boundary::All)?;
            Ok(ring.vertices().iter().copied().zip(0..).collect())
        });
        let places = places.as_ref().map_err(Clone::clone)?;
        let cycle = answer.parts().flatten().map(|id| places.get(id).copied());
        let Some(cycle) = cycle.collect::<Option<Vec<usize>>>() else {
            return Ok(false);
        };
        let steps = cycle.iter().zip(cycle.iter().cycle().skip(1));
        Ok(steps.filter(|(from, to)| from >= to).count() <= 1)
    }
}

/// The hull of `points`, certified.
fn proved(points: &[Point2], boundary: Boundary) -> Result<Hull2, String> {
    let hull = hullkit::convex_hull_2d_with(points, boundary).map_err(|error| error.to_string())?;
    check::hull2(points, boundary, &hull).map_err(|findings| first(&findings))?;
    Ok(hull)
}

/// How far the furthest of the vertices `misses` of the cycle `hull` lies outside the polygon of the others, in plain
/// floating point: a measure, not a decision. `misses` ascend. O(h log h) for a hull of h vertices.
///
/// A missed vertex lies beyond the edge from the last vertex before it that was not missed to the next after it.
fn furthest(points: &[Point2], hull: &[u32], misses: &[u32]) -> f64 {
    let kept = |id: &u32| misses.binary_search(id).is_err();
    let Some(start) = hull.iter().position(kept) else {
        return f64::INFINITY;
    };
    let (before, from) = hull.split_at(start);
    let at = |id: u32| points[id as usize];
    let mut far = 0.0_f64;
    let mut corner = hull[start];
    let mut waiting = Vec::new();
    // Once round, back to where it began.
    for &id in from.iter().chain(before).chain([&hull[start]]).skip(1) {
        if !kept(&id) {
            waiting.push(id);
            continue;
        }
        for missed in waiting.drain(..) {
            far = far.max(height(at(corner), at(id), at(missed)));
        }
        corner = id;
    }
    far
}

/// How far `p` lies to the right of the line from `a` to `b`, or from `a` if that is `b`; at least 0.
fn height(a: Point2, b: Point2, p: Point2) -> f64 {
    let (u, v) = (b[0] - a[0], b[1] - a[1]);
    let (x, y) = (p[0] - a[0], p[1] - a[1]);
    let length = u.hypot(v);
    let height = if length > 0.0 {
        (v * x - u * y) / length
    } else {
        x.hypot(y)
    };
    height.max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_furthest_missed_vertex_is_measured_from_the_edge_it_lies_beyond() {
        let points = [
            [0.0, 0.0],
            [4.0, -1.0],
            [8.0, 0.0],
            [8.0, 8.0],
            [2.0, 10.0],
            [0.0, 8.0],
        ];
        let hull = [0, 1, 2, 3, 4, 5];
        assert!((furthest(&points, &hull, &[1]) - 1.0).abs() < 1e-12);
        assert!((furthest(&points, &hull, &[1, 4]) - 2.0).abs() < 1e-12);
        assert!((furthest(&points, &hull, &[0]) - 32.0 / 97.0_f64.sqrt()).abs() < 1e-12);
        assert_eq!(furthest(&points, &hull, &[]), 0.0);
        assert_eq!(furthest(&points, &hull, &hull), f64::INFINITY);
        assert_eq!(
            furthest(&points, &hull, &[1, 2, 3, 4, 5]),
            10.4_f64
                .hypot(0.0)
                .max(104.0_f64.sqrt())
                .max(128.0_f64.sqrt())
        );
    }
}
