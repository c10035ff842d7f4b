//! The suite in space: it passes a right method, and catches wrong ones.

mod beneath_beyond;

use beneath_beyond::right_hull;
use geometry_core::hull3::Solid;
use geometry_core::{
    Hull3, HullError, Kernel3, Method, Observer, Points, Sign, Task, planar_task, spatial_task,
};
use hull_verify::conformance;

fn method(slug: &'static str, task: Task) -> Method {
    Method {
        slug,
        title: "a method for testing the suite",
        citation: "",
        departures: &[],
        cost: "",
        task,
    }
}

type Answer = Result<Hull3, HullError>;

#[test]
fn a_right_method_passes() {
    conformance::spatial_hull(&method("right-hull-3d", spatial_task!(right_hull)));
}

/// Right, but for copies: the largest index stands for them.
fn largest_copies<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Answer {
    let largest = |id: &u32| {
        let mut copies = points.ids().filter(|&other| points[other] == points[*id]);
        copies.next_back().unwrap_or(*id)
    };
    Ok(match right_hull(points, kernel, observer)? {
        Hull3::Point(id) => Hull3::Point(largest(&id)),
        Hull3::Solid(solid) => {
            let facets = solid
                .facets()
                .map(|facet| facet.iter().map(largest).collect());
            Hull3::Solid(Solid::from_loops(facets.collect()))
        }
        other => other,
    })
}

/// Does not merge coplanar triangles.
fn triangles<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Answer {
    let hull = right_hull(points, kernel, observer)?;
    let triangles: Vec<Vec<u32>> = hull.triangles().map(Vec::from).collect();
    Ok(match hull {
        Hull3::Solid(_) => Hull3::Solid(Solid::from_loops(triangles)),
        flat => flat,
    })
}

/// Forgets the last of more than 400 points: no small set shows it.
fn drops_the_last_of_many<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Answer {
    let slice = points.as_slice();
    let kept = if slice.len() > 400 {
        slice.len() - 1
    } else {
        slice.len()
    };
    right_hull(Points::new(&slice[..kept])?, kernel, observer)
}

/// Takes it for granted that of two opposite orientations one is positive.
fn trusts_the_kernel<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Answer {
    if let [a, b, c, d, ..] = *points.as_slice() {
        let signs = [kernel.orient3(a, b, c, d), kernel.orient3(b, a, c, d)];
        assert_eq!(signs[0], -signs[1], "the kernel contradicts itself");
    }
    right_hull(points, kernel, observer)
}

/// Asks again until the answer is positive.
fn never_stops<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    observer: &mut O,
) -> Answer {
    if let [a, b, c, d, ..] = *points.as_slice() {
        let sign = |flip: bool| {
            if flip {
                kernel.orient3(b, a, c, d)
            } else {
                kernel.orient3(a, b, c, d)
            }
        };
        while sign(false) == Sign::Negative && sign(true) == Sign::Negative {}
    }
    right_hull(points, kernel, observer)
}

/// The message with which the suite rejects the method.
fn rejection(slug: &'static str, task: Task) -> String {
    let method = method(slug, task);
    let panic = std::panic::catch_unwind(|| conformance::spatial_hull(&method))
        .expect_err("a wrong method passed the suite");
    panic
        .downcast_ref::<String>()
        .expect("the suite panics with a report")
        .clone()
}

#[test]
fn wrong_methods_are_rejected_with_a_report() {
    let report = rejection("largest-copies-3d", spatial_task!(largest_copies));
    assert!(
        report.contains("largest-copies-3d (exact) fails"),
        "{report}"
    );
    assert!(report.contains("which should stand for it"), "{report}");

    let report = rejection("triangles-3d", spatial_task!(triangles));
    assert!(report.contains("are in one plane"), "{report}");

    let report = rejection("drops-last-3d", spatial_task!(drops_the_last_of_many));
    assert!(report.contains("lies outside"), "{report}");

    let report = rejection("trusts-3d", spatial_task!(trusts_the_kernel));
    assert!(report.contains("it panicked: "), "{report}");
    assert!(report.contains("the kernel contradicts itself"), "{report}");

    let report = rejection("never-stops-3d", spatial_task!(never_stops));
    assert!(report.contains("the method does not stop"), "{report}");
}

#[test]
fn a_method_for_another_task_is_refused() {
    fn planar<K: geometry_core::Kernel2, O: Observer>(
        _: Points<'_, 2>,
        _: geometry_core::Boundary,
        _: &K,
        _: &mut O,
    ) -> Result<geometry_core::Hull2, HullError> {
        Ok(geometry_core::Hull2::Empty)
    }
    let report = rejection("planar", planar_task!(PlanarHull, planar));
    assert_eq!(report, "planar does not compute hulls in space");
}
