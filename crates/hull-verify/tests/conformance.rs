//! The suite itself: it passes a right method, and catches wrong ones.

use geometry_core::{
    Boundary, Hull2, HullError, Kernel2, Layers, Method, Observer, Points, planar_task,
};
use hull_verify::{conformance, oracle};

fn method(slug: &'static str, task: geometry_core::Task) -> Method {
    Method {
        slug,
        title: "a method for testing the suite",
        citation: "",
        departures: &[],
        cost: "",
        task,
    }
}

type Answer<A> = Result<A, HullError>;

fn right_hull<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    _: &K,
    _: &mut O,
) -> Answer<Hull2> {
    Ok(oracle::hull2(points.as_slice(), boundary))
}

fn right_layers<K: Kernel2, O: Observer>(
    points: Points<'_, 2>,
    boundary: Boundary,
    _: &K,
    _: &mut O,
) -> Answer<Layers> {
    Ok(oracle::layers(points.as_slice(), boundary))
}

#[test]
fn right_methods_pass() {
    conformance::planar_hull(&method("right-hull", planar_task!(PlanarHull, right_hull)));
    conformance::planar_layers(&method(
        "right-layers",
        planar_task!(PlanarLayers, right_layers),
    ));
}
