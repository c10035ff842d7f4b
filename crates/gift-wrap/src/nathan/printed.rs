//! The paper's arithmetic: distances along rounded unit normals, compared with an epsilon.

use geometry_core::{Axis, Kernel3, Point3, Points, Sign, Stage};
use std::cmp::Ordering;

/// The kernel of the paper: a point is outside an edge or a plane if its signed distance, in `f64`, exceeds
///
/// ```text
///     ε = ε_machine · (√max P'·P' − √min P'·P')         P' = (x, y, 0)
/// ```
///
/// so a point within ε of the plane is on it. ε is zero when all points are equally far from the z axis, however much
/// the arithmetic rounds. Even where it is not, it is of the size of one rounding, and the distance of a triangle's own
/// corner from its plane takes several: now and then a corner lies "outside", and a facet is lost. How far away the
/// origin is does no harm, because distances are taken from a corner. Points that coincide make a normal of NaNs,
/// and no point is outside that.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintedArithmetic {
    /// ε.
    pub epsilon: f64,
}

impl PrintedArithmetic {
    /// The kernel with the epsilon of these points.
    ///
    /// # Cost
    ///
    /// O(n).
    ///
    /// ```
    /// use geometry_core::Points;
    /// use gift_wrap::nathan::PrintedArithmetic;
    /// let cylinder = [[1.0, 0.0, 0.0], [0.0, 1.0, 2.0], [-1.0, 0.0, 5.0]];
    /// assert_eq!(PrintedArithmetic::of(Points::new(&cylinder)?).epsilon, 0.0);
    /// # Ok::<(), geometry_core::HullError>(())
    /// ```
    pub fn of(points: Points<'_, 3>) -> Self {
        let squares = points.as_slice().iter().map(|[x, y, _]| x * x + y * y);
        let (smallest, largest) = squares.fold((f64::INFINITY, 0.0), |(smallest, largest), d| {
            (d.min(smallest), d.max(largest))
        });
        let spread = largest.sqrt() - smallest.sqrt();
        Self {
            epsilon: f64::EPSILON * spread.max(0.0),
        }
    }

    fn sign(&self, distance: f64) -> Sign {
        if distance > self.epsilon {
            Sign::Positive
        } else if distance < -self.epsilon {
            Sign::Negative
        } else {
            Sign::Zero
        }
    }
}

impl Kernel3 for PrintedArithmetic {
    fn orient3_staged(&self, a: Point3, b: Point3, c: Point3, d: Point3) -> (Sign, Stage) {
        (self.sign(signed_distance([a, b, c], d)), Stage::Filter)
    }

    fn compare_height_staged(&self, plane: [Point3; 3], p: Point3, q: Point3) -> (Ordering, Stage) {
        let difference = signed_distance(plane, p) - signed_distance(plane, q);
        (self.sign(difference).ordering(), Stage::Filter)
    }

    fn shadow_staged(&self, axis: Axis, a: Point3, b: Point3, c: Point3) -> (Sign, Stage) {
        let [a, b, c] = [a, b, c].map(|p| axis.shadow_of(p));
        let edge = [b[0] - a[0], b[1] - a[1]];
        let length = (edge[0] * edge[0] + edge[1] * edge[1]).sqrt();
        // The cross product of the edge with ẑ: the outward normal of an anticlockwise outline.
        let normal = [edge[1] / length, -edge[0] / length];
        let outward = normal[0] * (c[0] - a[0]) + normal[1] * (c[1] - a[1]);
        (-self.sign(outward), Stage::Filter)
    }
}

/// n̂ · (p − a), for n̂ the unit vector along (b − a) × (c − b).
fn signed_distance([a, b, c]: [Point3; 3], p: Point3) -> f64 {
    let minus = |p: Point3, q: Point3| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let dot = |p: Point3, q: Point3| p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    let (e, f) = (minus(b, a), minus(c, b));
    let normal = [
        e[1] * f[2] - e[2] * f[1],
        e[2] * f[0] - e[0] * f[2],
        e[0] * f[1] - e[1] * f[0],
    ];
    let length = dot(normal, normal).sqrt();
    dot(normal.map(|x| x / length), minus(p, a))
}
