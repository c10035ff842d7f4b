//! The affine dimension of a point set in space, and the hull of a set that does not span it.
//!
//! A set in a plane casts a shadow along some axis that is a true picture of it: the shadow of a triangle of the
//! plane that is not flat shows which. The planar hull is found in that shadow, with no coordinate changed.

use crate::hull3::Hull3;
use crate::kernel::space::{Axis, Kernel3};
use crate::points::Points;
use crate::sort::merge_sort;

/// As many affinely independent points of a set as there are.
///
/// Deterministic: the first two are the lexicographic extremes, the others the first of the set that are independent
/// of those before; of copies always the smallest index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AffineBasis {
    /// There are no points.
    Empty,
    /// All points are copies of this one.
    Point(u32),
    /// All points are on the line through these two, the lexicographically smallest and largest.
    Line([u32; 2]),
    /// All points are on the plane through these three.
    Plane([u32; 3]),
    /// These four span space; their orientation is positive.
    Space([u32; 4]),
}

impl AffineBasis {
    /// Finds the basis of `points`. `kernel` must be exact and must not be perturbed.
    ///
    /// # Cost
    ///
    /// O(n) questions; for sets in general position n comparisons and a handful of orientations.
    ///
    /// ```
    /// use geometry_core::dimension::AffineBasis;
    /// use geometry_core::{Exact, Points};
    /// let square = [[0.0; 3], [1.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 1.0, 1.0]];
    /// let points = Points::new(&square)?;
    /// assert_eq!(AffineBasis::of(points, &Exact), AffineBasis::Plane([0, 3, 1]));
    /// # Ok::<(), geometry_core::HullError>(())
    /// ```
    pub fn of<K: Kernel3>(points: Points<'_, 3>, kernel: &K) -> Self {
        if points.is_empty() {
            return AffineBasis::Empty;
        }
        let (mut a, mut b) = (0, 0);
        for id in points.ids().skip(1) {
            if kernel.lexicographic3(points[id], points[a]).is_lt() {
                a = id;
            }
            if kernel.lexicographic3(points[id], points[b]).is_gt() {
                b = id;
            }
        }
        if kernel.lexicographic3(points[a], points[b]).is_eq() {
            return AffineBasis::Point(0);
        }
        let off_line = |&c: &u32| !kernel.collinear3(points[a], points[b], points[c]);
        let Some(c) = points.ids().find(off_line) else {
            return AffineBasis::Line([a, b]);
        };
        let side = |d: u32| kernel.orient3(points[a], points[b], points[c], points[d]);
        match points.ids().find(|&d| !side(d).is_zero()) {
            None => AffineBasis::Plane([a, b, c]),
            Some(d) if side(d).is_positive() => AffineBasis::Space([a, b, c, d]),
            Some(d) => AffineBasis::Space([a, c, b, d]),
        }
    }

    /// The hull of a set that does not span space: `Err` with the four independent points of one that does.
    ///
    /// # Cost
    ///
    /// O(n log n) for a planar set, O(1) below.
    pub fn flat_hull<K: Kernel3>(
        self,
        points: Points<'_, 3>,
        kernel: &K,
    ) -> Result<Hull3, [u32; 4]> {
        match self {
            AffineBasis::Empty => Ok(Hull3::Empty),
            AffineBasis::Point(id) => Ok(Hull3::Point(id)),
            AffineBasis::Line(ends) => Ok(Hull3::Segment(ends)),
            AffineBasis::Plane(triangle) => {
                let (polygon, _) = planar_hull(points, points.ids().collect(), triangle, kernel);
                Ok(Hull3::of_polygon(points, polygon))
            }
            AffineBasis::Space(simplex) => Err(simplex),
        }
    }
}

/// The corners of the hull of the points `ids`, all in the plane of `triangle`, which is not flat.
///
/// Anticlockwise as seen from the side from which `triangle` runs anticlockwise, from the lexicographically smallest
/// corner; with the axis whose shadow was taken.
pub(crate) fn planar_hull<K: Kernel3>(
    points: Points<'_, 3>,
    mut ids: Vec<u32>,
    triangle: [u32; 3],
    kernel: &K,
) -> (Vec<u32>, Axis) {
    let [a, b, c] = triangle.map(|id| points[id]);
    let pictures = Axis::ALL.map(|axis| (axis, kernel.shadow(axis, a, b, c)));
    let (axis, sign) = pictures
        .into_iter()
        .find(|(_, sign)| !sign.is_zero())
        .unwrap_or((Axis::Z, crate::Sign::Positive));
    let mut scratch = vec![0; ids.len()];
    merge_sort(&mut ids, &mut scratch, |p, q| {
        kernel.lexicographic3(points[p], points[q]).then(p.cmp(&q))
    });
    ids.dedup_by(|later, kept| kernel.lexicographic3(points[*later], points[*kept]).is_eq());
    // Andrew's chain twice. The lexicographic order of space is, within the plane, an order along a direction.
    let turns_left =
        |p: u32, q: u32, r: u32| kernel.shadow(axis, points[p], points[q], points[r]) == sign;
    let chain = |order: &mut dyn Iterator<Item = u32>| {
        let mut chain: Vec<u32> = Vec::new();
        for id in order {
            while let [.., p, q] = chain[..]
                && !turns_left(p, q, id)
            {
                chain.pop();
            }
            chain.push(id);
        }
        chain.pop();
        chain
    };
    let mut polygon = chain(&mut ids.iter().copied());
    polygon.extend(chain(&mut ids.iter().rev().copied()));
    (polygon, axis)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Exact;

    fn basis(points: &[[f64; 3]]) -> AffineBasis {
        AffineBasis::of(Points::new(points).expect("finite"), &Exact)
    }

    #[test]
    fn every_dimension_is_found() {
        assert_eq!(basis(&[]), AffineBasis::Empty);
        assert_eq!(basis(&[[1.0; 3], [1.0; 3]]), AffineBasis::Point(0));
        assert_eq!(
            basis(&[[2.0; 3], [1.0; 3], [3.0; 3], [3.0; 3]]),
            AffineBasis::Line([1, 2])
        );
        let flat = [[0.0, 0.0, 5.0], [0.0, 1.0, 5.0], [1.0, 0.0, 5.0]];
        assert_eq!(basis(&flat), AffineBasis::Plane([0, 2, 1]));
        let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(basis(&corner), AffineBasis::Space([0, 1, 2, 3]));
    }

    #[test]
    fn the_flat_hull_is_found_in_any_plane() {
        // A square with its centre and the middle of one edge, in planes along every axis and across.
        let square = [
            [0.0, 0.0],
            [2.0, 0.0],
            [2.0, 2.0],
            [0.0, 2.0],
            [1.0, 1.0],
            [1.0, 0.0],
        ];
        let planes: [fn([f64; 2]) -> [f64; 3]; 5] = [
            |[u, v]| [u, v, 3.0],
            |[u, v]| [u, 3.0, v],
            |[u, v]| [3.0, u, v],
            |[u, v]| [u, v, u + v],
            |[u, v]| [u, u, v],
        ];
        for plane in planes {
            let points = square.map(plane);
            let points = Points::new(&points).expect("finite");
            let hull = AffineBasis::of(points, &Exact)
                .flat_hull(points, &Exact)
                .expect("a flat set");
            let Hull3::Planar(ids) = hull else {
                panic!("{hull:?} is not planar")
            };
            assert!(ids == [0, 1, 2, 3] || ids == [0, 3, 2, 1], "{ids:?}");
        }
    }
}
