//! Every method of this crate through the whole suite.

#[test]
fn every_method_conforms() {
    for method in lifted_delaunay::METHODS {
        hull_verify::conformance::delaunay(method);
    }
}
