//! Every registered method through the builder, and what the builder refuses.

use hullkit::{Boundary, BuildError, Builder, Processors, Task};

fn plane() -> Vec<[f64; 2]> {
    let spec: point_sets::Spec = "lattice".parse().expect("a set");
    spec.generate(60, 3).expect("points")
}

fn space() -> Vec<[f64; 3]> {
    let spec: point_sets::Spec = "cubic-lattice".parse().expect("a set");
    spec.generate3(60, 3).expect("points")
}

#[test]
fn every_method_gives_the_same_value_through_the_builder() {
    let (plane, space) = (plane(), space());
    for method in hullkit::methods() {
        let builder = Builder::new().method(method.slug).expect("registered");
        let all = builder.boundary(Boundary::All);
        match method.task {
            Task::PlanarHull(_) => assert_eq!(
                all.convex_hull_2d(&plane),
                Ok(hullkit::convex_hull_2d_with(&plane, Boundary::All).expect("a hull")),
                "{}",
                method.slug
            ),
            Task::PlanarLayers(_) => assert_eq!(
                all.convex_layers(&plane),
                Ok(hullkit::convex_layers(&plane, Boundary::All).expect("layers")),
                "{}",
                method.slug
            ),
            Task::SpatialHull(_) => assert_eq!(
                builder.convex_hull_3d(&space),
                Ok(hullkit::convex_hull_3d(&space).expect("a hull")),
                "{}",
                method.slug
            ),
            Task::Delaunay(_) => assert_eq!(
                builder.delaunay(&plane),
                Ok(hullkit::delaunay(&plane).expect("triangles")),
                "{}",
                method.slug
            ),
            other => panic!("{other:?} has no word in the builder"),
        }
    }
}

#[test]
fn a_pool_changes_nothing_but_the_time() {
    let (plane, space) = (plane(), space());
    let one = Builder::new();
    let pool = one.processors(Processors::Pool);
    assert_eq!(pool.convex_hull_2d(&plane), one.convex_hull_2d(&plane));
    assert_eq!(pool.convex_hull_3d(&space), one.convex_hull_3d(&space));
    assert_eq!(pool.convex_layers(&plane), one.convex_layers(&plane));
    assert_eq!(pool.delaunay(&plane), one.delaunay(&plane));
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let (plane, space) = (plane(), space());
    let gs = Builder::new().method("gs").expect("registered");
    let said = [
        Builder::new().method("ggs").map(drop).expect_err("unknown"),
        gs.convex_hull_3d(&space).expect_err("planar"),
        gs.delaunay(&plane).expect_err("a hull"),
        gs.processors(Processors::Pool)
            .convex_hull_2d(&plane)
            .expect_err("one processor"),
        Builder::new()
            .boundary(Boundary::All)
            .convex_hull_3d(&space)
            .expect_err("one convention"),
        gs.convex_hull_2d(&[[f64::NAN, 0.0]])
            .expect_err("not finite"),
    ]
    .map(|error: BuildError| error.to_string());
    let expected = [
        "no method is called 'ggs'",
        "'gs' does not compute hulls of points of space",
        "'gs' does not compute triangulations",
        "'gs' runs on one processor",
        "which boundary points are vertices",
        "point 0",
    ];
    for (said, expected) in said.iter().zip(expected) {
        assert!(said.contains(expected), "{said}");
    }
}
