//! Broken lists, broken topology, broken shape.

use super::{cube, cube_facets, findings, solid, solids};
use geometry_core::{Hull3, Point3};
use hull_verify::check::{self, Finding3};
use hull_verify::families_space::round;
use std::f64::consts::TAU;

#[test]
fn a_cube_is_a_cube() {
    assert!(check::hull3(&cube(), &solid(cube_facets())).is_ok());
}

#[test]
fn ids_that_are_none() {
    let mut facets = cube_facets();
    facets[3][2] = 8;
    let expected = [Finding3::NoSuchPoint { id: 8, count: 8 }];
    assert_eq!(findings(&cube(), &solid(facets)), expected);
    let no_facet = Finding3::Euler {
        vertices: 0,
        edges: 0,
        facets: 0,
    };
    assert_eq!(findings(&cube(), &solid(vec![])), [no_facet]);
    let mut facets = cube_facets();
    facets.push(vec![0, 7]);
    let expected = [Finding3::FewCorners { facet: 3, count: 2 }];
    assert_eq!(findings(&cube(), &solid(facets)), expected);
}

#[test]
fn vertices_that_are_equal() {
    let mut points = cube();
    points.push([1.0, 1.0, 1.0]);
    let mut facets = cube_facets();
    facets[3][2] = 8;
    let expected = [Finding3::EqualVertices {
        first: 7,
        second: 8,
    }];
    assert_eq!(findings(&points, &solid(facets)), expected);
}

#[test]
fn a_missing_facet_leaves_open_edges() {
    for (name, points, facets) in solids() {
        for missing in 0..facets.len() {
            let mut rest = facets.clone();
            let corners = rest.remove(missing).len();
            let found = findings(&points, &solid(rest));
            let open = |finding: &Finding3| matches!(finding, Finding3::OpenEdge { .. });
            assert!(
                found.iter().all(open) && found.len() == corners,
                "{name}: {found:?}"
            );
        }
    }
}

#[test]
fn a_facet_listed_twice_shares_its_edges() {
    for (name, points, facets) in solids() {
        let mut more = facets.clone();
        more.push(facets[facets.len() / 2].clone());
        let found = findings(&points, &solid(more));
        let shared = |finding: &Finding3| matches!(finding, Finding3::SharedEdge { .. });
        assert!(found.iter().all(shared), "{name}: {found:?}");
    }
}

#[test]
fn a_reversed_facet_shares_its_edges() {
    let mut facets = cube_facets();
    facets[2].reverse();
    let found = findings(&cube(), &solid(facets));
    assert!(
        found.contains(&Finding3::SharedEdge {
            from: 2,
            to: 6,
            facets: [2, 4]
        }),
        "{found:?}"
    );
    assert_eq!(found.len(), 4);
}

#[test]
fn all_facets_reversed() {
    for (name, points, mut facets) in solids() {
        facets.iter_mut().for_each(|facet| facet.reverse());
        assert_eq!(
            findings(&points, &solid(facets)),
            [Finding3::InsideOut],
            "{name}"
        );
    }
}

#[test]
fn coplanar_triangles_are_not_facets() {
    let mut facets = cube_facets();
    facets.push(facets[0][..3].to_vec());
    facets[0] = vec![0, 3, 1];
    let found = findings(&cube(), &solid(facets));
    assert!(
        matches!(found[..], [Finding3::CoplanarFacets { .. }]),
        "{found:?}"
    );
    for (name, points, facets) in solids() {
        let triangles: Vec<Vec<u32>> = facets
            .iter()
            .flat_map(|facet| (2..facet.len()).map(|i| vec![facet[0], facet[i - 1], facet[i]]))
            .collect();
        let cut = triangles.len() - facets.len();
        if cut > 0 {
            let found = findings(&points, &solid(triangles));
            let coplanar = |f: &Finding3| matches!(f, Finding3::CoplanarFacets { .. });
            assert!(
                found.iter().all(coplanar) && found.len() == cut,
                "{name}: {found:?}"
            );
        }
    }
}

#[test]
fn a_facet_that_is_not_planar() {
    let mut points = cube();
    points[7] = [1.0, 1.0, 1.5];
    let found = findings(&points, &solid(cube_facets()));
    assert_eq!(
        found,
        [Finding3::OffPlane {
            facet: 5,
            corner: 6
        }]
    );
    // The last bit is enough.
    points[7] = [1.0, 1.0, 1.0_f64.next_up()];
    let found = findings(&points, &solid(cube_facets()));
    assert_eq!(
        found,
        [Finding3::OffPlane {
            facet: 5,
            corner: 6
        }]
    );
}

#[test]
fn a_corner_in_the_middle_of_an_edge() {
    let mut points = cube();
    points.push([0.5, 0.0, 0.0]);
    let mut facets = cube_facets();
    facets[0] = vec![0, 2, 3, 1, 8];
    facets[1] = vec![0, 8, 1, 5, 4];
    let found = findings(&points, &solid(facets));
    // Facet 0 is 0 2 3 1 8; facet 2 is 0 8 1 5 4, whose first three corners span no plane.
    let expected = [
        Finding3::NoCorner {
            facet: 0,
            corner: 8,
        },
        Finding3::FlatFacet { facet: 2 },
    ];
    assert_eq!(found, expected);
}

#[test]
fn a_facet_with_a_notch_is_reflex() {
    let mut points = cube();
    points.push([0.5, 0.25, 0.0]);
    let mut facets = cube_facets();
    facets[0] = vec![0, 2, 3, 1, 8];
    facets[1] = vec![0, 8, 1, 5, 4];
    let found = findings(&points, &solid(facets));
    assert!(
        found.contains(&Finding3::ReflexCorner {
            facet: 0,
            corner: 8
        }),
        "{found:?}"
    );
}

#[test]
fn a_facet_that_goes_round_twice() {
    let points = round::cone(5);
    let right = |from: u32, to: u32| vec![from, to, 5];
    let star = [0, 2, 4, 1, 3];
    let mut facets: Vec<Vec<u32>> = (0..5).map(|i| right(star[i], star[(i + 1) % 5])).collect();
    facets.push(star.iter().rev().copied().collect());
    let found = findings(&points, &solid(facets));
    assert_eq!(
        found,
        [Finding3::FacetWinding {
            facet: 1,
            revolutions: 2
        }]
    );
}

/// A bipyramid over a pentagram: every edge is convex, V - E + F = 2, and it goes round twice.
///
/// ```text
///            5
///          // \\
///       0 -------- 2          0 → 2 → 4 → 1 → 3 → 0
///          \\ //
///            6
/// ```
#[test]
fn a_surface_that_goes_round_twice() {
    let star = [0, 2, 4, 1, 3];
    let corner = |i: u32| {
        let angle = TAU * f64::from(i) / 5.0;
        [angle.cos(), angle.sin(), 0.0]
    };
    let mut upright: Vec<Point3> = (0..5).map(corner).collect();
    upright.extend([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]);
    let facets: Vec<Vec<u32>> = (0..5)
        .flat_map(|i| {
            let (from, to) = (star[i], star[(i + 1) % 5]);
            [vec![from, to, 5], vec![to, from, 6]]
        })
        .collect();
    let found = findings(&upright, &solid(facets.clone()));
    assert_eq!(found, [Finding3::OutlineWinding { revolutions: 2 }]);
    // Seen from the side the outline is something else, but never that of a convex body.
    let lying: Vec<Point3> = upright.iter().map(|&[x, y, z]| [y, z, x]).collect();
    let tilted: Vec<Point3> = upright
        .iter()
        .map(|&[x, y, z]| [x + 2.0 * z, y - z, 3.0 * x + y + 9.0 * z])
        .collect();
    for points in [lying, tilted] {
        let found = findings(&points, &solid(facets.clone()));
        let outline = |finding: &Finding3| {
            matches!(
                finding,
                Finding3::OutlineBreaks { .. } | Finding3::OutlineWinding { .. }
            )
        };
        assert!(found.iter().all(outline), "{found:?}");
    }
}

#[test]
fn a_dented_body_has_reflex_edges() {
    // The cube with a pyramid pushed into its top.
    let mut points = cube();
    points.push([0.5, 0.5, 0.5]);
    let mut facets = cube_facets();
    facets.remove(3);
    facets.extend([[4, 5, 8], [5, 7, 8], [7, 6, 8], [6, 4, 8]].map(Vec::from));
    let found = findings(&points, &solid(facets));
    let reflex = |finding: &Finding3| matches!(finding, Finding3::ReflexEdge { .. });
    assert!(found.iter().all(reflex) && found.len() == 4, "{found:?}");
}

#[test]
fn two_bodies() {
    let mut points = cube();
    points.extend(cube().iter().map(|&[x, y, z]| [x + 5.0, y, z]));
    let mut facets = cube_facets();
    facets.extend(
        cube_facets()
            .iter()
            .map(|facet| facet.iter().map(|id| id + 8).collect()),
    );
    let found = findings(&points, &solid(facets));
    assert_eq!(found, [Finding3::Disconnected { facet: 6 }]);
    // Touching in one vertex.
    let touching: Vec<Point3> = cube().iter().map(|p| p.map(|x| x + 1.0)).collect();
    let mut points = cube();
    points.extend(&touching[1..]);
    let mut facets = cube_facets();
    let joined = |id: &u32| 7 + id;
    facets.extend(
        cube_facets()
            .iter()
            .map(|facet| facet.iter().map(joined).collect()),
    );
    let found = findings(&points, &solid(facets));
    assert_eq!(
        found,
        [Finding3::PinchedVertex {
            vertex: 7,
            cycles: 2
        }]
    );
}

#[test]
fn a_torus() {
    // Three triangles about the z axis, joined by three tubes.
    let corner = |turn: u32, place: u32| {
        let angle = TAU * f64::from(turn) / 3.0;
        let (radius, height) = [(1.0, 0.0), (2.0, 0.0), (1.5, 1.0)][place as usize];
        [radius * angle.cos(), radius * angle.sin(), height]
    };
    let points: Vec<Point3> = (0..9).map(|id| corner(id / 3, id % 3)).collect();
    let id = |turn: u32, place: u32| 3 * (turn % 3) + place % 3;
    let facets: Vec<Vec<u32>> = (0..3)
        .flat_map(|turn| (0..3).map(move |place| (turn, place)))
        .flat_map(|(turn, place)| {
            let [a, b] = [id(turn, place), id(turn, place + 1)];
            let [c, d] = [id(turn + 1, place + 1), id(turn + 1, place)];
            [vec![a, b, c], vec![a, c, d]]
        })
        .collect();
    let found = findings(&points, &solid(facets));
    assert_eq!(
        found,
        [Finding3::Euler {
            vertices: 9,
            edges: 27,
            facets: 18
        }]
    );
}

#[test]
fn two_corners_exchanged() {
    for (name, points, facets) in solids() {
        for facet in 0..facets.len() {
            let mut broken = facets.clone();
            broken[facet].swap(0, 1);
            if broken[facet].len() > 3 {
                let hull = solid(broken);
                assert!(check::hull3(&points, &hull).is_err(), "{name}");
            }
        }
    }
}

/// Whatever the value, the checker gives a verdict.
#[test]
fn garbage_is_rejected() {
    use rand::{RngExt, SeedableRng};
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(71);
    let points = hull_verify::families_space::random::ball(72, 12);
    for _ in 0..20_000 {
        let count = rng.random_range(0..8);
        let facets = (0..count)
            .map(|_| {
                let corners = rng.random_range(0..5);
                (0..corners).map(|_| rng.random_range(0..13)).collect()
            })
            .collect();
        assert!(check::hull3(&points, &solid(facets)).is_err());
        let ids: Vec<u32> = (0..rng.random_range(0..5))
            .map(|_| rng.random_range(0..13))
            .collect();
        assert!(check::hull3(&points, &Hull3::Planar(ids)).is_err());
        let ends = [rng.random_range(0..13), rng.random_range(0..13)];
        assert!(check::hull3(&points, &Hull3::Segment(ends)).is_err());
        assert!(check::hull3(&points, &Hull3::Point(ends[0])).is_err());
    }
}
