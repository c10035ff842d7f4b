//! Every method of this crate against the conformance suite.

use geometry_core::Method;

fn method(slug: &str) -> &'static Method {
    let found = incremental::METHODS
        .iter()
        .find(|method| method.slug == slug);
    found.expect("the slug is registered")
}

#[test]
fn incremental_r() {
    hull_verify::conformance::planar_hull(method("incremental-r"));
}

#[test]
fn incremental_3d() {
    hull_verify::conformance::spatial_hull(method("incremental-3d"));
}

#[test]
fn incremental_conflict() {
    hull_verify::conformance::spatial_hull(method("incremental-conflict"));
}

#[test]
fn incremental_brio() {
    hull_verify::conformance::spatial_hull(method("incremental-brio"));
}
