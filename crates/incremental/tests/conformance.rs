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
