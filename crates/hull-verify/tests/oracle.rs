//! The oracle against answers made by hand, and against a second definition of an extreme point.

use geometry_core::{Boundary, Hull2, Point2};
use hull_verify::arithmetic::{Frame, Turn, order};
use hull_verify::families::{self, curves, grids, magnitudes};
use hull_verify::oracle;

fn both(points: &[Point2]) -> [Hull2; 2] {
    [Boundary::Extreme, Boundary::All].map(|boundary| oracle::hull2(points, boundary))
}

#[test]
fn no_point_one_point_and_copies() {
    assert_eq!(both(&[]), [Hull2::Empty, Hull2::Empty]);
    assert_eq!(both(&[[5.0, 5.0]]), [Hull2::Point(0), Hull2::Point(0)]);
    assert_eq!(both(&[[5.0, 5.0]; 4]), [Hull2::Point(0), Hull2::Point(0)]);
    assert_eq!(
        both(&[[0.0, -0.0], [-0.0, 0.0]]),
        [Hull2::Point(0), Hull2::Point(0)]
    );
}

#[test]
fn collinear_points() {
    //     1   3,0   2        at x = 1, 2, 4
    let points = [[2.0, 2.0], [1.0, 1.0], [4.0, 4.0], [2.0, 2.0]];
    let expected = [Hull2::Segment(vec![1, 2]), Hull2::Segment(vec![1, 0, 2])];
    assert_eq!(both(&points), expected);
    let upright = [[1.0, 2.0], [1.0, 3.0], [1.0, -4.0]];
    let expected = [Hull2::Segment(vec![2, 1]), Hull2::Segment(vec![2, 0, 1])];
    assert_eq!(both(&upright), expected);
}

#[test]
fn a_lattice() {
    //     0 1 2
    //     3 4 5
    //     6 7 8
    let expected = [
        Hull2::Polygon(vec![6, 8, 2, 0]),
        Hull2::Polygon(vec![6, 7, 8, 5, 2, 1, 0, 3]),
    ];
    assert_eq!(both(&grids::lattice(3)), expected);
}

#[test]
fn tenths_are_not_on_one_line() {
    // 0.1 · 3 is rounded up and 0.3 · 3 down, so point 3 lies below the line through the others.
    let points = [[0.0, 0.0], [0.1, 0.3], [0.2, 0.6], [0.1 * 3.0, 0.3 * 3.0]];
    let expected = [
        Hull2::Polygon(vec![0, 3, 2]),
        Hull2::Polygon(vec![0, 3, 2, 1]),
    ];
    assert_eq!(both(&points), expected);
}

#[test]
fn the_least_and_the_largest_numbers() {
    // 5e-324 is enough to leave the line of the far points.
    let points = [
        [-1e308, 0.0],
        [1e308, 0.0],
        [0.0, -5e-324],
        [0.0, 5e-324],
        [7.0, 0.0],
    ];
    let polygon = || Hull2::Polygon(vec![0, 2, 1, 3]);
    assert_eq!(both(&points), [polygon(), polygon()]);
    assert_eq!(
        both(&magnitudes::subnormal_lattice(3)),
        both(&grids::lattice(3))
    );
}

#[test]
fn layers_by_hand() {
    //     2 . . . 1
    //     . 6 . 5 .
    //     . . 8 . .        and a copy 9 of 8, 10 of 0
    //     . 4 . 7 .
    //     0 . . . 3
    let points = [
        [0.0, 0.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [4.0, 0.0],
        [1.0, 1.0],
        [3.0, 3.0],
        [1.0, 3.0],
        [3.0, 1.0],
        [2.0, 2.0],
        [2.0, 2.0],
        [0.0, 0.0],
    ];
    for boundary in [Boundary::Extreme, Boundary::All] {
        let layers = oracle::layers(&points, boundary);
        let rings = [
            Hull2::Polygon(vec![0, 3, 1, 2]),
            Hull2::Polygon(vec![4, 7, 5, 6]),
            Hull2::Point(8),
        ];
        assert_eq!(layers.rings(), rings);
        assert_eq!(layers.c_ranks(), [1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 1]);
    }
}

#[test]
fn the_two_boundaries_peel_a_row_differently() {
    let row: Vec<Point2> = [0.0, 1.0, 2.0, 3.0, 4.0].map(|x| [x, 0.0]).to_vec();
    assert_eq!(
        oracle::layers(&row, Boundary::Extreme).c_ranks(),
        [1, 2, 3, 2, 1]
    );
    assert_eq!(
        oracle::layers(&row, Boundary::All).c_ranks(),
        [1, 1, 1, 1, 1]
    );
    assert_eq!(oracle::layers(&[], Boundary::All).len(), 0);
}

#[test]
fn nested_triangles_are_layers() {
    let layers = oracle::layers(&curves::nested_triangles(7), Boundary::Extreme);
    assert_eq!(layers.len(), 7);
    assert!(layers.rings().iter().all(|ring| ring.len() == 3));
}

/// A point is extreme if and only if it is in no triangle and on no segment of other places (Carathéodory).
#[test]
fn agrees_with_the_definition_by_triangles() {
    for family in families::all() {
        let points = &family.points;
        let frame = Frame::of(points);
        if points.len() > 40 {
            continue;
        }
        let extreme = oracle::hull2(points, Boundary::Extreme);
        for (id, &p) in (0..).zip(points) {
            let first = points.iter().position(|&q| q == p) == Some(id as usize);
            let others: Vec<Point2> = points.iter().copied().filter(|&q| q != p).collect();
            let expected = first && !in_a_triangle(frame, &others, p);
            let found = extreme.vertices().contains(&id);
            assert_eq!(found, expected, "{}: point {id}", family.name);
        }
    }
}

/// Whether p is in the closed triangle of some three of `others`, flat ones included.
fn in_a_triangle(frame: Frame, others: &[Point2], p: Point2) -> bool {
    let between =
        |a: Point2, b: Point2| frame.turn(a, b, p) == Turn::Straight && order(a, p) == order(p, b);
    let inside = |a: Point2, b: Point2, c: Point2| {
        let turns = [
            frame.turn(a, b, p),
            frame.turn(b, c, p),
            frame.turn(c, a, p),
        ];
        turns == [Turn::Left; 3] || turns == [Turn::Right; 3]
    };
    // On the boundary of a triangle p is on one of its edges, so strict insides are enough for the rest.
    others.iter().enumerate().any(|(i, &a)| {
        others[..i]
            .iter()
            .enumerate()
            .any(|(j, &b)| between(a, b) || others[..j].iter().any(|&c| inside(a, b, c)))
    })
}
