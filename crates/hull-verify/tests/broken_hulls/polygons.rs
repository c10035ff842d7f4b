//! Polygons with one thing wrong.

use super::{BOUNDARIES, findings, hulls};
use geometry_core::{Boundary, Hull2, Point2};
use hull_verify::check::Finding;
use hull_verify::families::{curves, grids, lines};
use hull_verify::oracle;

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

fn polygon_findings(points: &[Point2], boundary: Boundary, ids: &[u32]) -> Vec<Finding> {
    findings(points, boundary, &Hull2::Polygon(ids.to_vec()))
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
