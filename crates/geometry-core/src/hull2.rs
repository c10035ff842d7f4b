//! The convex hull of a planar point set, as a canonical value.

use crate::kernel::{Kernel2, lexicographic};
use crate::points::{Point2, Points};
use crate::sort::merge_sort;
use std::cmp::Ordering;

/// Which boundary points count as vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Boundary {
    /// Only the extreme points: corners with a strict turn.
    #[default]
    Extreme,
    /// Every distinct point on the boundary, the convention of Green and Silverman (1979).
    All,
}

/// The convex hull of a planar point set.
///
/// Canonical: two right answers for the same points and the same [`Boundary`] are equal values. Of equal
/// points the smallest index stands for all.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Hull2 {
    /// The hull of no points.
    Empty,
    /// All points are copies of this one.
    Point(u32),
    /// All points are collinear: the two ends, or under [`Boundary::All`] every distinct point, in
    /// lexicographic order.
    Segment(Vec<u32>),
    /// The vertices anticlockwise, from the lexicographically smallest.
    Polygon(Vec<u32>),
}

impl Hull2 {
    /// The hull whose boundary is `cycle`: distinct points in anticlockwise order, starting anywhere.
    ///
    /// One or two points make a [`Hull2::Point`] or [`Hull2::Segment`]; three or more must not all be
    /// collinear (see [`Hull2::of_collinear`]).
    ///
    /// # Cost
    ///
    /// O(h) time, in place.
    pub fn from_cycle(points: Points<'_, 2>, mut cycle: Vec<u32>) -> Self {
        let first =
            (0..cycle.len()).min_by(|&i, &j| lexicographic(points[cycle[i]], points[cycle[j]]));
        cycle.rotate_left(first.unwrap_or(0));
        match cycle.len() {
            0 => Hull2::Empty,
            1 => Hull2::Point(cycle[0]),
            2 => Hull2::Segment(cycle),
            _ => Hull2::Polygon(cycle),
        }
    }

    /// The hull of the points `ids`, which are all on one line.
    ///
    /// # Cost
    ///
    /// O(m log m) comparisons by the kernel for m ids, in place.
    pub fn of_collinear<K: Kernel2>(
        points: Points<'_, 2>,
        mut ids: Vec<u32>,
        boundary: Boundary,
        kernel: &K,
    ) -> Self {
        sort_distinct(points, &mut ids, kernel);
        if boundary == Boundary::Extreme && ids.len() > 2 {
            ids = vec![ids[0], ids[ids.len() - 1]];
        }
        match ids.len() {
            0 => Hull2::Empty,
            1 => Hull2::Point(ids[0]),
            _ => Hull2::Segment(ids),
        }
    }

    /// The vertices: anticlockwise for a polygon, in lexicographic order for a segment.
    pub fn vertices(&self) -> &[u32] {
        match self {
            Hull2::Empty => &[],
            Hull2::Point(id) => std::slice::from_ref(id),
            Hull2::Segment(ids) | Hull2::Polygon(ids) => ids,
        }
    }

    /// The number of vertices, h.
    pub fn len(&self) -> usize {
        self.vertices().len()
    }

    /// Whether there is no vertex: the hull of no points.
    pub fn is_empty(&self) -> bool {
        self.vertices().is_empty()
    }

    /// The dimension of the hull: `None` if empty, 0 for a point, 1 for a segment, 2 for a polygon.
    pub fn dimension(&self) -> Option<usize> {
        match self {
            Hull2::Empty => None,
            Hull2::Point(_) => Some(0),
            Hull2::Segment(_) => Some(1),
            Hull2::Polygon(_) => Some(2),
        }
    }

    /// The area enclosed, rounded: 0 below dimension 2, infinite where squares of coordinates overflow.
    pub fn area(&self, points: Points<'_, 2>) -> f64 {
        let Hull2::Polygon(ids) = self else {
            return 0.0;
        };
        let origin = points[ids[0]];
        let cross = |a: Point2, b: Point2| {
            (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0])
        };
        let doubled: f64 = ids
            .windows(2)
            .map(|edge| cross(points[edge[0]], points[edge[1]]))
            .sum();
        doubled / 2.0
    }

    /// The length of the boundary, rounded; for a segment its length once.
    pub fn perimeter(&self, points: Points<'_, 2>) -> f64 {
        let length = |a: u32, b: u32| {
            let (a, b) = (points[a], points[b]);
            (b[0] - a[0]).hypot(b[1] - a[1])
        };
        let ids = self.vertices();
        let open: f64 = ids.windows(2).map(|edge| length(edge[0], edge[1])).sum();
        match self {
            Hull2::Polygon(_) => open + length(ids[ids.len() - 1], ids[0]),
            _ => open,
        }
    }
}

/// Sorts `ids` lexicographically by their points and keeps of equal points the smallest index.
pub fn sort_distinct<K: Kernel2>(points: Points<'_, 2>, ids: &mut Vec<u32>, kernel: &K) {
    let mut scratch = vec![0; ids.len()];
    merge_sort(ids, &mut scratch, |a, b| {
        kernel.lexicographic(points[a], points[b]).then(a.cmp(&b))
    });
    ids.dedup_by(|later, kept| {
        kernel.lexicographic(points[*later], points[*kept]) == Ordering::Equal
    });
}
