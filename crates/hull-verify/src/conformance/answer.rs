//! What the suite needs to know of a result: hulls and layers.

use super::cases::Cases;
use super::change::{Change, Handedness};
use crate::arithmetic::order;
use crate::check::{self, Finding};
use crate::oracle;
use geometry_core::{Boundary, Hull2, Layers, Point2};
use std::fmt::Debug;
use std::sync::OnceLock;

/// A result that the suite can judge.
pub(super) trait Answer: Clone + PartialEq + Debug + Sized + 'static {
    /// The right answer, by the oracle.
    fn expected(points: &[Point2], boundary: Boundary) -> Self;

    /// The checker's findings.
    fn certify(&self, points: &[Point2], boundary: Boundary) -> Result<(), Vec<Finding>>;

    /// The right answer for the changed points, where `self` is right for the original ones.
    fn carried(&self, change: &Change) -> Self;

    /// `points` with more points after them, and the right answer for all, where `self` is right for `points`.
    fn grown(&self, points: &[Point2], boundary: Boundary) -> Option<(Vec<Point2>, Self)>;

    /// Whether every index in it is that of one of `count` points: all that is asked of an answer found with a
    /// kernel that contradicts itself.
    fn names_points(&self, count: usize) -> bool;

    /// Where the expected answers are kept.
    fn cache() -> &'static OnceLock<Cases<Self>>;
}

impl Answer for Hull2 {
    fn expected(points: &[Point2], boundary: Boundary) -> Self {
        oracle::hull2(points, boundary)
    }

    fn certify(&self, points: &[Point2], boundary: Boundary) -> Result<(), Vec<Finding>> {
        check::hull2(points, boundary, self).map(|_| ())
    }

    fn carried(&self, change: &Change) -> Self {
        let new = |&id: &u32| change.stands_for(id);
        let at = |id: u32| change.points[id as usize];
        match self {
            Hull2::Empty => Hull2::Empty,
            Hull2::Point(id) => Hull2::Point(new(id)),
            Hull2::Segment(ids) => {
                let mut row: Vec<u32> = ids.iter().map(new).collect();
                row.sort_by(|&a, &b| order(at(a), at(b)));
                Hull2::Segment(row)
            }
            Hull2::Polygon(ids) => {
                let mut cycle: Vec<u32> = ids.iter().map(new).collect();
                if change.handedness == Handedness::Mirrored {
                    cycle.reverse();
                }
                let first = (0..cycle.len()).min_by(|&i, &j| order(at(cycle[i]), at(cycle[j])));
                cycle.rotate_left(first.unwrap_or(0));
                Hull2::Polygon(cycle)
            }
        }
    }

    /// Adds midpoints of pairs of points, as far as the checker finds that they leave the hull as it is.
    fn grown(&self, points: &[Point2], boundary: Boundary) -> Option<(Vec<Point2>, Self)> {
        const MOST: usize = 12;
        let mut grown = points.to_vec();
        for (i, p) in points.iter().enumerate() {
            let q = points[(i * 7 + 3) % points.len()];
            grown.push([p[0] / 2.0 + q[0] / 2.0, p[1] / 2.0 + q[1] / 2.0]);
            if check::hull2(&grown, boundary, self).is_err() {
                grown.pop();
            }
            if grown.len() == points.len() + MOST {
                break;
            }
        }
        (grown.len() > points.len()).then(|| (grown, self.clone()))
    }

    fn names_points(&self, count: usize) -> bool {
        self.vertices().iter().all(|&id| (id as usize) < count)
    }

    fn cache() -> &'static OnceLock<Cases<Self>> {
        static CACHE: OnceLock<Cases<Hull2>> = OnceLock::new();
        &CACHE
    }
}

impl Answer for Layers {
    fn expected(points: &[Point2], boundary: Boundary) -> Self {
        oracle::layers(points, boundary)
    }

    fn certify(&self, points: &[Point2], boundary: Boundary) -> Result<(), Vec<Finding>> {
        check::layers(points, boundary, self).map(|_| ())
    }

    fn carried(&self, change: &Change) -> Self {
        let rings = self
            .rings()
            .iter()
            .map(|ring| ring.carried(change))
            .collect();
        let rank = |&old: &u32| self.c_ranks()[old as usize];
        Layers::new(rings, change.origin.iter().map(rank).collect())
    }

    /// Adds a triangle round everything, which becomes the first layer and pushes the others inwards.
    fn grown(&self, points: &[Point2], _: Boundary) -> Option<(Vec<Point2>, Self)> {
        let reach = points
            .as_flattened()
            .iter()
            .fold(1.0, |most: f64, x| most.max(x.abs()));
        let far = 8.0 * reach;
        if !far.is_finite() {
            return None;
        }
        let n = points.len() as u32;
        let mut grown = points.to_vec();
        grown.extend([[-far, -far], [far, -far], [0.0, far]]);
        let mut rings = vec![Hull2::Polygon(vec![n, n + 1, n + 2])];
        rings.extend_from_slice(self.rings());
        let mut ranks: Vec<u32> = self.c_ranks().iter().map(|rank| rank + 1).collect();
        ranks.extend([1; 3]);
        Some((grown, Layers::new(rings, ranks)))
    }

    fn names_points(&self, count: usize) -> bool {
        let rings = 1..=self.len() as u32;
        self.rings().iter().all(|ring| ring.names_points(count))
            && self.c_ranks().len() == count
            && self.c_ranks().iter().all(|rank| rings.contains(rank))
    }

    fn cache() -> &'static OnceLock<Cases<Self>> {
        static CACHE: OnceLock<Cases<Layers>> = OnceLock::new();
        &CACHE
    }
}
