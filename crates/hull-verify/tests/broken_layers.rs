//! The checker on layers broken on purpose: each kind of breakage is rejected, with the right finding.

use geometry_core::{Boundary, Hull2, Layers, Point2};
use hull_verify::check::{self, Finding};
use hull_verify::families::{self, curves, grids};
use hull_verify::oracle;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const BOUNDARIES: [Boundary; 2] = [Boundary::Extreme, Boundary::All];

fn all_layers() -> Vec<(&'static str, Vec<Point2>, Boundary, Layers)> {
    families::all()
        .into_iter()
        .flat_map(|family| {
            BOUNDARIES.map(|boundary| {
                let layers = oracle::layers(&family.points, boundary);
                (family.name, family.points.clone(), boundary, layers)
            })
        })
        .collect()
}

fn findings(
    points: &[Point2],
    boundary: Boundary,
    rings: Vec<Hull2>,
    ranks: Vec<u32>,
) -> Vec<Finding> {
    check::layers(points, boundary, &Layers::new(rings, ranks))
        .expect_err("broken layers were certified")
}

/// What is found in a ring, without the ring.
fn inner(finding: &Finding) -> &Finding {
    match finding {
        Finding::InRing { finding, .. } => finding,
        other => other,
    }
}

#[test]
fn right_layers_pass() {
    for (name, points, boundary, layers) in all_layers() {
        let certificate =
            check::layers(&points, boundary, &layers).unwrap_or_else(|f| panic!("{name}: {f:?}"));
        assert_eq!(
            (certificate.n, certificate.rings),
            (points.len(), layers.len()),
            "{name}"
        );
        assert_eq!(
            certificate.vertices + certificate.copies,
            certificate.n,
            "{name}"
        );
        // Each ring is the hull of what remained, by the certificate for hulls.
        for (ring, rank) in layers.rings().iter().zip(1..) {
            let remaining: Vec<u32> = (0..points.len() as u32)
                .filter(|&id| layers.c_ranks()[id as usize] >= rank)
                .collect();
            let place = |id: &u32| {
                remaining
                    .iter()
                    .position(|r| r == id)
                    .expect("a vertex remains") as u32
            };
            let ids: Vec<u32> = ring.vertices().iter().map(place).collect();
            let rest: Vec<Point2> = remaining.iter().map(|&id| points[id as usize]).collect();
            let ring = match ring {
                Hull2::Polygon(_) => Hull2::Polygon(ids),
                Hull2::Segment(_) => Hull2::Segment(ids),
                _ => Hull2::Point(ids[0]),
            };
            assert!(check::hull2(&rest, boundary, &ring).is_ok(), "{name}");
        }
    }
}

#[test]
fn ranks_changed_one_at_a_time_are_found() {
    for (name, points, boundary, layers) in all_layers() {
        for id in 0..points.len() {
            for delta in [-1, 1] {
                let mut ranks = layers.c_ranks().to_vec();
                ranks[id] = ranks[id].wrapping_add_signed(delta);
                let (point, rank) = (id as u32, ranks[id]);
                let found = findings(&points, boundary, layers.rings().to_vec(), ranks);
                let fits = |f: &Finding| match *f {
                    Finding::NoSuchRing {
                        point: p, rank: r, ..
                    } => (p, r) == (point, rank),
                    Finding::WrongRank {
                        vertex, rank: r, ..
                    } => (vertex, r) == (point, rank),
                    Finding::NotOnRing { point: p, ring } => (p, ring) == (point, rank),
                    _ => false,
                };
                assert!(
                    found.iter().any(fits),
                    "{name}: rank {rank} for {id}: {found:?}"
                );
            }
        }
    }
}

#[test]
fn too_few_and_too_many_ranks_are_found() {
    for (name, points, boundary, layers) in all_layers() {
        let mut ranks = layers.c_ranks().to_vec();
        ranks.push(1);
        let expected = Finding::RankCount {
            ranks: points.len() + 1,
            count: points.len(),
        };
        assert_eq!(
            findings(&points, boundary, layers.rings().to_vec(), ranks),
            [expected],
            "{name}"
        );
    }
}

#[test]
fn a_ring_left_out_or_empty_is_found() {
    for (name, points, boundary, layers) in all_layers() {
        let (rings, ranks) = (layers.rings().to_vec(), layers.c_ranks().to_vec());
        for k in 0..rings.len() {
            let mut fewer = rings.clone();
            fewer.remove(k);
            let found = findings(&points, boundary, fewer, ranks.clone());
            assert!(!found.is_empty(), "{name}");
            let mut emptied = rings.clone();
            emptied[k] = Hull2::Empty;
            let found = findings(&points, boundary, emptied, ranks.clone());
            assert!(
                found.contains(&Finding::EmptyRing { ring: k as u32 + 1 }),
                "{name}: {found:?}"
            );
        }
        let mut more = rings.clone();
        more.push(Hull2::Empty);
        let expected = Finding::EmptyRing {
            ring: rings.len() as u32 + 1,
        };
        assert_eq!(
            findings(&points, boundary, more, ranks),
            [expected],
            "{name}"
        );
    }
}

#[test]
fn exchanged_rings_are_found() {
    for (name, points, boundary, layers) in all_layers() {
        for k in 1..layers.len() {
            let mut rings = layers.rings().to_vec();
            rings.swap(k - 1, k);
            // The ranks as they were …
            let found = findings(&points, boundary, rings.clone(), layers.c_ranks().to_vec());
            assert!(
                found.iter().any(|f| matches!(f, Finding::WrongRank { .. })),
                "{name}: {found:?}"
            );
            // … and changed with the rings, so that only the geometry is wrong.
            let (outer, inner_rank) = (k as u32, k as u32 + 1);
            let swap = |&rank: &u32| match rank {
                r if r == outer => inner_rank,
                r if r == inner_rank => outer,
                r => r,
            };
            let ranks = layers.c_ranks().iter().map(swap).collect();
            let found = findings(&points, boundary, rings, ranks);
            let fits = |f: &Finding| {
                matches!(
                    inner(f),
                    Finding::Outside { .. } | Finding::WrongDimension { .. }
                )
            };
            assert!(found.iter().any(fits), "{name}: {found:?}");
        }
    }
}

#[test]
fn a_vertex_moved_one_ring_inwards_is_found() {
    let points = curves::nested_squares(5);
    let layers = oracle::layers(&points, Boundary::All);
    let (mut rings, mut ranks) = (layers.rings().to_vec(), layers.c_ranks().to_vec());
    let Hull2::Polygon(ids) = &mut rings[0] else {
        panic!("a square is a polygon");
    };
    let moved = ids.remove(2);
    ranks[moved as usize] = 2;
    let found = findings(&points, Boundary::All, rings, ranks);
    let names_it = |f: &Finding| matches!(inner(f), Finding::Outside { point, .. } | Finding::NotOnRing { point, .. } if *point == moved);
    assert!(found.iter().any(names_it), "{found:?}");
}

#[test]
fn a_boundary_point_left_for_later_is_found() {
    let points = grids::lattice(4);
    let extreme = oracle::layers(&points, Boundary::Extreme);
    let found = findings(
        &points,
        Boundary::All,
        extreme.rings().to_vec(),
        extreme.c_ranks().to_vec(),
    );
    assert!(
        found
            .iter()
            .any(|f| matches!(inner(f), Finding::MissingBoundaryPoint { .. })),
        "{found:?}"
    );
    let all = oracle::layers(&points, Boundary::All);
    let found = findings(
        &points,
        Boundary::Extreme,
        all.rings().to_vec(),
        all.c_ranks().to_vec(),
    );
    assert!(
        found
            .iter()
            .any(|f| matches!(inner(f), Finding::NoCorner { .. })),
        "{found:?}"
    );
}

#[test]
fn a_copy_left_behind_is_found() {
    let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 0.0], [1.0, 1.0]];
    let rings = vec![Hull2::Polygon(vec![0, 1, 2]), Hull2::Segment(vec![4, 3])];
    for boundary in BOUNDARIES {
        let found = findings(&points, boundary, rings.clone(), vec![1, 1, 1, 2, 2]);
        assert_eq!(
            found,
            [Finding::CopyLeft {
                ring: 1,
                vertex: 1,
                copy: 3
            }]
        );
    }
    let rings = vec![Hull2::Polygon(vec![0, 3, 2]), Hull2::Point(4)];
    let found = findings(&points, Boundary::Extreme, rings, vec![1, 1, 1, 1, 2]);
    let finding = Box::new(Finding::LargerCopy {
        vertex: 3,
        smaller: 1,
    });
    assert_eq!(found, [Finding::InRing { ring: 1, finding }]);
    assert_eq!(
        found[0].to_string(),
        "ring 1: vertex 3 is a copy of point 1, which should stand for it"
    );
}

/// A copy two rings later: no ring sees it but the one between, which must be wrong then.
#[test]
fn a_copy_left_two_rings_behind_is_found() {
    let mut points = curves::nested_triangles(3);
    let corner = 6; // of the outermost triangle
    points.push(points[corner]);
    let layers = oracle::layers(&points, Boundary::Extreme);
    let mut ranks = layers.c_ranks().to_vec();
    ranks[9] = 3;
    let found = findings(
        &points,
        Boundary::Extreme,
        layers.rings().to_vec(),
        ranks.clone(),
    );
    assert!(
        found.contains(&Finding::NotOnRing { ring: 3, point: 9 }),
        "{found:?}"
    );
    let mut rings = layers.rings().to_vec();
    rings[2] = oracle::hull2(&points[..3], Boundary::Extreme);
    let Hull2::Polygon(ids) = &mut rings[2] else {
        panic!("a triangle is a polygon");
    };
    ids[0] = 9;
    let found = findings(&points, Boundary::Extreme, rings, ranks);
    assert!(!found.is_empty());
}

#[test]
fn a_defect_of_a_ring_is_named_with_the_ring() {
    let points = curves::nested_triangles(4);
    let layers = oracle::layers(&points, Boundary::Extreme);
    let mut rings = layers.rings().to_vec();
    let Hull2::Polygon(ids) = &mut rings[2] else {
        panic!("a triangle is a polygon");
    };
    ids[1..].reverse();
    let found = findings(&points, Boundary::Extreme, rings, layers.c_ranks().to_vec());
    assert_eq!(
        found,
        [Finding::InRing {
            ring: 3,
            finding: Box::new(Finding::Clockwise)
        }]
    );
}

/// Of all ways to give ranks to the points of a small set, each ring being the hull of the points of its rank,
/// the checker certifies the right one alone.
#[test]
fn of_all_assignments_of_ranks_exactly_the_right_one_is_certified() {
    let lattice = |cells: [u32; 5]| cells.map(|cell| [f64::from(cell % 3), f64::from(cell / 3)]);
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    for _ in 0..150 {
        let points = lattice(std::array::from_fn(|_| rng.random_range(0..9)));
        for boundary in BOUNDARIES {
            let right = oracle::layers(&points, boundary);
            let mut certified = 0;
            for number in 0..5_u32.pow(5) {
                let ranks: Vec<u32> = (0..5)
                    .map(|place| number / 5_u32.pow(place) % 5 + 1)
                    .collect();
                let rings = (1..=ranks.iter().copied().max().unwrap_or(0))
                    .map(|rank| hull_of_rank(&points, &ranks, rank, boundary))
                    .collect();
                let layers = Layers::new(rings, ranks);
                let verdict = check::layers(&points, boundary, &layers);
                assert_eq!(
                    verdict.is_ok(),
                    layers == right,
                    "{points:?} {layers:?}: {verdict:?}"
                );
                certified += u32::from(verdict.is_ok());
            }
            assert_eq!(certified, 1, "{points:?}");
        }
    }
}

/// The hull of the points of one rank.
fn hull_of_rank(points: &[Point2], ranks: &[u32], rank: u32, boundary: Boundary) -> Hull2 {
    let members: Vec<u32> = (0..)
        .zip(ranks)
        .filter(|&(_, &r)| r == rank)
        .map(|(id, _)| id)
        .collect();
    let places: Vec<Point2> = members.iter().map(|&id| points[id as usize]).collect();
    let back = |ids: Vec<u32>| ids.into_iter().map(|id| members[id as usize]).collect();
    match oracle::hull2(&places, boundary) {
        Hull2::Empty => Hull2::Empty,
        Hull2::Point(id) => Hull2::Point(members[id as usize]),
        Hull2::Segment(ids) => Hull2::Segment(back(ids)),
        Hull2::Polygon(ids) => Hull2::Polygon(back(ids)),
    }
}
