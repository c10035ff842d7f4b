//! The method of the front door for space against the conformance suite.

#[test]
fn hull_3d() {
    let method = hullkit::method("hull-3d").expect("a registered slug");
    hull_verify::conformance::spatial_hull(method);
}
