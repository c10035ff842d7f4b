//! The checker on hulls broken on purpose: each kind of breakage is rejected, with the right finding.

use geometry_core::{Boundary, Hull2, Point2};
use hull_verify::check::{self, Finding};
use hull_verify::families::{self, curves, grids, lines};
use hull_verify::oracle;

const BOUNDARIES: [Boundary; 2] = [Boundary::Extreme, Boundary::All];

/// Every family with its hull by the oracle.
fn hulls() -> Vec<(&'static str, Vec<Point2>, Boundary, Hull2)> {
    families::all()
        .into_iter()
        .flat_map(|family| {
            BOUNDARIES.map(|boundary| {
                let hull = oracle::hull2(&family.points, boundary);
                (family.name, family.points.clone(), boundary, hull)
            })
        })
        .collect()
}

/// Those that are polygons, as lists of vertices.
fn polygons() -> Vec<(&'static str, Vec<Point2>, Boundary, Vec<u32>)> {
    let as_polygon = |(name, points, boundary, hull)| match hull {
        Hull2::Polygon(ids) => Some((name, points, boundary, ids)),
        _ => None,
    };
    let polygons: Vec<_> = hulls().into_iter().filter_map(as_polygon).collect();
    assert!(polygons.len() > 60);
    polygons
}

fn findings(points: &[Point2], boundary: Boundary, hull: &Hull2) -> Vec<Finding> {
    check::hull2(points, boundary, hull).expect_err("a broken hull was certified")
}

fn polygon_findings(points: &[Point2], boundary: Boundary, ids: &[u32]) -> Vec<Finding> {
    findings(points, boundary, &Hull2::Polygon(ids.to_vec()))
}

#[test]
fn right_hulls_pass_and_all_points_are_accounted_for() {
    for (name, points, boundary, hull) in hulls() {
        let certificate =
            check::hull2(&points, boundary, &hull).unwrap_or_else(|f| panic!("{name}: {f:?}"));
        assert_eq!(
            (certificate.n, certificate.h),
            (points.len(), hull.len()),
            "{name}"
        );
        let others = certificate.copies + certificate.on_edges + certificate.inside;
        assert_eq!(certificate.n, certificate.h + others, "{name}");
        assert_eq!(certificate.dimension, hull.dimension());
        assert!(boundary == Boundary::Extreme || certificate.on_edges == 0);
    }
}

#[test]
fn a_dropped_vertex_is_found_outside_or_missing() {
    for (name, points, boundary, ids) in polygons() {
        for k in 0..ids.len() {
            let mut broken = ids.clone();
            let dropped = broken.remove(k);
            // Only the drop is to be wrong, not the start.
            let at = |&id: &u32| points[id as usize];
            let smallest = broken
                .iter()
                .map(at)
                .reduce(|p, q| if q < p { q } else { p });
            let start = broken.iter().position(|id| Some(at(id)) == smallest);
            broken.rotate_left(start.unwrap_or(0));
            let found = polygon_findings(&points, boundary, &broken);
            let names_it = |f: &Finding| match *f {
                Finding::Outside { point, .. } | Finding::MissingBoundaryPoint { point, .. } => {
                    point == dropped
                }
                // Too little is left for a polygon.
                Finding::WrongCount { count, .. } => count == 2,
                // All that is left lies on one line.
                Finding::TurnsBack { .. } => true,
                _ => false,
            };
            assert!(
                found.iter().any(names_it),
                "{name} {boundary:?} without {dropped}: {found:?}"
            );
        }
    }
}

#[test]
fn an_interior_point_among_the_vertices_is_a_right_turn() {
    for (name, points, boundary, ids) in polygons() {
        let on_hull = oracle::hull2(&points, Boundary::All);
        let on_hull = on_hull.vertices();
        let is_inside = |&id: &u32| {
            on_hull
                .iter()
                .all(|&v| points[v as usize] != points[id as usize])
        };
        let Some(inner) = (0..points.len() as u32).find(is_inside) else {
            continue;
        };
        for place in 1..=ids.len() {
            let mut broken = ids.clone();
            broken.insert(place, inner);
            let found = polygon_findings(&points, boundary, &broken);
            let right =
                |f: &Finding| matches!(f, Finding::RightTurn { .. } | Finding::NoCorner { .. });
            let back = |f: &Finding| matches!(f, Finding::TurnsBack { .. });
            assert!(
                found.iter().any(|f| right(f) || back(f)),
                "{name} with {inner} at {place}: {found:?}"
            );
        }
    }
}

#[test]
fn a_boundary_point_is_no_corner() {
    for (points, corners) in [
        (grids::square_outline(4), 4),
        (grids::lattice(5), 4),
        (grids::triangle_outline(6), 3),
        (grids::diamond(3), 4),
    ] {
        let all = oracle::hull2(&points, Boundary::All);
        let found = findings(&points, Boundary::Extreme, &all);
        assert_eq!(found.len(), all.len() - corners);
        assert!(
            found.iter().all(|f| matches!(f, Finding::NoCorner { .. })),
            "{found:?}"
        );

        let extreme = oracle::hull2(&points, Boundary::Extreme);
        let found = findings(&points, Boundary::All, &extreme);
        let missing: Vec<u32> = found
            .iter()
            .map(|f| match *f {
                Finding::MissingBoundaryPoint { point, .. } => point,
                _ => panic!("{f:?}"),
            })
            .collect();
        assert_eq!(missing.len(), all.len() - corners);
        assert!(missing.iter().all(|id| all.vertices().contains(id)));
    }
}

#[test]
fn two_vertices_exchanged_are_found() {
    for (name, points, boundary, ids) in polygons() {
        for (i, j) in [
            (0, 1),
            (0, ids.len() - 1),
            (1, ids.len() - 1),
            (0, ids.len() / 2),
        ] {
            if i == j {
                continue;
            }
            let mut broken = ids.clone();
            broken.swap(i, j);
            let found = polygon_findings(&points, boundary, &broken);
            let shape = |f: &Finding| {
                matches!(
                    f,
                    Finding::RightTurn { .. }
                        | Finding::TurnsBack { .. }
                        | Finding::Clockwise
                        | Finding::NoCorner { .. }
                )
            };
            assert!(
                found.iter().all(shape),
                "{name} {boundary:?} {i} <-> {j}: {found:?}"
            );
        }
    }
}

#[test]
fn a_reversed_polygon_runs_clockwise() {
    for (name, points, boundary, ids) in polygons() {
        let mut broken = ids.clone();
        broken[1..].reverse();
        assert_eq!(
            polygon_findings(&points, boundary, &broken),
            [Finding::Clockwise],
            "{name}"
        );
    }
}

#[test]
fn every_other_start_is_wrong() {
    for (name, points, boundary, ids) in polygons() {
        for k in 1..ids.len() {
            let mut broken = ids.clone();
            broken.rotate_left(k);
            let expected = Finding::WrongStart {
                start: ids[k],
                smallest: ids[0],
            };
            assert_eq!(
                polygon_findings(&points, boundary, &broken),
                [expected],
                "{name}"
            );
        }
    }
}

#[test]
fn a_star_goes_round_twice() {
    // Steps of 2 round an odd number of corners, of 3 round seven.
    for (corners, step) in [(5, 2), (7, 2), (7, 3), (11, 4)] {
        let points = curves::circle(corners);
        let Hull2::Polygon(ids) = oracle::hull2(&points, Boundary::Extreme) else {
            panic!("a circle has a polygon for its hull");
        };
        let star: Vec<u32> = (0..ids.len()).map(|i| ids[i * step % ids.len()]).collect();
        for boundary in BOUNDARIES {
            let found = polygon_findings(&points, boundary, &star);
            assert_eq!(found, [Finding::Winding { revolutions: step }]);
        }
    }
}

#[test]
fn a_triangle_gone_round_twice_repeats_its_vertices() {
    let points = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    let found = polygon_findings(&points, Boundary::Extreme, &[0, 1, 2, 0, 1, 2]);
    assert_eq!(found, [0, 2, 1].map(|id| Finding::Repeated { id }));
    // Through copies, so that no id is repeated.
    let twice = [points, points].concat();
    let found = polygon_findings(&twice, Boundary::Extreme, &[0, 1, 2, 3, 4, 5]);
    let expected =
        [(0, 3), (2, 5), (1, 4)].map(|(first, second)| Finding::EqualVertices { first, second });
    assert_eq!(found, expected);
}

#[test]
fn the_wrong_variant_is_found() {
    for (name, points, boundary, hull) in hulls() {
        let ids = hull.vertices().to_vec();
        let mut wrong = vec![
            Hull2::Segment(ids.clone()),
            Hull2::Polygon(ids.clone()),
            Hull2::Empty,
        ];
        wrong.extend(ids.first().map(|&id| Hull2::Point(id)));
        wrong.retain(|other| *other != hull);
        for broken in wrong {
            let found = findings(&points, boundary, &broken);
            let fits = |f: &Finding| {
                matches!(
                    f,
                    Finding::WrongDimension { .. }
                        | Finding::WrongCount { .. }
                        | Finding::TurnsBack { .. }
                        | Finding::WrongStart { .. }
                )
            };
            assert!(
                found.iter().any(fits),
                "{name} {boundary:?} as {broken:?}: {found:?}"
            );
        }
    }
}

#[test]
fn a_polygon_without_area_turns_back() {
    let points = lines::diagonal(5);
    let Hull2::Segment(row) = oracle::hull2(&points, Boundary::All) else {
        panic!("collinear points have a segment for their hull");
    };
    for boundary in BOUNDARIES {
        let found = polygon_findings(&points, boundary, &row);
        assert!(
            found.iter().any(|f| matches!(f, Finding::TurnsBack { .. })),
            "{found:?}"
        );
    }
}

#[test]
fn ids_that_name_no_point_are_found() {
    for (name, points, boundary, hull) in hulls() {
        let count = points.len();
        for id in [count as u32, u32::MAX] {
            let expected = Finding::NoSuchPoint { id, count };
            let mut ids = hull.vertices().to_vec();
            ids.insert(ids.len() / 2, id);
            for broken in [
                Hull2::Polygon(ids.clone()),
                Hull2::Segment(ids),
                Hull2::Point(id),
            ] {
                assert_eq!(
                    findings(&points, boundary, &broken),
                    std::slice::from_ref(&expected),
                    "{name}"
                );
            }
        }
    }
}

#[test]
fn a_repeated_vertex_is_found() {
    for (name, points, boundary, ids) in polygons() {
        for k in 0..ids.len() {
            let mut broken = ids.clone();
            broken.insert((k + 2) % (ids.len() + 1), ids[k]);
            let found = polygon_findings(&points, boundary, &broken);
            assert_eq!(found, [Finding::Repeated { id: ids[k] }], "{name}");
        }
    }
}

#[test]
fn the_larger_copy_must_not_stand() {
    for (name, points, boundary, hull) in hulls() {
        let copy_of = |id: u32| {
            let mut others = (id + 1..points.len() as u32)
                .filter(|&o| points[o as usize] == points[id as usize]);
            others.next()
        };
        for (k, &vertex) in hull.vertices().iter().enumerate() {
            let Some(copy) = copy_of(vertex) else {
                continue;
            };
            let with_copy = |ids: &[u32]| {
                let mut ids = ids.to_vec();
                ids[k] = copy;
                ids
            };
            let broken = match &hull {
                Hull2::Empty => continue,
                Hull2::Point(_) => Hull2::Point(copy),
                Hull2::Segment(ids) => Hull2::Segment(with_copy(ids)),
                Hull2::Polygon(ids) => Hull2::Polygon(with_copy(ids)),
            };
            let found = findings(&points, boundary, &broken);
            let expected = Finding::LargerCopy {
                vertex: copy,
                smaller: vertex,
            };
            assert!(found.contains(&expected), "{name}: {found:?}");
            assert!(
                found
                    .iter()
                    .all(|f| matches!(f, Finding::LargerCopy { .. })),
                "{name}: {found:?}"
            );
        }
    }
}

#[test]
fn segments_broken_on_purpose() {
    // In lexicographic order: 3, 1, 0, 2, 4.
    let points = lines::horizontal(5);
    assert_eq!(
        oracle::hull2(&points, Boundary::All),
        Hull2::Segment(vec![4, 2, 0, 1, 3])
    );
    let found = |boundary, ids: &[u32]| findings(&points, boundary, &Hull2::Segment(ids.to_vec()));
    let (extreme, all) = (Boundary::Extreme, Boundary::All);
    assert_eq!(
        found(extreme, &[3, 4]),
        [Finding::WrongStart {
            start: 3,
            smallest: 4
        }]
    );
    assert_eq!(
        found(extreme, &[4, 0, 3]),
        [Finding::NoCorner {
            before: 4,
            at: 0,
            after: 3
        }]
    );
    assert_eq!(
        found(extreme, &[4, 1]),
        [Finding::Outside {
            point: 3,
            from: 4,
            to: 1
        }]
    );
    assert_eq!(
        found(extreme, &[4]),
        [Finding::WrongCount {
            claimed: Some(1),
            count: 1
        }]
    );
    assert_eq!(
        found(all, &[4, 0, 2, 1, 3]),
        [Finding::WrongOrder {
            before: 0,
            after: 2
        }]
    );
    assert_eq!(
        found(all, &[4, 2, 0, 3]),
        [Finding::MissingBoundaryPoint {
            point: 1,
            from: 0,
            to: 3
        }]
    );

    let bent = [[0.0, 0.0], [2.0, 0.0], [1.0, 1e-300]];
    let broken = findings(&bent, extreme, &Hull2::Segment(vec![0, 1]));
    assert_eq!(
        broken,
        [Finding::WrongDimension {
            claimed: Some(1),
            witness: 2
        }]
    );
    let broken = findings(&bent, all, &Hull2::Segment(vec![0, 2, 1]));
    assert_eq!(
        broken,
        [Finding::WrongDimension {
            claimed: Some(1),
            witness: 2
        }]
    );
}

#[test]
fn a_set_that_cannot_be_judged_is_refused() {
    let points = [[0.0, 0.0], [f64::NAN, 1.0], [1.0, f64::NEG_INFINITY]];
    let found = findings(&points, Boundary::Extreme, &Hull2::Point(0));
    assert_eq!(found, [1, 2].map(|point| Finding::NotFinite { point }));
}

#[test]
fn an_ulp_outside_is_outside() {
    let corner = 1.0_f64;
    let square = [[0.0, 0.0], [corner, 0.0], [corner, corner], [0.0, corner]];
    for beyond in [
        [corner.next_up(), 0.5],
        [0.5, -5e-324],
        [-5e-324, 0.5],
        [0.5, corner.next_up()],
    ] {
        let mut points = square.to_vec();
        points.push(beyond);
        let found = polygon_findings(&points, Boundary::Extreme, &[0, 1, 2, 3]);
        assert!(
            matches!(found[..], [Finding::Outside { point: 4, .. }]),
            "{beyond:?}: {found:?}"
        );
    }
}

/// Every list of up to five ids out of six, for a set of five points, in every variant: the checker accepts
/// exactly the oracle's answer and never panics.
#[test]
fn of_all_small_values_exactly_the_right_one_is_certified() {
    let sets: [&[Point2]; 7] = [
        &[],
        &[[1.0, 1.0]; 3],
        &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 0.0], [2.0, 0.0]],
        &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.25, 0.25], [0.0, 0.0]],
        &[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]],
        &[[2.0, 2.0], [0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
        &[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0], [1.0, 1.0]],
    ];
    let lists: Vec<Vec<u32>> = (0..=5)
        .flat_map(|length| {
            (0..6_u32.pow(length)).map(move |n| (0..length).map(|k| n / 6_u32.pow(k) % 6).collect())
        })
        .collect();
    for points in sets {
        for boundary in BOUNDARIES {
            let right = oracle::hull2(points, boundary);
            let polygons = lists.iter().cloned().map(Hull2::Polygon);
            let segments = lists.iter().cloned().map(Hull2::Segment);
            let others = (0..6).map(Hull2::Point).chain([Hull2::Empty]);
            let mut certified = 0;
            for hull in polygons.chain(segments).chain(others) {
                let verdict = check::hull2(points, boundary, &hull);
                assert_eq!(
                    verdict.is_ok(),
                    hull == right,
                    "{points:?} {boundary:?} {hull:?}: {verdict:?}"
                );
                if let Err(found) = verdict {
                    assert!(!found.is_empty() && found.iter().all(|f| !f.to_string().is_empty()));
                } else {
                    certified += 1;
                }
            }
            assert_eq!(certified, 1, "{points:?}");
        }
    }
}
