//! Every method of this crate against the conformance suite.

use geometry_core::Method;

fn method(slug: &str) -> &'static Method {
    let found = quickhull::METHODS.iter().find(|method| method.slug == slug);
    found.expect("the slug is registered")
}

#[test]
fn eddy() {
    hull_verify::conformance::planar_hull(method("eddy"));
}

#[test]
fn fast_2d() {
    hull_verify::conformance::planar_hull(method("fast-2d"));
}

#[test]
fn fast_2d_parallel() {
    hull_verify::conformance::planar_hull(method("fast-2d-parallel"));
}

#[test]
fn quickhull_balan() {
    hull_verify::conformance::spatial_hull(method("quickhull-balan"));
}

#[test]
fn quickhull_3d() {
    hull_verify::conformance::spatial_hull(method("quickhull-3d"));
}

#[test]
fn fast_3d() {
    hull_verify::conformance::spatial_hull(method("fast-3d"));
}
