//! The oracle in space against answers made by hand, and against a second definition of an extreme point.

use geometry_core::hull3::Solid;
use geometry_core::{Hull3, Point3};
use hull_verify::arithmetic::scale::{Scale, Side, order3};
use hull_verify::families_space::{self, few, grids, magnitudes, planes, round};
use hull_verify::oracle::hull3;

fn solid(facets: &[&[u32]]) -> Hull3 {
    Hull3::Solid(Solid::from_loops(
        facets.iter().map(|f| f.to_vec()).collect(),
    ))
}

#[test]
fn nothing_one_point_and_copies() {
    assert_eq!(hull3(&[]), Hull3::Empty);
    assert_eq!(hull3(&[[1.0, 2.0, 3.0]]), Hull3::Point(0));
    assert_eq!(
        hull3(&[[0.0, -0.0, 0.0], [-0.0, 0.0, 0.0]]),
        Hull3::Point(0)
    );
}

#[test]
fn points_on_a_line() {
    let points = [[2.0; 3], [4.0; 3], [1.0; 3], [4.0; 3], [1.0; 3]];
    assert_eq!(hull3(&points), Hull3::Segment([2, 1]));
    let upright = [[0.0, 0.0, 5.0], [0.0, 0.0, -5.0], [0.0, -0.0, 1.0]];
    assert_eq!(hull3(&upright), Hull3::Segment([1, 0]));
}

#[test]
fn a_lattice_in_every_plane() {
    // Corners 6 8 2 0 in the plane; the first is the smallest in space, the second the smaller of its neighbours.
    let grid = hull_verify::families::grids::lattice(3);
    for (name, plane) in planes::PLANES {
        let points = planes::in_plane(&grid, plane);
        let Hull3::Planar(ids) = hull3(&points) else {
            panic!("{name} is flat");
        };
        let at = |i: usize| points[ids[i] as usize];
        let mut sorted = ids.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, [0, 2, 6, 8], "{name}");
        assert!((1..4).all(|i| order3(at(0), at(i)).is_lt()), "{name}");
        assert!(order3(at(1), at(3)).is_lt(), "{name}");
        assert_eq!(ids[0] + ids[2], 8, "{name}");
    }
}

#[test]
fn a_tetrahedron_with_copies() {
    // 0, 1, 2 are inside, on a facet, on an edge; 3 to 6 are the corners, then copies of them.
    let expected = solid(&[&[3, 5, 4], &[3, 4, 6], &[4, 5, 6], &[3, 6, 5]]);
    assert_eq!(hull3(&few::tetrahedron_with_copies(3)), expected);
}

#[test]
fn a_lattice_is_a_cube() {
    // Corner (x, y, z) of the 3 x 3 x 3 lattice has the index 2x + 6y + 18z.
    let expected = solid(&[
        &[0, 6, 8, 2],
        &[18, 20, 26, 24],
        &[0, 2, 20, 18],
        &[6, 24, 26, 8],
        &[0, 18, 24, 6],
        &[2, 8, 26, 20],
    ]);
    assert_eq!(hull3(&grids::lattice(3)), expected);
    assert_eq!(hull3(&magnitudes::subnormal_lattice()), expected);
    assert_eq!(hull3(&magnitudes::far_from_origin()), expected);
}

#[test]
fn an_octahedron() {
    let points = [
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let expected = solid(&[
        &[0, 2, 4],
        &[2, 1, 4],
        &[1, 3, 4],
        &[3, 0, 4],
        &[2, 0, 5],
        &[1, 2, 5],
        &[3, 1, 5],
        &[0, 3, 5],
    ]);
    assert_eq!(hull3(&points), expected);
}

fn counts(points: &[Point3]) -> [usize; 3] {
    match hull3(points) {
        Hull3::Solid(solid) => [
            solid.vertices().len(),
            solid.edge_count(),
            solid.facet_count(),
        ],
        flat => panic!("{flat:?} is flat"),
    }
}

#[test]
fn vertices_edges_and_facets_as_the_textbook_has_them() {
    assert_eq!(counts(&grids::tilted_box()), [8, 12, 6]);
    assert_eq!(counts(&grids::octahedron(3)), [6, 12, 8]);
    assert_eq!(counts(&grids::octahedron_with_midpoints()), [6, 12, 8]);
    assert_eq!(counts(&grids::jack(3)), [6, 12, 8]);
    assert_eq!(counts(&grids::four_columns(7)), [8, 12, 6]);
    assert_eq!(counts(&round::prism()), [72, 108, 38]);
    assert_eq!(counts(&round::antiprism(3))[0], 6);
    // All facets of a cyclic polytope are triangles.
    assert_eq!(
        counts(&round::moment_curve(17)),
        [17, 3 * 17 - 6, 2 * 17 - 4]
    );
    assert_eq!(counts(&round::paraboloid(6))[0], 36);
}

/// A point is extreme if and only if it is in no tetrahedron, triangle or segment of other places (Carathéodory).
#[test]
fn agrees_with_the_definition_by_simplices() {
    for family in families_space::all() {
        let points = &family.points;
        if points.len() > 16 {
            continue;
        }
        let scale = Scale::of(points);
        let hull = hull3(points);
        for (id, &p) in (0..).zip(points) {
            let first = points.iter().position(|&q| q == p) == Some(id as usize);
            let others: Vec<Point3> = points.iter().copied().filter(|&q| q != p).collect();
            let expected = first && !in_a_simplex(scale, &others, p);
            assert_eq!(
                hull.vertices().contains(&id),
                expected,
                "{}: point {id}",
                family.name
            );
        }
    }
}

/// Whether p is inside a segment, a triangle or a tetrahedron of `others`. Where p is on an edge or a face of one, it is
/// inside a simplex of lower dimension or equal to a corner.
fn in_a_simplex(scale: Scale, others: &[Point3], p: Point3) -> bool {
    let n = others.len();
    let between = |a: Point3, b: Point3| scale.collinear(a, b, p) && order3(a, p) == order3(p, b);
    let in_triangle = |a: Point3, b: Point3, c: Point3| {
        if scale.side(a, b, c, p) != Side::On || scale.collinear(a, b, c) {
            return false;
        }
        geometry_core::Axis::ALL.into_iter().all(|axis| {
            let turns = [(a, b), (b, c), (c, a)].map(|(from, to)| scale.turn(axis, from, to, p));
            let whole = scale.turn(axis, a, b, c);
            turns.into_iter().all(|turn| turn == whole)
        })
    };
    let in_tetrahedron = |a: Point3, b: Point3, c: Point3, d: Point3| {
        let whole = scale.side(a, b, c, d);
        whole != Side::On
            && [
                scale.side(p, b, c, d),
                scale.side(a, p, c, d),
                scale.side(a, b, p, d),
                scale.side(a, b, c, p),
            ] == [whole; 4]
    };
    let o = |i: usize| others[i];
    (0..n).any(|i| {
        (0..i).any(|j| {
            between(o(i), o(j))
                || (0..j).any(|k| {
                    in_triangle(o(i), o(j), o(k))
                        || (0..k).any(|l| in_tetrahedron(o(i), o(j), o(k), o(l)))
                })
        })
    })
}
