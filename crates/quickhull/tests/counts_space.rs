//! What the spatial quickhulls ask, counted.
//!
//! Published figures for the plane questions a point, with a plain quickhull (furthest point first, one outside set a
//! point): 12.4 12.3 12.4 in a ball and 9.0 8.4 8.3 in a cube at n = 10³, 10⁴, 10⁵; 34.6 50.7 66.0 on a sphere.

use geometry_core::Step::*;
use geometry_core::{Counted, Exact, Hull3, HullError, Observer, Point3, Points, Recorder, Tally};
use hull_verify::families_space::{grids, random, round};

/// The hull, the steps, and the orientations asked before the facets are merged: the merging asks one for
/// each edge of the surface.
fn quickhull_3d(points: &[Point3]) -> Result<(Hull3, Tally, f64), HullError> {
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let hull = quickhull::quickhull_3d(Points::new(points)?, &kernel, &mut tally)?;
    let merging = 3 * (tally.facets - tally.drops) / 2;
    let asked = kernel.counts().orientations_in_space.total() - merging;
    Ok((hull, tally, asked as f64 / points.len() as f64))
}

/// Averages of four sets: how much the first tetrahedron cuts off a cube depends on where the extreme points fall.
#[test]
fn questions_in_a_ball_and_a_cube_are_linear() -> Result<(), HullError> {
    let average = |family: fn(u64, usize) -> Vec<Point3>, n: usize| {
        let each = (0..4).map(|seed| quickhull_3d(&family(seed, n)).map(|(_, _, asked)| asked));
        Ok::<f64, HullError>(each.sum::<Result<f64, _>>()? / 4.0)
    };
    for n in [1_000, 10_000, 100_000] {
        let ball = average(random::ball, n)?;
        assert!((11.5..13.5).contains(&ball), "ball, n = {n}: {ball}");
        let cube = average(random::cube, n)?;
        assert!((7.0..11.0).contains(&cube), "cube, n = {n}: {cube}");
    }
    Ok(())
}

#[test]
fn questions_on_a_sphere_grow_with_the_logarithm() -> Result<(), HullError> {
    let mut before = None;
    for (n, expected) in [(1_000, 34.6), (10_000, 50.7), (100_000, 66.0)] {
        let (_, tally, asked) = quickhull_3d(&round::sphere(1, n))?;
        assert!((asked / expected - 1.0).abs() < 0.1, "n = {n}: {asked}");
        // About 16 more for each power of ten.
        let growth = asked - before.replace(asked).unwrap_or(asked - 16.0);
        assert!((13.0..19.0).contains(&growth), "n = {n}: {growth}");
        let made = tally.facets as f64 / (tally.facets - tally.drops) as f64;
        assert!(
            (2.6..3.0).contains(&made),
            "n = {n}: {made} facets made for each that stays"
        );
    }
    Ok(())
}

/// The description of Balan et al. asks more, as each new facet is tested against the whole merged set.
#[test]
fn one_claim_a_point_saves_questions() -> Result<(), HullError> {
    for points in [
        random::ball(2, 5_000),
        round::sphere(2, 2_000),
        grids::lattice(10),
    ] {
        let (hull, steps, _) = quickhull_3d(&points)?;
        let mut tally = Tally::default();
        let described = quickhull::balan_quickhull(Points::new(&points)?, &Exact, &mut tally)?;
        assert_eq!(described, hull);
        assert!(
            tally.visits > steps.visits,
            "{} against {}",
            tally.visits,
            steps.visits
        );
    }
    Ok(())
}

/// O(m n) is the text's own bound, for m facets made. It is loose by orders of magnitude.
#[test]
fn the_bound_of_the_description_is_loose() -> Result<(), HullError> {
    let points = random::ball(3, 10_000);
    let mut tally = Tally::default();
    quickhull::balan_quickhull(Points::new(&points)?, &Exact, &mut tally)?;
    let bound = tally.facets * points.len() as u64;
    assert!(tally.visits * 50 < bound, "{} of {bound}", tally.visits);
    Ok(())
}

/// A closed surface of triangles has an even number of them, and 2 V - 4 for V corners; V is at most the number of
/// points inserted.
#[test]
fn the_surface_is_closed() -> Result<(), HullError> {
    for points in [
        random::ball(4, 500),
        round::sphere(4, 500),
        grids::cube_surface(6),
    ] {
        for run in [run::<Tally>, run_described] {
            let mut tally = Tally::default();
            run(&points, &Exact, &mut tally)?;
            let triangles = tally.facets - tally.drops;
            assert_eq!(triangles % 2, 0);
            assert!(triangles <= 2 * (tally.inserts + 4) - 4);
            assert_eq!(tally.apexes, tally.inserts);
        }
    }
    Ok(())
}

fn run<O: Observer>(
    points: &[Point3],
    kernel: &Exact,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    quickhull::quickhull_3d(Points::new(points)?, kernel, observer)
}

fn run_described<O: Observer>(
    points: &[Point3],
    kernel: &Exact,
    observer: &mut O,
) -> Result<Hull3, HullError> {
    quickhull::balan_quickhull(Points::new(points)?, kernel, observer)
}

/// A tetrahedron with a point inside and one beyond a facet.
#[test]
fn a_trace_tells_what_is_dropped() -> Result<(), HullError> {
    let points = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [0.0, 0.0, 4.0],
        [0.5, 0.5, 0.5],
        [2.0, 2.0, 2.0],
    ];
    let mut recorder = Recorder::default();
    run(&points, &Exact, &mut recorder)?;
    #[rustfmt::skip]
    let expected = [
        // Each facet claims from the points that those before it left.
        Facet(0, 2, 1), Visit(4), Visit(5),
        Facet(0, 1, 3), Visit(4), Visit(5),
        Facet(1, 2, 3), Visit(4), Visit(5), Storage(1),
        Facet(2, 0, 3), Visit(4),
        Discard(4),
        Apex(5), Drop(1, 2, 3), Insert(5), Facet(1, 2, 5), Facet(2, 3, 5), Facet(3, 1, 5),
    ];
    assert_eq!(recorder.steps, expected);
    let mut recorder = Recorder::default();
    run_described(&points, &Exact, &mut recorder)?;
    #[rustfmt::skip]
    let expected = [
        // Two of 1, 2, 3 are furthest apart, the third is furthest from their line, and 5 from the plane of all.
        Facet(1, 3, 2), Visit(0), Visit(4),
        Facet(1, 2, 5), Visit(0), Visit(4),
        Facet(2, 3, 5), Visit(0), Visit(4),
        Facet(3, 1, 5), Visit(0), Visit(4),
        Apex(0), Drop(1, 3, 2), Insert(0),
        // 4 was in the outside set of the facet dropped: each new one is tested against it.
        Facet(1, 3, 0), Visit(4), Facet(3, 2, 0), Visit(4), Facet(2, 1, 0), Visit(4),
    ];
    assert_eq!(recorder.steps, expected);
    Ok(())
}
