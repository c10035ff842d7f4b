//! Every method of this crate against the conformance suite.

use geometry_core::Method;

fn method(slug: &str) -> &'static Method {
    let found = gift_wrap::METHODS.iter().find(|method| method.slug == slug);
    found.expect("the slug is registered")
}

#[test]
fn jarvis_j1() {
    hull_verify::conformance::planar_hull(method("jarvis-j1"));
}

#[test]
fn jarvis_j2() {
    hull_verify::conformance::planar_hull(method("jarvis-j2"));
}

#[test]
fn jarvis_j3() {
    hull_verify::conformance::planar_hull(method("jarvis-j3"));
}

#[test]
fn nathan() {
    hull_verify::conformance::spatial_hull(method("nathan"));
}

#[test]
fn pivot_wrap() {
    hull_verify::conformance::spatial_hull(method("pivot-wrap"));
}
