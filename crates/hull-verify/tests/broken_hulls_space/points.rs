//! Right surfaces that are not the hull of the points.

use super::{cube, cube_facets, findings, solid, solids};
use geometry_core::{Hull3, Point3};
use hull_verify::arithmetic::scale::{Scale, Side};
use hull_verify::check::{self, Finding3};
use hull_verify::oracle;

#[test]
fn points_outside_every_facet() {
    let centre = [0.5; 3];
    // Beyond the middle of each facet, beyond each edge, beyond each corner; just outside, and far.
    for direction in 0..27_u32 {
        let step = [direction % 3, direction / 3 % 3, direction / 9].map(|d| f64::from(d) - 1.0);
        if step == [0.0; 3] {
            continue;
        }
        for far in [0.5 + f64::EPSILON, 0.75, 1e6, 1e300] {
            let mut points = cube();
            points.push([0, 1, 2].map(|i| centre[i] + far * step[i]));
            let hull = solid(cube_facets());
            let [Finding3::Outside { point: 8, facet }] = findings(&points, &hull)[..] else {
                panic!("{direction}: {:?}", findings(&points, &hull));
            };
            let facet = hull.facets().nth(facet as usize).expect("a facet");
            let [a, b, c] = [0, 1, 2].map(|i| points[facet[i] as usize]);
            assert_eq!(Scale::of(&points).side(a, b, c, points[8]), Side::Above);
        }
    }
}

#[test]
fn points_on_the_boundary_are_not_outside() {
    for direction in 0..27_u32 {
        let step = [direction % 3, direction / 3 % 3, direction / 9].map(|d| f64::from(d) - 1.0);
        let mut points = cube();
        points.push(step.map(|d| 0.5 + 0.5 * d));
        points.push(step.map(|d| 0.5 + 0.25 * d));
        let certificate = check::hull3(&points, &solid(cube_facets())).expect("all inside");
        let zeros = step.iter().filter(|&&d| d == 0.0).count();
        let expected = match zeros {
            0 => (1, 0, 1),
            3 => (0, 0, 2),
            _ => (0, 1, 1),
        };
        let found = (
            certificate.copies,
            certificate.on_boundary,
            certificate.inside,
        );
        assert_eq!(found, expected, "{step:?}");
    }
}

#[test]
fn the_hull_without_one_vertex_is_not_the_hull() {
    for (name, points, _) in solids() {
        if points.len() > 30 {
            continue;
        }
        let hull = oracle::hull3(&points);
        let [other, rest @ ..] = hull.vertices() else {
            panic!("a solid has vertices");
        };
        for &vertex in rest.iter().take(5) {
            // Vertex and copies moved to the first vertex, so that the ids stay the same.
            let mut fewer: Vec<Point3> = points.clone();
            for p in &mut fewer {
                if *p == points[vertex as usize] {
                    *p = points[*other as usize];
                }
            }
            let smaller = oracle::hull3(&fewer);
            if let Hull3::Solid(_) = smaller {
                let found = findings(&points, &smaller);
                let expected = |f: &Finding3| matches!(f, Finding3::Outside { .. });
                assert!(found.iter().all(expected), "{name}: {found:?}");
            }
        }
    }
}

#[test]
fn a_copy_with_a_smaller_index_should_be_the_vertex() {
    let mut points = cube();
    points.insert(0, [1.0; 3]);
    let facets = cube_facets();
    let moved = facets
        .iter()
        .map(|facet| facet.iter().map(|id| id + 1).collect());
    let expected = [Finding3::LargerCopy {
        vertex: 8,
        smaller: 0,
    }];
    assert_eq!(findings(&points, &solid(moved.collect())), expected);
}

#[test]
fn an_inner_point_as_a_vertex_is_found() {
    let mut points = cube();
    points.push([0.5, 0.5, 0.75]);
    let mut facets = cube_facets();
    let top = facets.remove(3);
    for i in 0..4 {
        facets.push(vec![top[i], top[(i + 1) % 4], 8]);
    }
    let found = findings(&points, &solid(facets));
    assert!(matches!(found[0], Finding3::ReflexEdge { .. }), "{found:?}");
    // On the facet, not inside.
    points[8][2] = 1.0;
    let mut facets = cube_facets();
    let top = facets.remove(3);
    for i in 0..4 {
        facets.push(vec![top[i], top[(i + 1) % 4], 8]);
    }
    let found = findings(&points, &solid(facets));
    assert!(
        matches!(found[0], Finding3::CoplanarFacets { .. }),
        "{found:?}"
    );
}

#[test]
fn coordinates_that_are_not_finite() {
    let mut points = cube();
    points[2][1] = f64::NAN;
    points[5][2] = f64::INFINITY;
    let expected = [
        Finding3::NotFinite { point: 2 },
        Finding3::NotFinite { point: 5 },
    ];
    assert_eq!(findings(&points, &solid(cube_facets())), expected);
}

/// One ulp decides: a point moved from the facet outwards is outside, inwards inside.
#[test]
fn one_ulp_decides() {
    for (coordinate, expected) in [
        (1.0_f64.next_down(), (0, 1)),
        (1.0, (1, 0)),
        (1.0_f64.next_up(), (0, 0)),
    ] {
        for axis in 0..3 {
            let mut points = cube();
            let mut p = [0.3, 0.3, 0.3];
            p[axis] = coordinate;
            points.push(p);
            match check::hull3(&points, &solid(cube_facets())) {
                Ok(certificate) => {
                    assert_eq!((certificate.on_boundary, certificate.inside), expected);
                }
                Err(findings) => {
                    assert_eq!(expected, (0, 0));
                    assert!(matches!(findings[..], [Finding3::Outside { point: 8, .. }]));
                }
            }
        }
    }
}
