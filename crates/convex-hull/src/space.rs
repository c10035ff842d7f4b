//! Hulls in space by the method that fits the points.
//!
//! Where few points are extreme, the quickest way is to throw the others away and to look at what is left; where nearly
//! all are, there is nothing to throw away, and points are best inserted one beside the other. Which it is, is told by a
//! sample: the share of its points that are extreme is at least that of all points (1).
//!
//! 1. A point of the sample that is extreme among all points is extreme in the sample.
//! 2. Both methods are exact, so the choice changes the time and nothing else.
//!
//! In most sets of the first kind that is plain before the hull of the sample is known: some of its points lie in a
//! tetrahedron of four others, or many on a face of the box around it. For sets so small that the hull of a sample would take a
//! good part of the time, the half of the sample about its middle is asked for such a tetrahedron instead.
//!
//! The sample is every so-many-th point, so that the choice is the same on every machine. A set in a perverse order can
//! mislead it, and then costs what the other method costs.

use geometry_core::{
    Basis, Exact, Hull3, HullError, Kernel3, Method, Observer, Point3, Points, Silent, spatial_task,
};
use incremental::incremental_brio;
use quickhull::{fast_3d, fast_3d_parallel, fast_3d_unseen};

/// The methods that are made of methods of several families.
pub(crate) const METHODS: &[Method] = &[Method {
    slug: "hull-3d",
    title: "Discarding or inserting, whichever fits a sample of the points",
    citation: "This project; the estimate from a sample is that of Y. Wang, R. Yesantharao, S. Yu, L. Dhulipala, Y. Gu, \
               J. Shun, ParGeo: a library for parallel computational geometry, ESA 2022",
    departures: &[],
    cost: "that of fast-3d or of incremental-brio: O(n) on average where few points are extreme, else O(n log n) expected",
    task: spatial_task!(hull_3d, |points| hull_3d_unseen(points, &Exact)),
}];

/// So few points are inserted without looking at them.
const FEW: usize = 24;

/// With fewer points, the hull of a sample does not pay.
const SAMPLED_FROM: usize = 1024;

/// A sample has one of so many points, but no fewer than [`SMALLEST`] and no more than [`LARGEST`].
const EVERY: usize = 16;

/// The smallest sample.
const SMALLEST: usize = 64;

/// The largest sample.
const LARGEST: usize = 200;

/// With so many points of a sample deep inside, its hull need not be known: they are more than strays.
const DEEP: usize = 2;

/// With one of so many points of a sample on one face of the box around it, they are more than its corners.
const ON_FACE: usize = 8;

/// A point is deep inside a tetrahedron if its weights are above this.
const MARGIN: f64 = 1.0 / (1 << 20) as f64;

/// The hull of `points`, by `incremental-brio` where most seem to be extreme, else by `fast-3d`.
pub(crate) fn hull_3d<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    if mostly_extreme(points.as_slice(), kernel)? {
        incremental_brio(points, kernel, observer)
    } else {
        fast_3d(points, kernel, observer)
    }
}

/// [`hull_3d`] of points that nobody has looked at yet.
pub(crate) fn hull_3d_unseen<K: Kernel3>(
    points: &[Point3],
    kernel: &K,
) -> Result<Hull3, HullError> {
    unseen(points, kernel, fast_3d_unseen)
}

/// [`hull_3d_unseen`] on the processors of the current rayon thread pool, where discarding fits the points; insertion runs on
/// one.
pub(crate) fn hull_3d_parallel(points: &[Point3]) -> Result<Hull3, HullError> {
    unseen(points, &Exact, fast_3d_parallel)
}

fn unseen<K: Kernel3>(
    points: &[Point3],
    kernel: &K,
    discard: fn(&[Point3], &K) -> Result<Hull3, HullError>,
) -> Result<Hull3, HullError> {
    let is_mostly_extreme = mostly_extreme(points, kernel);
    // What is wrong with a sample is wrong with all; the error is to name the first.
    match is_mostly_extreme {
        Ok(false) => discard(points, kernel),
        _ => incremental_brio(Points::new(points)?, kernel, &mut Silent),
    }
}

/// How many of the points lie in a tetrahedron of four of them that are far apart: these are certainly not extreme, but
/// for rounding.
fn deep(sample: &[Point3]) -> usize {
    let furthest = |measure: &dyn Fn(&Point3) -> f64| {
        let further = |best: (f64, Point3), p: &Point3| {
            let measure = measure(p);
            if measure > best.0 {
                (measure, *p)
            } else {
                best
            }
        };
        sample.iter().fold((f64::NEG_INFINITY, [0.0; 3]), further).1
    };
    let a = furthest(&|p| p[0]);
    let b = furthest(&|p| -p[0]);
    let along = minus(b, a);
    let c = furthest(&|p| {
        let w = cross(along, minus(*p, a));
        dot(w, w)
    });
    let normal = cross(along, minus(c, a));
    let d = furthest(&|p| dot(normal, minus(*p, a)).abs());
    // The inward normals of three faces at a, and of the one opposite.
    let [u, v, w] = [b, c, d].map(|corner| minus(corner, a));
    let volume = dot(cross(u, v), w);
    let [of_u, of_v, of_w] = [cross(v, w), cross(w, u), cross(u, v)];
    let least = MARGIN * volume;
    let is_deep = |p: &&Point3| {
        let p = minus(**p, a);
        let weights = [of_u, of_v, of_w].map(|normal| dot(normal, p));
        let rest = volume - weights[0] - weights[1] - weights[2];
        // Divided by the volume, they are the weights of the four corners.
        [weights[0], weights[1], weights[2], rest]
            .iter()
            .all(|&weight| (weight - least) * volume.signum() > 0.0)
    };
    sample.iter().filter(is_deep).count()
}

/// The half of the points that is closer to their middle: where some points lie far out, the others may be close together beside a
/// tetrahedron of those.
fn inner_half(sample: &[Point3]) -> Vec<Point3> {
    let mut numbers: Vec<f64> = Vec::with_capacity(sample.len());
    let mut median = |values: &mut dyn Iterator<Item = f64>| {
        numbers.clear();
        numbers.extend(values);
        let half = numbers.len() / 2;
        *numbers.select_nth_unstable_by(half, f64::total_cmp).1
    };
    let middle = [0, 1, 2].map(|axis| median(&mut sample.iter().map(|p| p[axis])));
    let distance = |p: &Point3| {
        let w = minus(*p, middle);
        dot(w, w)
    };
    let reach = median(&mut sample.iter().map(distance));
    let is_inner = |p: &&Point3| distance(p) < reach;
    sample.iter().filter(is_inner).copied().collect()
}

/// Whether one in [`ON_FACE`] of the points lies on one face of the box around them.
fn many_on_a_face(sample: &[Point3]) -> bool {
    (0..3).any(|axis| {
        let along = || sample.iter().map(|p| p[axis]);
        let ends = [
            along().fold(f64::INFINITY, f64::min),
            along().fold(f64::NEG_INFINITY, f64::max),
        ];
        ends.into_iter()
            .any(|end| ON_FACE * along().filter(|&x| x == end).count() >= sample.len())
    })
}

/// Whether the points are few, or most of them seem to be extreme.
fn mostly_extreme<K: Kernel3>(points: &[Point3], kernel: &K) -> Result<bool, HullError> {
    if points.len() < FEW {
        return Ok(true);
    }
    let size = (points.len() / EVERY).clamp(SMALLEST, LARGEST);
    let size = size.min(points.len());
    let sample: Vec<Point3> = (0..size).map(|i| points[i * points.len() / size]).collect();
    let is_about_coordinates = kernel.basis() == Basis::Coordinates;
    if is_about_coordinates && (deep(&sample) >= DEEP || many_on_a_face(&sample)) {
        return Ok(false);
    }
    if points.len() < SAMPLED_FROM {
        return Ok(!is_about_coordinates || deep(&inner_half(&sample)) < DEEP);
    }
    let hull = incremental_brio(Points::new(&sample)?, kernel, &mut Silent)?;
    Ok(5 * hull.len() >= 4 * size)
}

fn minus(p: Point3, q: Point3) -> Point3 {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn dot(u: Point3, v: Point3) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

fn cross(u: Point3, v: Point3) -> Point3 {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_mostly_extreme(set: &str, n: usize) -> bool {
        let spec: point_sets::Spec = set.parse().expect("a set");
        let points = spec.generate3(n, 3).expect("points");
        mostly_extreme(&points, &Exact).expect("a hull")
    }

    #[test]
    fn samples_tell_spheres_from_balls() {
        for n in [100, 1_000, 5_000] {
            for set in ["sphere", "paraboloid", "moment-curve"] {
                assert!(is_mostly_extreme(set, n), "{set}, {n}");
            }
            for set in [
                "ball",
                "cube",
                "normal3",
                "cauchy3",
                "cubic-lattice",
                "cube-faces",
            ] {
                assert!(!is_mostly_extreme(set, n), "{set}, {n}");
            }
        }
    }

    #[test]
    fn no_point_of_a_sphere_is_deep_and_many_of_a_ball_are() {
        let deep_in = |set: &str| {
            let spec: point_sets::Spec = set.parse().expect("a set");
            deep(&spec.generate3(LARGEST, 5).expect("points"))
        };
        for set in ["sphere", "paraboloid", "moment-curve"] {
            assert_eq!(deep_in(set), 0, "{set}");
        }
        for set in ["ball", "cube", "normal3"] {
            assert!(deep_in(set) >= DEEP, "{set}");
        }
        let inner = |set: &str| {
            let spec: point_sets::Spec = set.parse().expect("a set");
            inner_half(&spec.generate3(SMALLEST, 5).expect("points"))
        };
        assert_eq!(deep(&inner("sphere")), 0);
        assert!(deep(&inner("cauchy3")) >= DEEP);
        assert_eq!(deep(&[]), 0);
        assert_eq!(deep(&[[1.0; 3]; 9]), 0);
    }

    #[test]
    fn either_way_the_hull_is_that_of_quickhull() {
        for set in ["sphere", "ball", "cubic-lattice"] {
            for n in [30, 2_000] {
                let spec: point_sets::Spec = set.parse().expect("a set");
                let points = spec.generate3(n, 4).expect("points");
                let points = Points::new(&points).expect("finite");
                let ours = hull_3d(points, &Exact, &mut Silent).expect("a hull");
                let other = quickhull::quickhull_3d(points, &Exact, &mut Silent);
                assert_eq!(Ok(ours), other, "{set} {n}");
            }
        }
    }
}
