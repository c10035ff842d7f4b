//! Values of every variant: the right one passes, the wrong one does not.

use super::{BOUNDARIES, findings, hulls};
use geometry_core::{Boundary, Hull2, Point2};
use hull_verify::check::{self, Finding};
use hull_verify::families::lines;
use hull_verify::oracle;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

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

/// Lists of random ids, some of them of no point, in every variant.
#[test]
fn garbage_is_refused_without_a_panic() {
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    for (name, points, boundary, right) in hulls() {
        for _ in 0..200 {
            let most = points.len() as u32 + u32::from(rng.random_range(0..8) == 0);
            let length = rng.random_range(0..12);
            let ids: Vec<u32> = (0..length)
                .map(|_| rng.random_range(0..=most.saturating_sub(1)))
                .collect();
            let hull = match rng.random_range(0..3) {
                0 => Hull2::Segment(ids),
                1 => ids.first().map_or(Hull2::Empty, |&id| Hull2::Point(id)),
                _ => Hull2::Polygon(ids),
            };
            let verdict = check::hull2(&points, boundary, &hull);
            assert_eq!(
                verdict.is_ok(),
                hull == right,
                "{name} {boundary:?}: {hull:?}"
            );
        }
    }
}
