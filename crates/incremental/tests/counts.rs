//! What method R asks, counted: one orientation for each edge of the hull so far.

use geometry_core::Step::*;
use geometry_core::{
    Boundary, Counted, Exact, Hull2, HullError, Observer, Point2, Points, Recorder, Silent, Tally,
};
use hull_verify::families::{curves, random};

fn method_r(points: &[Point2], observer: &mut impl Observer) -> Result<(Hull2, u64), HullError> {
    let kernel = Counted::new(Exact);
    let hull = incremental::method_r(Points::new(points)?, Boundary::Extreme, &kernel, observer)?;
    Ok((hull, kernel.counts().orientations.total()))
}

#[test]
fn each_point_is_tested_against_each_edge_so_far() -> Result<(), HullError> {
    for points in [
        random::disc(6, 300),
        random::disc(7, 40),
        curves::parabola(40),
    ] {
        let mut expected = 1; // The first triangle.
        for i in 3..points.len() {
            expected += method_r(&points[..i], &mut Silent)?.0.len() as u64;
        }
        let mut tally = Tally::default();
        let (hull, asked) = method_r(&points, &mut tally)?;
        assert_eq!(asked, expected);
        assert_eq!(tally.visits as usize, points.len());
        assert_eq!(tally.lines, expected - 1);
        // The two ends of the first edge are there without being inserted.
        assert_eq!(2 + tally.inserts - tally.pops, hull.len() as u64);
    }
    Ok(())
}

/// Only corners, in any order: the hull grows by one a point.
#[test]
fn the_worst_case_is_quadratic() -> Result<(), HullError> {
    let points = curves::parabola(100);
    let n = points.len() as u64;
    let (hull, asked) = method_r(&points, &mut Silent)?;
    assert_eq!(hull.len() as u64, n);
    assert_eq!(asked, 1 + (3..n).sum::<u64>());
    Ok(())
}

#[test]
fn a_trace_tells_what_is_deleted() -> Result<(), HullError> {
    let points = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [1.0, 0.5], [1.0, 3.0]];
    let mut recorder = Recorder::default();
    method_r(&points, &mut recorder)?;
    #[rustfmt::skip]
    let expected = [
        Visit(0), Visit(1), Visit(2), Insert(2),
        Visit(3), Line(0, 1), Line(1, 2), Line(2, 0), Discard(3),        // inside
        Visit(4), Line(0, 1), Line(1, 2), Line(2, 0), Pop(2), Insert(4), // outside two edges
        Edge(1, 4), Edge(4, 0), Edge(0, 1),
    ];
    assert_eq!(recorder.steps, expected);
    Ok(())
}
