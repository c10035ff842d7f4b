//! The paper's third stage of testing (section 5): no point may lie beyond the plane of a face.
//!
//! The origin is moved to a point inside the hull. For a face with corners p₁, p₂, p₃, always in the same order seen from
//! outside, and a point x, all relative to the new origin,
//!
//! ```text
//!     F(x) = x · (p₁ × p₂ + p₂ × p₃ + p₃ × p₁) - [p₁, p₂, p₃]
//! ```
//!
//! is six times the volume between the face and x, so that it has one sign for all points and all faces of a hull. The
//! check says nothing of faces that are missing.

use geometry_core::tolerance::formats::Format;
use geometry_core::{Exact, Kernel3, Point3};

/// Whether no point is beyond a face by F(x) as computed in the format `F`, zero allowed.
pub(crate) fn accepts<F: Format>(points: &[Point3], faces: &[[u32; 3]]) -> bool {
    let moved = moved::<F>(points);
    faces.iter().all(|&corners| {
        let [p1, p2, p3] = corners.map(|id| moved[id as usize]);
        let normal = sum(sum(cross(p1, p2), cross(p2, p3)), cross(p3, p1));
        let volume = product(cross(p1, p2), p3);
        let beyond = |x: [F; 3]| product(x, normal).minus(volume).to_f64() > 0.0;
        let others = (0_u32..).zip(&moved);
        !others
            .filter(|(id, _)| !corners.contains(id))
            .any(|(_, &x)| beyond(x))
    })
}

/// The same by exact orientations.
pub(crate) fn accepts_exactly(points: &[Point3], faces: &[[u32; 3]]) -> bool {
    faces.iter().all(|corners| {
        let [p1, p2, p3] = corners.map(|id| points[id as usize]);
        let beyond = |&x: &Point3| Exact.orient3(p1, p2, p3, x).is_positive();
        !points.iter().any(beyond)
    })
}

/// The points relative to their mean, which is inside.
fn moved<F: Format>(points: &[Point3]) -> Vec<[F; 3]> {
    let part = 1.0 / points.len() as f64;
    let mean = [0, 1, 2].map(|axis| points.iter().map(|p| p[axis] * part).sum::<f64>());
    let moved = |p: &Point3| [0, 1, 2].map(|axis| F::of(p[axis]).minus(F::of(mean[axis])));
    points.iter().map(moved).collect()
}

fn cross<F: Format>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    let minor = |i: usize, j: usize| p[i].times(q[j]).minus(p[j].times(q[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn sum<F: Format>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    [0, 1, 2].map(|i| p[i].plus(q[i]))
}

fn product<F: Format>(p: [F; 3], q: [F; 3]) -> F {
    let [x, y, z] = [0, 1, 2].map(|i| p[i].times(q[i]));
    x.plus(y).plus(z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::sets::PointSet3;
    use geometry_core::tolerance::formats::{Double, Extended};

    #[test]
    fn right_hulls_pass_and_a_face_too_deep_does_not() {
        let set = PointSet3::generate(1, "ball", 60, 0).expect("a set");
        let hull = hullkit::convex_hull_3d(&set.points).expect("finite");
        let faces: Vec<[u32; 3]> = hull.triangles().collect();
        assert!(accepts_exactly(&set.points, &faces));
        assert!(accepts::<Double>(&set.points, &faces));
        assert!(accepts::<Extended>(&set.points, &faces));
        let inside = (0..60).find(|id| !hull.vertices().contains(id));
        let mut wrong = faces.clone();
        wrong[0][0] = inside.expect("a point inside");
        let mut turned = faces.clone();
        turned[3].swap(0, 1);
        for faces in [wrong, turned] {
            assert!(!accepts_exactly(&set.points, &faces));
            assert!(!accepts::<Double>(&set.points, &faces));
            assert!(!accepts::<Extended>(&set.points, &faces));
        }
        // What is missing is not seen.
        assert!(accepts_exactly(&set.points, &faces[1..]));
    }
}
