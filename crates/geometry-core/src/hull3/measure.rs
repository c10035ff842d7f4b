//! Volume, area, centroid, and where a point lies.

use super::Hull3;
use crate::kernel::space::{Axis, Kernel3};
use crate::points::{Point3, Points};
use crate::sign::Sign;

/// Where a point lies with regard to a hull.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Location {
    /// In the interior (relative to its plane or line, if the hull is flat).
    Inside,
    /// On the boundary.
    Boundary,
    /// Not in the hull.
    Outside,
}

fn minus(a: Point3, b: Point3) -> Point3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Point3, b: Point3) -> Point3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: Point3, b: Point3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Hull3 {
    /// The volume, rounded: 0 below dimension 3, infinite where cubes of coordinates overflow.
    pub fn volume(&self, points: Points<'_, 3>) -> f64 {
        self.tetrahedra(points)
            .map(|(sextuple, _)| sextuple)
            .sum::<f64>()
            / 6.0
    }

    /// The surface area, rounded; of a planar hull the area of one side.
    pub fn area(&self, points: Points<'_, 3>) -> f64 {
        let fan = |corners: &[u32]| {
            let origin = points[corners[0]];
            let edges = corners.windows(2).skip(1);
            let doubled =
                edges.map(|e| cross(minus(points[e[0]], origin), minus(points[e[1]], origin)));
            // The vectors of a fan are parallel, so the length of the sum is the sum of the lengths.
            let sum = doubled.fold([0.0; 3], |s, v| [s[0] + v[0], s[1] + v[1], s[2] + v[2]]);
            dot(sum, sum).sqrt() / 2.0
        };
        match self {
            Hull3::Planar(corners) => fan(corners),
            _ => self.facets().map(fan).sum(),
        }
    }

    /// The centre of mass of a solid, rounded; `None` below dimension 3.
    pub fn centroid(&self, points: Points<'_, 3>) -> Option<Point3> {
        let Hull3::Solid(_) = self else { return None };
        let (mut total, mut moment) = (0.0, [0.0; 3]);
        for (volume, sum) in self.tetrahedra(points) {
            total += volume;
            moment = [0, 1, 2].map(|i| moment[i] + volume * sum[i]);
        }
        let origin = points[self.vertices()[0]];
        Some([0, 1, 2].map(|i| origin[i] + moment[i] / (4.0 * total)))
    }

    /// Six times the volumes of the tetrahedra from the first vertex over all triangles, each with the sum of its
    /// other corners relative to that vertex.
    fn tetrahedra(&self, points: Points<'_, 3>) -> impl Iterator<Item = (f64, Point3)> {
        let origin = self.vertices().first().map_or([0.0; 3], |&id| points[id]);
        self.triangles().map(move |corners| {
            let [a, b, c] = corners.map(|id| minus(points[id], origin));
            let sum = [0, 1, 2].map(|i| a[i] + b[i] + c[i]);
            (dot(cross(a, b), c), sum)
        })
    }

    /// Where `p` lies, exactly. `kernel` must be exact and must not be perturbed.
    ///
    /// # Cost
    ///
    /// One orientation a facet.
    ///
    /// ```
    /// use geometry_core::hull3::{Location, Solid};
    /// use geometry_core::{Exact, Hull3, Points};
    /// let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// let points = Points::new(&corners)?;
    /// let loops = vec![vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![2, 0, 3]];
    /// let hull = Hull3::Solid(Solid::from_loops(loops));
    /// assert_eq!(hull.locate(points, [0.25; 3], &Exact), Location::Inside);
    /// assert_eq!(hull.locate(points, [0.5, 0.5, 0.0], &Exact), Location::Boundary);
    /// assert_eq!(hull.locate(points, [1e300; 3], &Exact), Location::Outside);
    /// # Ok::<(), geometry_core::HullError>(())
    /// ```
    pub fn locate<K: Kernel3>(&self, points: Points<'_, 3>, p: Point3, kernel: &K) -> Location {
        match self {
            Hull3::Empty => Location::Outside,
            Hull3::Point(id) if kernel.lexicographic3(points[*id], p).is_eq() => Location::Inside,
            Hull3::Point(_) => Location::Outside,
            Hull3::Segment([a, b]) => locate_on_segment([points[*a], points[*b]], p, kernel),
            Hull3::Planar(corners) => locate_in_polygon(points, corners, p, kernel),
            Hull3::Solid(solid) => worst(solid.facets().map(|facet| {
                let [a, b, c] = [0, 1, 2].map(|i| points[facet[i]]);
                kernel.orient3(a, b, c, p)
            })),
        }
    }
}

/// The location of a point for which these are the signs of its sides of all facets, positive outside.
fn worst(sides: impl Iterator<Item = Sign>) -> Location {
    match sides.max() {
        Some(Sign::Positive) => Location::Outside,
        Some(Sign::Zero) => Location::Boundary,
        _ => Location::Inside,
    }
}

fn locate_on_segment<K: Kernel3>([a, b]: [Point3; 2], p: Point3, kernel: &K) -> Location {
    let from_ends = [kernel.lexicographic3(a, p), kernel.lexicographic3(p, b)];
    if !kernel.collinear3(a, b, p) {
        return Location::Outside;
    }
    worst(from_ends.into_iter().map(Sign::from))
}

fn locate_in_polygon<K: Kernel3>(
    points: Points<'_, 3>,
    corners: &[u32],
    p: Point3,
    kernel: &K,
) -> Location {
    let [a, b, c] = [0, 1, 2].map(|i| points[corners[i]]);
    if !kernel.orient3(a, b, c, p).is_zero() {
        return Location::Outside;
    }
    let pictures = Axis::ALL.map(|axis| (axis, kernel.shadow(axis, a, b, c)));
    let Some((axis, sign)) = pictures.into_iter().find(|(_, sign)| !sign.is_zero()) else {
        return Location::Outside;
    };
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next);
    worst(edges.map(|(&from, &to)| -(sign * kernel.shadow(axis, points[from], points[to], p))))
}
