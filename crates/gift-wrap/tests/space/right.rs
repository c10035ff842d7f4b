//! Both spatial methods against the hull by trying every plane.

use crate::sets::{ball, brute_force, grid, on_grid, sphere};
use geometry_core::{Exact, Hull3, Point3, Points, Silent};

fn assert_right(points: &[Point3]) {
    let expected = brute_force(points);
    let view = Points::new(points).expect("finite points");
    assert_eq!(
        gift_wrap::pivot_wrap(view, &Exact, &mut Silent),
        Ok(expected.clone()),
        "pivot-wrap {points:?}"
    );
    assert_eq!(
        gift_wrap::nathan(view, &Exact, &mut Silent),
        Ok(expected),
        "nathan {points:?}"
    );
}

#[test]
fn few_points_of_small_grids() {
    for seed in 0..400 {
        for n in 0..12 {
            assert_right(&on_grid(seed, 2 + seed as u32 % 2, n));
        }
    }
}

#[test]
fn more_points_of_small_grids() {
    for seed in 0..40 {
        assert_right(&on_grid(seed, 3, 40));
        assert_right(&on_grid(seed, 5, 40));
    }
}

#[test]
fn whole_grids() {
    for k in 1..4 {
        assert_right(&grid(k));
    }
}

#[test]
fn random_points() {
    for seed in 0..10 {
        assert_right(&ball(seed, 40));
        assert_right(&sphere(seed, 40));
    }
}

#[test]
fn extreme_magnitudes() {
    for scale in [1e300, 1e-300, 5e-324] {
        for seed in 0..10 {
            let points: Vec<Point3> = on_grid(seed, 4, 24)
                .into_iter()
                .map(|p| p.map(|x| x * scale))
                .collect();
            assert_right(&points);
        }
    }
}

#[test]
fn the_order_of_the_points_does_not_matter() {
    let points = grid(4);
    let hull = |points: &[Point3]| {
        let view = Points::new(points).expect("finite points");
        let hull = gift_wrap::nathan(view, &Exact, &mut Silent).expect("an exact kernel");
        assert_eq!(
            gift_wrap::pivot_wrap(view, &Exact, &mut Silent),
            Ok(hull.clone())
        );
        let Hull3::Solid(solid) = hull else {
            panic!("the grid spans space")
        };
        let mut corners: Vec<Point3> = solid
            .vertices()
            .iter()
            .map(|&id| points[id as usize])
            .collect();
        corners.sort_by(|a, b| a.partial_cmp(b).expect("finite"));
        (corners, solid.facet_count())
    };
    let reversed: Vec<Point3> = points.iter().rev().copied().collect();
    assert_eq!(hull(&points).1, 6);
    assert_eq!(hull(&points), hull(&reversed));
}
