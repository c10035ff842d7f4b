//! The checker on hulls in space broken on purpose: each kind of breakage is rejected, with the right finding.

mod flat;
mod points;
mod surfaces;

use geometry_core::hull3::Solid;
use geometry_core::{Hull3, Point3};
use hull_verify::check::{self, Finding3};
use hull_verify::{families_space, oracle};

type Facets = Vec<Vec<u32>>;

/// Every family with its hull by the oracle.
fn hulls() -> Vec<(&'static str, Vec<Point3>, Hull3)> {
    families_space::all()
        .into_iter()
        .map(|family| {
            let hull = oracle::hull3(&family.points);
            (family.name, family.points, hull)
        })
        .collect()
}

/// The families that span space, with their facets by the oracle.
fn solids() -> Vec<(&'static str, Vec<Point3>, Facets)> {
    hulls()
        .into_iter()
        .filter_map(|(name, points, hull)| match hull {
            Hull3::Solid(solid) => Some((name, points, solid.facets().map(Vec::from).collect())),
            _ => None,
        })
        .collect()
}

fn solid(facets: Facets) -> Hull3 {
    Hull3::Solid(Solid::from_loops(facets))
}

fn findings(points: &[Point3], hull: &Hull3) -> Vec<Finding3> {
    check::hull3(points, hull).expect_err("a broken hull was certified")
}

/// The corners of a cube: bit i of the index is coordinate i.
///
/// ```text
///       6-----7
///      /|    /|        z
///     4-----5 |        |  y
///     | 2---|-3        | /
///     |/    |/         |/
///     0-----1          +----x
/// ```
fn cube() -> Vec<Point3> {
    (0..8_u32)
        .map(|corner| [0, 1, 2].map(|axis| f64::from(corner >> axis & 1)))
        .collect()
}

/// Bottom, front, left, top, back, right, each anticlockwise seen from outside.
fn cube_facets() -> Facets {
    vec![
        vec![0, 2, 3, 1],
        vec![0, 1, 5, 4],
        vec![0, 4, 6, 2],
        vec![4, 5, 7, 6],
        vec![2, 6, 7, 3],
        vec![1, 3, 7, 5],
    ]
}

#[test]
fn right_hulls_are_certified_and_the_points_accounted_for() {
    for (name, points, hull) in hulls() {
        let certificate = check::hull3(&points, &hull).unwrap_or_else(|findings| {
            panic!("{name}: {findings:?}");
        });
        let found = certificate.copies + certificate.on_boundary + certificate.inside;
        assert_eq!(certificate.h + found, certificate.n, "{name}");
        assert_eq!(certificate.dimension, hull.dimension());
        let mut places: Vec<Point3> = points.iter().map(|p| p.map(|x| x + 0.0)).collect();
        places.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
        places.dedup();
        let copies = points.len() - places.len();
        assert!(certificate.copies <= copies, "{name}");
    }
}

#[test]
fn points_of_a_lattice_are_located() {
    // The 5 x 5 x 5 lattice: 8 corners, 98 points on the surface, 3 x 3 x 3 inside.
    let points = families_space::grids::lattice(5);
    let certificate = check::hull3(&points, &oracle::hull3(&points)).expect("right");
    assert_eq!(
        (certificate.h, certificate.on_boundary, certificate.inside),
        (8, 90, 27)
    );
    assert_eq!((certificate.edges, certificate.facets), (12, 6));
    assert_eq!((certificate.bits, certificate.dimension), (3, Some(3)));
    let doubled = families_space::few::twice(points);
    let certificate = check::hull3(&doubled, &oracle::hull3(&doubled)).expect("right");
    assert_eq!(
        (
            certificate.copies,
            certificate.on_boundary,
            certificate.inside
        ),
        (8, 180, 54)
    );
}
