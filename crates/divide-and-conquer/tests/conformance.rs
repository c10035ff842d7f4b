//! Every method of this crate against the conformance suite.

use geometry_core::Method;

fn method(slug: &str) -> &'static Method {
    let found = divide_and_conquer::METHODS
        .iter()
        .find(|method| method.slug == slug);
    found.expect("the slug is registered")
}

#[test]
fn preparata_hong_2d() {
    hull_verify::conformance::planar_hull(method("preparata-hong-2d"));
}

#[test]
fn preparata_hong_3d() {
    hull_verify::conformance::spatial_hull(method("preparata-hong-3d"));
}

#[test]
fn preparata_hong_rescan() {
    hull_verify::conformance::spatial_hull(method("preparata-hong-rescan"));
}

#[test]
fn preparata_hong_balan() {
    hull_verify::conformance::spatial_hull(method("preparata-hong-balan"));
}

#[test]
fn preparata_hong_parallel() {
    hull_verify::conformance::spatial_hull(method("preparata-hong-parallel"));
}
