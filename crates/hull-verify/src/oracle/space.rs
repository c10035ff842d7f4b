//! Hulls in space straight from the definition.
//!
//! A facet is what of the hull lies in a plane that has points on one side only, and three of its points span it. So
//! every triple of points is tried against all points; where none is on one of the sides of its plane, the facet is
//! the planar hull, by [`super::hull2`], of the shadows of the points in the plane.

use super::hull2;
use crate::arithmetic::Turn;
use crate::arithmetic::scale::{Scale, Side, order3, shadow};
use geometry_core::hull3::Solid;
use geometry_core::{Axis, Boundary, Hull2, Hull3, Point2, Point3};

/// The hull in space of `points`, which must be finite and fewer than 2³².
///
/// # Cost
///
/// O(n⁴) time at most, O(n²) space.
///
/// ```
/// use geometry_core::{Hull3, hull3::Solid};
/// use hull_verify::oracle;
/// let square = [[0.0; 3], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
/// assert_eq!(oracle::hull3(&square), Hull3::Planar(vec![0, 4, 3, 1]));
///
/// let mut pyramid = square.to_vec();
/// pyramid.push([1.0, 1.0, 5.0]);
/// let facets = vec![vec![0, 4, 3, 1], vec![0, 1, 5], vec![1, 3, 5], vec![3, 4, 5], vec![4, 0, 5]];
/// assert_eq!(oracle::hull3(&pyramid), Hull3::Solid(Solid::from_loops(facets)));
/// ```
pub fn hull3(points: &[Point3]) -> Hull3 {
    let at = |id: u32| points[id as usize];
    let mut ids: Vec<u32> = (0..points.len() as u32).collect();
    ids.sort_by(|&a, &b| order3(at(a), at(b)).then(a.cmp(&b)));
    ids.dedup_by(|later, kept| order3(at(*later), at(*kept)).is_eq());
    let set = Set {
        points,
        scale: Scale::of(points),
        ids: &ids,
    };
    let (first, last) = match ids[..] {
        [] => return Hull3::Empty,
        [only] => return Hull3::Point(only),
        [first, .., last] => (first, last),
    };
    let Some(&off_line) = ids
        .iter()
        .find(|&&id| !set.scale.collinear(at(first), at(last), at(id)))
    else {
        return Hull3::Segment([first, last]);
    };
    if set.sides([first, last, off_line]) == (0, 0) {
        return set.planar([first, last, off_line]);
    }
    Hull3::Solid(Solid::from_loops(set.facets()))
}

struct Set<'a> {
    points: &'a [Point3],
    scale: Scale,
    /// Distinct points in lexicographic order.
    ids: &'a [u32],
}

impl Set<'_> {
    fn at(&self, id: u32) -> Point3 {
        self.points[id as usize]
    }

    fn side(&self, [a, b, c]: [u32; 3], id: u32) -> Side {
        self.scale
            .side(self.at(a), self.at(b), self.at(c), self.at(id))
    }

    /// How many points are above and below the plane; as soon as both numbers are positive it counts no further.
    fn sides(&self, plane: [u32; 3]) -> (usize, usize) {
        let (mut above, mut below) = (0, 0);
        for &id in self.ids {
            match self.side(plane, id) {
                Side::Above => above += 1,
                Side::On => {}
                Side::Below => below += 1,
            }
            if above > 0 && below > 0 {
                break;
            }
        }
        (above, below)
    }

    fn facets(&self) -> Vec<Vec<u32>> {
        let n = self.ids.len();
        // Triples of a facet found earlier would give it again.
        let mut found: Vec<Vec<bool>> = Vec::new();
        let mut facets = Vec::new();
        for i in 0..n {
            for j in 0..i {
                for k in 0..j {
                    let [a, b, c] = [i, j, k].map(|i| self.ids[i]);
                    if found.iter().any(|on| on[i] && on[j] && on[k])
                        || self.scale.collinear(self.at(a), self.at(b), self.at(c))
                    {
                        continue;
                    }
                    let outward = match self.sides([a, b, c]) {
                        (0, _) => [a, b, c],
                        (_, 0) => [a, c, b],
                        _ => continue,
                    };
                    let on_plane = |&id: &u32| self.side(outward, id) == Side::On;
                    found.push(self.ids.iter().map(on_plane).collect());
                    facets.push(self.corners_in(outward));
                }
            }
        }
        facets
    }

    /// The corners of the hull of the points in a plane, anticlockwise as seen from above it.
    fn corners_in(&self, plane: [u32; 3]) -> Vec<u32> {
        let [a, b, c] = plane.map(|id| self.at(id));
        let turns = Axis::ALL.map(|axis| (axis, self.scale.turn(axis, a, b, c)));
        let (axis, turn) = turns
            .into_iter()
            .find(|&(_, turn)| turn != Turn::Straight)
            .expect("three points that are not collinear have a shadow with area");
        let members: Vec<u32> = self
            .ids
            .iter()
            .copied()
            .filter(|&id| self.side(plane, id) == Side::On)
            .collect();
        let shadows: Vec<Point2> = members
            .iter()
            .map(|&id| shadow(axis, self.at(id)))
            .collect();
        let mut corners = match hull2(&shadows, Boundary::Extreme) {
            Hull2::Polygon(cycle) => cycle,
            other => {
                unreachable!("the plane is spanned by points of it, but their hull is {other:?}")
            }
        };
        for corner in &mut corners {
            *corner = members[*corner as usize];
        }
        if turn == Turn::Right {
            corners.reverse();
        }
        corners
    }

    /// The hull of points that are all in this plane.
    fn planar(&self, plane: [u32; 3]) -> Hull3 {
        let mut cycle = self.corners_in(plane);
        let place = |id: u32| self.ids.iter().position(|&other| other == id);
        let first = (0..cycle.len()).min_by_key(|&i| place(cycle[i]));
        cycle.rotate_left(first.unwrap_or(0));
        if place(cycle[cycle.len() - 1]) < place(cycle[1]) {
            cycle[1..].reverse();
        }
        Hull3::Planar(cycle)
    }
}
