//! Canonical results: what is equal, what is first, what stands for copies.

use geometry_core::{Boundary, Exact, Hull2, HullError, Layers, Points};

#[test]
fn a_cycle_starts_at_its_lexicographically_smallest_vertex() {
    let square = [[1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
    let points = Points::new(&square).expect("finite");
    let expected = Hull2::Polygon(vec![2, 3, 0, 1]);
    for turn in 0..4 {
        let mut cycle = vec![0, 1, 2, 3];
        cycle.rotate_left(turn);
        assert_eq!(Hull2::from_cycle(points, cycle), expected);
    }
    assert_eq!(expected.area(points), 1.0);
    assert_eq!(expected.perimeter(points), 4.0);
}

#[test]
fn collinear_points_make_a_segment_and_copies_a_point() {
    let row = [[2.0, 2.0], [1.0, 1.0], [0.0, 0.0], [1.0, 1.0], [0.0, -0.0]];
    let points = Points::new(&row).expect("finite");
    let hull = |ids: Vec<u32>, boundary| Hull2::of_collinear(points, ids, boundary, &Exact);
    assert_eq!(
        hull(vec![4, 3, 2, 1, 0], Boundary::Extreme),
        Hull2::Segment(vec![2, 0])
    );
    assert_eq!(
        hull(vec![4, 3, 2, 1, 0], Boundary::All),
        Hull2::Segment(vec![2, 1, 0])
    );
    assert_eq!(hull(vec![3, 1], Boundary::All), Hull2::Point(1));
    assert_eq!(hull(vec![], Boundary::All), Hull2::Empty);
}

#[test]
fn the_first_coordinate_that_is_not_finite_is_named() {
    let mut many = vec![[0.0, 1.0]; 1000];
    many[700][1] = f64::INFINITY;
    many[900][0] = f64::NAN;
    let error = Points::new(&many).expect_err("an infinity");
    assert_eq!(
        error,
        HullError::NotFinite {
            index: 700,
            axis: 1,
            value: f64::INFINITY
        }
    );
    assert_eq!(
        error.to_string(),
        "point 700: y is inf; every coordinate must be finite"
    );
    assert!(Points::new(&[[f64::MAX, f64::MIN_POSITIVE / 4.0]]).is_ok());
}

#[test]
fn mid_ranks_share_the_mean_of_their_places() {
    let layers = Layers::new(
        vec![Hull2::Polygon(vec![0, 1, 2]), Hull2::Point(3)],
        vec![1, 1, 1, 2, 2],
    );
    assert_eq!(layers.mid_ranks(), [2.0, 2.0, 2.0, 4.5, 4.5]);
}
