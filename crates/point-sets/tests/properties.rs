//! What each set promises about its geometry.

mod common;

use common::{Point, collinear, hull, layers, points};
use geometry_core::{Exact, Kernel2};
use point_sets::{Spec, catalogue};
use std::cmp::Ordering;
use std::collections::BTreeSet;

fn distinct(points: &[Point]) -> usize {
    let bits: BTreeSet<_> = points.iter().map(|point| point.map(f64::to_bits)).collect();
    bits.len()
}

fn sorted(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| Exact.lexicographic(*a, *b));
    points
}

#[test]
fn every_set_has_any_small_size_and_finite_coordinates() {
    let planar = |entry: &&point_sets::Entry| entry.dimensions().contains(&2);
    for entry in catalogue()
        .iter()
        .filter(planar)
        .filter(|entry| entry.name != "minkowski")
    {
        for n in [0, 1, 2, 3, 4, 5, 10, 97] {
            let points = points(entry.name, n, 1);
            assert_eq!(points.len(), n, "{}", entry.name);
            assert!(
                points.as_flattened().iter().all(|c| c.is_finite()),
                "{}",
                entry.name
            );
        }
    }
}

#[test]
fn a_longer_random_set_begins_with_the_shorter() {
    for spec in [
        "disc",
        "square",
        "normal",
        "cauchy",
        "circle",
        "near-collinear",
        "killer",
    ] {
        assert_eq!(points(spec, 1000, 3)[..300], points(spec, 300, 3), "{spec}");
    }
}

#[test]
fn seeds_matter_where_there_is_chance() {
    for spec in [
        "disc",
        "normal",
        "rotated",
        "collinear",
        "shuffled",
        "duplicated",
    ] {
        assert_ne!(points(spec, 50, 1), points(spec, 50, 2), "{spec}");
    }
    for spec in [
        "lattice",
        "oblique",
        "parabola",
        "killer",
        "rotated:angle=12.5",
    ] {
        assert_eq!(points(spec, 50, 1), points(spec, 50, 2), "{spec}");
    }
}

#[test]
fn lattices_have_the_counts_of_lattices() {
    let square = points("lattice:cols=12,rows=8", 96, 0);
    assert_eq!(distinct(&square), 96);
    assert_eq!(hull(&square, false).len(), 4);
    assert_eq!(hull(&square, true).len(), 2 * (12 + 8) - 4);
    assert_eq!(points("lattice", 96, 0).last(), Some(&[5.0, 9.0]));
    assert_eq!(points("lattice:rows=4", 10, 0)[3], [0.0, 1.0]);
}

#[test]
fn lattices_that_do_not_hold_the_points_are_refused() {
    let spec: Spec = "lattice:cols=20,rows=20".parse().unwrap();
    let error = spec.generate(100, 0).unwrap_err().to_string();
    assert_eq!(
        error,
        "lattice: 20 columns of 20 rows are 400 points and 100 are asked; ask for as many, or leave out cols \
         or rows"
    );
}

#[test]
fn the_oblique_lattice_peels_as_in_figure_2() {
    let oblique = points("oblique:cols=10,rows=10", 100, 0);
    assert_eq!(layers(&oblique), [36, 28, 20, 12, 4]);
    let columns: BTreeSet<u64> = oblique.iter().map(|point| point[0].to_bits()).collect();
    assert!(columns.len() > 30, "few points share an x");
    for row in oblique.chunks(10) {
        assert!(collinear(row));
    }
}

#[test]
fn a_rotated_lattice_is_a_lattice_but_for_rounding() {
    let straight = points("rotated:angle=0", 100, 0);
    assert_eq!(layers(&straight), [36, 28, 20, 12, 4]);
    let turned = points("rotated:angle=30", 100, 0);
    assert_ne!(
        layers(&turned),
        [36, 28, 20, 12, 4],
        "rounding breaks collinearity"
    );
    let (sine, cosine) = (0.5, 0.75_f64.sqrt());
    for ([x, y], [u, v]) in straight.iter().zip(&turned) {
        assert!((cosine * x - sine * y - u).abs() < 1e-15);
        assert!((sine * x + cosine * y - v).abs() < 1e-15);
    }
}

#[test]
fn decimals_are_decimals() {
    for point in points("rotated:angle=30,decimals=9", 100, 0) {
        for coordinate in point {
            let printed = format!("{coordinate}");
            let decimals = printed
                .split_once('.')
                .map_or(0, |(_, decimals)| decimals.len());
            assert!(decimals <= 9, "{printed}");
            assert!(coordinate.to_bits() != (-0.0_f64).to_bits());
        }
    }
    let (exact, rounded) = (
        points("normal", 1000, 5),
        points("rounded:decimals=1", 1000, 5),
    );
    for (a, b) in exact.as_flattened().iter().zip(rounded.as_flattened()) {
        assert!((a - b).abs() <= 0.05 + f64::EPSILON);
    }
    assert!(distinct(&rounded) < 900, "some points meet");
}

#[test]
fn collinear_points_are_collinear_and_distinct() {
    for spec in [
        "collinear",
        "collinear:dx=0,dy=5",
        "collinear:dx=1000003,dy=-999983",
    ] {
        let points = points(spec, 2000, 9);
        assert!(collinear(&points), "{spec}");
        assert_eq!(distinct(&points), 2000, "{spec}");
    }
    assert!(!collinear(&points("near-collinear", 100, 9)));
    assert!(collinear(&points("near-collinear:ulps=0", 100, 9)));
}

#[test]
fn all_points_of_the_convex_curves_are_extreme() {
    for spec in ["parabola", "killer", "circle:spacing=equal", "circle"] {
        assert_eq!(hull(&points(spec, 1000, 2), false).len(), 1000, "{spec}");
    }
}

#[test]
fn nested_triangles_have_a_third_as_many_layers() {
    for (n, expected) in [
        (30, vec![3; 10]),
        (31, [vec![3; 10], vec![1]].concat()),
        (5, vec![3, 2]),
    ] {
        assert_eq!(layers(&points("nested-triangles", n, 0)), expected, "{n}");
    }
}

/// The levels of quickhull above the chord from `left` to `right`, and the points it looks at.
fn quickhull_levels(left: Point, right: Point, mut above: Vec<Point>) -> (usize, usize) {
    let further = |a: &Point, b: &Point| Exact.compare_distance(left, right, *a, *b);
    let (mut depth, mut looks) = (0, above.len());
    if let Some(top) = above.iter().copied().max_by(further) {
        let outside =
            |a: Point, b: Point, p: &Point| Exact.orient(a, b, *p) == geometry_core::Sign::Positive;
        let rest: Vec<Point> = above
            .iter()
            .copied()
            .filter(|p| outside(top, right, p))
            .collect();
        above.retain(|p| outside(left, top, p));
        let sides = [
            quickhull_levels(left, top, above),
            quickhull_levels(top, right, rest),
        ];
        depth = 1 + sides[0].0.max(sides[1].0);
        looks += sides[0].1 + sides[1].1;
    }
    (depth, looks)
}

#[test]
fn the_killer_gives_quickhull_one_point_a_level_to_its_end() {
    for n in [100, 836, 1254] {
        let mut points = sorted(points("killer", n, 0));
        let (left, right) = (points.remove(0), points.pop().unwrap());
        let (depth, looks) = quickhull_levels(left, right, points);
        assert_eq!(depth, n - 2, "{n}");
        assert_eq!(looks, (n - 2) * (n - 1) / 2, "{n}");
    }
}

#[test]
fn the_killer_ends_with_an_explanation() {
    let error = "killer"
        .parse::<Spec>()
        .unwrap()
        .generate(2000, 0)
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("killer has at most 1254 points and 2000 are asked: coordinates"),
        "{error}"
    );
    assert!(error.contains("duplicated:of=killer"), "{error}");
}

#[test]
fn copies_are_copies() {
    let (disc, copied) = (
        points("disc", 34, 6),
        points("duplicated:of=disc,copies=3", 100, 6),
    );
    assert_eq!(distinct(&copied), 34);
    for (index, point) in copied.iter().enumerate() {
        assert_eq!(*point, disc[index % 34]);
    }
    assert_eq!(
        points("duplicated:copies=1000", 10, 6),
        [points("disc", 1, 6)[0]; 10]
    );
}

#[test]
fn shuffling_moves_points_and_nothing_else() {
    let (plain, shuffled) = (
        points("normal", 500, 6),
        points("shuffled:of=normal", 500, 6),
    );
    assert_ne!(plain, shuffled);
    assert_eq!(sorted(plain), sorted(shuffled));
    let kept = points("shuffled:of=parabola", 500, 6)
        .windows(2)
        .filter(|pair| Exact.lexicographic(pair[0], pair[1]) == Ordering::Less)
        .count();
    assert!(
        (200..300).contains(&kept),
        "half of the neighbours stay in order: {kept}"
    );
}
