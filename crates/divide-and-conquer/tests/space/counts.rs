//! What merges in space ask and keep, counted.

use crate::sets::{ball, cone, cube, fan, lattice, sphere};
use divide_and_conquer::preparata_hong_3d::{MergeRecord, Variant, merges};
use divide_and_conquer::{preparata_hong_3d, preparata_hong_parallel};
use geometry_core::dimension::AffineBasis;
use geometry_core::{Counted, Exact, Point3, Points, Silent, Tally};

fn records(points: &[Point3], variant: Variant) -> Vec<MergeRecord> {
    merges(Points::new(points).expect("finite"), variant, &Exact).expect("an exact kernel")
}

fn top(points: &[Point3], variant: Variant) -> MergeRecord {
    *records(points, variant).last().expect("the top merge")
}

/// FAN turned so that the wrap begins away from v.
const AWAY: f64 = -1.5;

#[track_caller]
fn assert_close(count: u64, expected: f64, relative: f64) {
    let ratio = count as f64 / expected;
    assert!(
        (ratio - 1.0).abs() <= relative,
        "{count} is {ratio} times {expected}"
    );
}

/// Day's suspicion refuted for his own rule: where the wrap comes through one vertex of degree n/2 about n/4 times, the
/// merge asks 5 n questions.
#[test]
fn a_resumed_search_is_linear_where_one_vertex_recurs() {
    for m in [16, 64, 256, 1024, 2048] {
        let n = (4 * m + 2) as f64;
        let merge = top(&fan(m, AWAY), Variant::Resumed);
        assert_eq!((merge.facets, merge.reexamined), (4 * m as u32, 0));
        let asked = merge.candidates as f64;
        assert!(
            asked <= 5.0 * n && asked >= 5.0 * n - 20.0,
            "{asked} for {n} points"
        );
        // If the wrap begins at v, its first search looks at the n/2 edges there once.
        let asked = top(&fan(m, 0.0), Variant::Resumed).candidates as f64;
        assert!(
            asked <= 5.5 * n && asked >= 5.5 * n - 23.0,
            "{asked} for {n} points"
        );
    }
}

/// And confirmed for the rule that starts every search anew.
#[test]
fn a_search_from_the_start_is_quadratic_where_one_vertex_recurs() {
    for (m, expected, relative) in [(256, 0.1327, 0.02), (2048, 0.126, 0.01)] {
        let n = (4 * m + 2) as f64;
        let merge = top(&fan(m, AWAY), Variant::Rescanned);
        assert_close(merge.candidates, expected * n * n, relative);
        assert!(merge.reexamined > 0);
    }
    let rescanned = top(&fan(256, AWAY), Variant::Rescanned).candidates;
    let sorted = top(&fan(256, AWAY), Variant::Sorted).candidates;
    assert!(sorted > 2 * rescanned, "{sorted} and {rescanned}");
}

#[test]
fn one_pivot_for_a_whole_wrap() {
    for m in [16, 64, 256, 1024, 2048] {
        let n = (4 * m + 2) as f64;
        let merge = top(&cone(m), Variant::Resumed);
        assert_eq!((merge.facets, merge.reexamined), (2 * m as u32 + 1, 0));
        assert_eq!(merge.vertices_after, 2 * m as u32 + 2);
        assert_close(merge.candidates, 3.5 * n, 0.05);
    }
    let n = f64::from(4 * 2048 + 2);
    let merge = top(&cone(2048), Variant::Rescanned);
    assert_close(merge.candidates, 0.250 * n * n, 0.01);
}

/// The proved bound on every merge, and that no record of a hidden edge is kept.
#[test]
fn every_merge_keeps_to_the_bound_and_frees_what_it_hides() {
    let sets = [
        sphere(1, 3000),
        ball(2, 3000),
        cube(3, 3000),
        lattice(12),
        fan(100, 0.0),
        cone(100),
    ];
    for points in sets {
        let records = records(&points, Variant::Resumed);
        assert_eq!(records.len(), points.len() - 1);
        let mut live = 0;
        for merge in &records {
            let stars = merge.vertices_before;
            let bound = 2 * merge.edges_freed + 3 * merge.facets + stars;
            assert!(merge.candidates <= u64::from(bound), "{merge:?}");
            assert_eq!(merge.reexamined, 0, "{merge:?}");
            live = live + merge.edges_made - merge.edges_freed;
            assert_eq!(merge.edges_live, live, "{merge:?}");
        }
        let hull = records.last().expect("the top merge");
        assert_eq!(hull.edges_live, 3 * hull.vertices_after - 6);
    }
}

/// Every question is accounted for: those of the merges, those that find the dimension, and one for each edge, to see
/// whether its triangles are coplanar.
#[test]
fn every_question_is_accounted_for() {
    let set = sphere(7, 2000);
    let points = Points::new(&set).expect("finite");
    let basis = Counted::new(Exact);
    let _ = AffineBasis::of(points, &basis);
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let hull = preparata_hong_3d(points, &kernel, &mut tally).expect("an exact kernel");

    let asked = kernel.counts().orientations_in_space.total();
    let before = basis.counts().orientations_in_space.total();
    let triangles = 2 * hull.len() as u64 - 4;
    assert_eq!(asked - before - 3 * triangles / 2, tally.candidates);
    assert_eq!((tally.merges, tally.bridges), (1999, 2 * 1999));
    assert_eq!(tally.facets - tally.drops, triangles);
    let records = records(&set, Variant::Resumed);
    let candidates: u64 = records.iter().map(|merge| merge.candidates).sum();
    assert_eq!(tally.candidates, candidates);
    let most = records.iter().map(|merge| merge.edges_live).max();
    assert_eq!(Some(tally.storage as u32), most);
}

#[test]
fn side_by_side_is_the_same() {
    for set in [sphere(4, 20_000), ball(5, 20_000), lattice(25)] {
        let points = Points::new(&set).expect("finite");
        let expected = preparata_hong_3d(points, &Exact, &mut Silent);
        assert_eq!(preparata_hong_parallel(points, &Exact), expected);
    }
}
