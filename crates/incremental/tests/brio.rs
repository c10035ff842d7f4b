//! `incremental-brio`: right where points repeat, line up and crowd, and how much it asks.

use geometry_core::{
    Counted, Exact, Hull3, HullError, Point3, Points, Recorder, Silent, Step, Tally,
};
use hull_verify::families_space::{grids, random, round};
use incremental::{incremental_brio, incremental_conflict};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::collections::HashSet;

/// Points of a family that is as degenerate as the seed wants.
fn degenerate(seed: u64) -> Vec<Point3> {
    let mut generator = ChaCha8Rng::seed_from_u64(seed);
    let mut below = |k: u64| generator.next_u64() % k;
    let n = 1 + below(60);
    // Few values an axis make copies, lines and planes; far fewer on some axes make needles and flat sets.
    let sides = [0, 1, 2].map(|_| 1 + below(8));
    let kind = below(4);
    (0..n)
        .map(|_| {
            let p = sides.map(|side| below(side) as f64);
            match kind {
                0 => p,
                // Sevenths are rounded: what was coplanar is nearly so.
                1 => p.map(|x| x / 7.0),
                // On a paraboloid: cocircular points have coplanar lifts.
                2 => [p[0], p[1], p[0] * p[0] + p[1] * p[1]],
                // Crowds around far corners.
                _ => p.map(|x| if x > 2.0 { x * 1e9 } else { x * 1e-9 }),
            }
        })
        .collect()
}

fn both(points: &[Point3]) -> Result<[Hull3; 2], HullError> {
    let points = Points::new(points)?;
    Ok([
        incremental_brio(points, &Exact, &mut Silent)?,
        incremental_conflict(points, &Exact, &mut Silent)?,
    ])
}

/// As many sets as `BRIO_SETS` says; two thousand if it does not.
#[test]
fn small_degenerate_sets_have_the_hull_of_another_method() -> Result<(), HullError> {
    let sets = std::env::var("BRIO_SETS").map_or(2_000, |sets| sets.parse().expect("a number"));
    for seed in 0..sets {
        let points = degenerate(seed);
        let [hull, other] = both(&points)?;
        assert_eq!(hull, other, "seed {seed}: {points:?}");
    }
    Ok(())
}

/// A sphere beside a point so far away that all of it is in one cell of the first grid.
#[test]
fn a_crowd_is_ordered_again() -> Result<(), HullError> {
    let mut points = round::sphere(3, 20_000);
    points.push([1e6, 1e6, 1e6]);
    let (_, alone) = counted(&points[..20_000])?;
    let (_, crowded) = counted(&points)?;
    assert!(crowded < 1.1 * alone, "{crowded} against {alone}");
    let [hull, other] = both(&points[..2_000])?;
    assert_eq!(hull, other);
    Ok(())
}

/// The tally, and the questions of walks and searches a point.
fn counted(points: &[Point3]) -> Result<(Tally, f64), HullError> {
    let mut tally = Tally::default();
    incremental_brio(Points::new(points)?, &Exact, &mut tally)?;
    let asked = (tally.visits + tally.lines) as f64;
    Ok((tally, asked / points.len() as f64))
}

/// Nothing is asked but what is tallied, three orientations for the dimension, and one for the merging at each edge between
/// two triangles of one cone, whose third corners are the same.
#[test]
fn every_question_is_accounted_for() -> Result<(), HullError> {
    let sphere = round::sphere(4, 1_000);
    let points = Points::new(&sphere)?;
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    incremental_brio(points, &kernel, &mut tally)?;
    let mut recorder = Recorder::default();
    incremental_brio(points, &Exact, &mut recorder)?;
    let for_merging = edges_within_cones(&recorder.steps);
    let asked = kernel.counts().orientations_in_space;
    assert_eq!(asked.total(), tally.visits + tally.lines + for_merging + 3);
    // Most edges were on the rim of a cone.
    let edges = 3 * (tally.facets - tally.drops) / 2;
    assert!(2 * for_merging < edges, "{for_merging} of {edges}");
    // One of the three, about a corner of the plane itself, is zero.
    assert_eq!(asked.total(), asked.filter + 1);
    Ok(())
}

/// How many edges at their common third corner the triangles share that were made and not dropped.
fn edges_within_cones(steps: &[Step]) -> u64 {
    let mut left = HashSet::new();
    for step in steps {
        match *step {
            Step::Facet(a, b, apex) => _ = left.insert([a, b, apex]),
            Step::Drop(a, b, apex) => _ = left.remove(&[a, b, apex]),
            _ => {}
        }
    }
    let begins: HashSet<[u32; 2]> = left.iter().map(|&[a, _, apex]| [a, apex]).collect();
    let shared = left
        .iter()
        .filter(|&&[_, b, apex]| begins.contains(&[b, apex]));
    shared.count() as u64
}

/// Edges that a point was in the plane of are asked about again: an octahedron whose facets have points in them, and
/// along their edges.
#[test]
fn coplanar_triangles_on_both_sides_of_a_rim_are_merged() -> Result<(), HullError> {
    let all = (0..9_i32.pow(3)).map(|i| [i % 9 - 4, i / 9 % 9 - 4, i / 81 - 4]);
    let on_surface = all.filter(|p| p.iter().map(|x| x.abs()).sum::<i32>() == 4);
    let points: Vec<Point3> = on_surface.map(|p| p.map(f64::from)).collect();
    let [hull, other] = both(&points)?;
    assert_eq!(hull, other);
    assert_eq!((hull.len(), hull.facets().count()), (6, 8));
    Ok(())
}

/// Visibility tests and steps a point do not grow with n.
#[test]
fn questions_on_a_sphere_are_linear() -> Result<(), HullError> {
    for n in [1_000, 10_000, 100_000] {
        let (tally, asked) = counted(&round::sphere(4, n))?;
        let [facets, visits, lines] =
            [tally.facets, tally.visits, tally.lines].map(|count| count as f64 / n as f64);
        assert_eq!(tally.inserts as usize, n - 4);
        assert!((5.8..6.3).contains(&facets), "n = {n}: {facets} facets");
        assert!((10.0..11.5).contains(&visits), "n = {n}: {visits} visits");
        assert!((1.5..2.5).contains(&lines), "n = {n}: {lines} sides");
        assert!(asked < 14.0, "n = {n}: {asked}");
    }
    Ok(())
}

/// Points of a curve are in order along it, however many there are: from each, the next is at hand.
#[test]
fn questions_on_a_curve_are_linear() -> Result<(), HullError> {
    for n in [1_000, 10_000, 100_000] {
        let mut generator = ChaCha8Rng::seed_from_u64(6);
        let points: Vec<Point3> = (0..n)
            .map(|_| generator.next_u32() as f64 / f64::from(1 << 31) - 1.0)
            .map(|t| [t, t * t, t * t * t])
            .collect();
        let (_, asked) = counted(&points)?;
        assert!(asked < 10.0, "n = {n}: {asked}");
    }
    Ok(())
}

/// The rounds are random: points put in the order of an adversary cost no more. On a circle and then up its axis, each
/// point of the axis sees all that the last one made.
#[test]
fn no_order_of_the_points_is_bad() -> Result<(), HullError> {
    let m = 2_000;
    let turn = std::f64::consts::TAU / f64::from(m);
    let circle = (0..m).map(|i| {
        [
            (turn * f64::from(i)).cos(),
            (turn * f64::from(i)).sin(),
            0.0,
        ]
    });
    let points: Vec<Point3> = circle
        .chain((1..=m).map(|z| [0.0, 0.0, f64::from(z)]))
        .collect();
    let (tally, _) = counted(&points)?;
    assert!(tally.facets < 60 * m as u64, "{} facets", tally.facets);
    Ok(())
}

/// Points inside take a walk each, and little more.
#[test]
fn questions_in_a_ball_are_few() -> Result<(), HullError> {
    let n = 20_000;
    let (tally, asked) = counted(&random::ball(5, n))?;
    assert!(tally.discards > 9 * n as u64 / 10);
    assert!(asked < 12.0, "{asked}");
    let (_, asked) = counted(&grids::cube_surface(30))?;
    assert!(asked < 40.0, "{asked}");
    Ok(())
}
