//! Every method of this crate against the conformance suite.

use geometry_core::Method;
use hull_verify::conformance::{planar_hull, planar_layers};

fn method(slug: &str) -> &'static Method {
    let found = planar_peeling::METHODS
        .iter()
        .find(|method| method.slug == slug);
    found.expect("the slug is registered")
}

#[test]
fn gs() {
    planar_hull(method("gs"));
}

#[test]
fn gs_bare() {
    planar_hull(method("gs-bare"));
}

#[test]
fn graham() {
    planar_hull(method("graham"));
}

#[test]
fn monotone_chain() {
    planar_hull(method("monotone-chain"));
}

#[test]
fn gs_peel() {
    planar_layers(method("gs-peel"));
}

#[test]
fn chain_peel() {
    planar_layers(method("chain-peel"));
}

#[test]
fn fast_layers() {
    planar_layers(method("fast-layers"));
}
