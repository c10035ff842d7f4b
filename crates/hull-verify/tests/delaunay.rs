//! The checker of Delaunay triangulations: it certifies right ones and finds what is wrong with broken ones; and the
//! suite on a right method and wrong ones.

mod flips;

use flips::by_flips;
use geometry_core::{HullError, Method, Point2, Points, Task, Triangulation, delaunay_task};
use hull_verify::check::{self, DelaunayFinding as Finding};
use hull_verify::families::{self, grids};
use hull_verify::{conformance, families::random};

type Answer = Result<Triangulation, HullError>;

fn right(points: Points<'_, 2>) -> Answer {
    Ok(by_flips(points.as_slice()))
}

/// Any triangulation will do, it thinks.
fn without_flips(points: Points<'_, 2>) -> Answer {
    Ok(flips::by_sweep(points.as_slice()))
}

/// Computes coordinates relative to the first point in `f32`.
fn rounded(points: Points<'_, 2>) -> Answer {
    let slice = points.as_slice();
    let singles: Vec<Point2> = slice
        .iter()
        .map(|p| p.map(|x| f64::from(x as f32)))
        .collect();
    Ok(if singles.as_flattened().iter().all(|x| x.is_finite()) {
        by_flips(&singles)
    } else {
        by_flips(slice)
    })
}

fn run(slug: &'static str, task: Task) {
    conformance::delaunay(&Method {
        slug,
        title: "a method for testing the suite",
        citation: "",
        departures: &[],
        cost: "",
        task,
    });
}

fn rejection(slug: &'static str, task: Task) -> String {
    let panic = std::panic::catch_unwind(|| run(slug, task)).expect_err("a wrong method passed");
    panic
        .downcast_ref::<String>()
        .expect("the suite panics with a report")
        .clone()
}

#[test]
fn a_right_method_passes() {
    run("flips", delaunay_task!(right));
}

#[test]
fn wrong_methods_are_rejected_with_a_report() {
    let report = rejection("no-flips", delaunay_task!(without_flips));
    assert!(
        report.contains("is inside the circle round triangle"),
        "{report}"
    );
    let report = rejection("rounded", delaunay_task!(rounded));
    assert!(report.contains("rounded fails on"), "{report}");
}

fn findings(points: &[Point2], triangles: &[[u32; 3]]) -> Vec<Finding> {
    check::delaunay(points, &Triangulation::new(triangles.to_vec()))
        .expect_err("a broken triangulation was certified")
}

///     2---3---4
///     | / | \ |
///     0---5---1
const SIX: [Point2; 6] = [
    [0.0, 0.0],
    [4.0, 0.0],
    [0.0, 2.0],
    [2.0, 2.0],
    [4.0, 2.0],
    [2.0, 0.0],
];

#[test]
fn cocircular_points_may_be_cut_either_way() {
    for left in [[[0, 5, 3], [0, 3, 2]], [[0, 5, 2], [5, 3, 2]]] {
        for right in [[[5, 1, 3], [1, 4, 3]], [[5, 1, 4], [5, 4, 3]]] {
            let all = Triangulation::new([left, right].concat());
            let certificate = check::delaunay(&SIX, &all).expect("both are right");
            assert_eq!((certificate.cocircular, certificate.hull_edges), (2, 6));
        }
    }
}

#[test]
fn each_kind_of_breakage_is_found() {
    let whole = [[0, 5, 3], [0, 3, 2], [5, 1, 3], [1, 4, 3]];
    let without = |i: usize| {
        let mut triangles = whole.to_vec();
        triangles.remove(i);
        triangles
    };
    let with = |i: usize, triangle: [u32; 3]| {
        let mut triangles = whole.to_vec();
        triangles[i] = triangle;
        triangles
    };
    assert_eq!(
        findings(&SIX, &with(0, [0, 6, 3])),
        [Finding::NoSuchPoint { id: 6, count: 6 }]
    );
    assert_eq!(
        findings(&SIX, &[]),
        [Finding::NoTriangles {
            witnesses: [0, 4, 1]
        }]
    );
    assert_eq!(
        findings(&SIX, &without(1)),
        [Finding::MissingVertex { point: 2 }]
    );
    assert_eq!(
        findings(&SIX, &without(0)),
        [Finding::OutlineBreaks { vertex: 3 }]
    );
    // In canonical order 0 3 2 is triangle 0.
    assert_eq!(
        findings(&SIX, &with(0, [0, 3, 5])),
        [Finding::Clockwise { triangle: 1 }]
    );
    let mut flat = whole.to_vec();
    flat.push([0, 5, 1]);
    assert_eq!(
        findings(&SIX, &flat),
        [Finding::FlatTriangle { triangle: 1 }]
    );
    let mut overlapping = whole.to_vec();
    overlapping.push([0, 5, 2]);
    let shared = |from, to, triangles| Finding::SharedEdge {
        from,
        to,
        triangles,
    };
    let expected = [shared(2, 0, [0, 1]), shared(0, 5, [1, 2])];
    assert_eq!(findings(&SIX, &overlapping), expected);

    let mut copied = SIX.to_vec();
    copied.push([2.0, 0.0]);
    assert!(check::delaunay(&copied, &Triangulation::new(whole.to_vec())).is_ok());
    let larger = [[0, 6, 3], [0, 3, 2], [6, 1, 3], [1, 4, 3]];
    let larger_copy = Finding::LargerCopy {
        vertex: 6,
        smaller: 5,
    };
    assert!(findings(&copied, &larger).contains(&larger_copy));

    let mut not_finite = SIX.to_vec();
    not_finite[3][1] = f64::NAN;
    assert_eq!(
        findings(&not_finite, &whole),
        [Finding::NotFinite { point: 3 }]
    );
    // A point in the middle of an edge that is not a corner of one of the two triangles there.
    let hanging = [[0, 1, 3], [0, 3, 2], [1, 4, 3]];
    assert_eq!(
        findings(&SIX, &hanging),
        [Finding::MissingVertex { point: 5 }]
    );
}

#[test]
fn triangles_that_go_round_twice_are_found() {
    // A pentagram of triangles about a centre: anticlockwise, every edge once, and covered twice.
    let corner = |i: u32| {
        let angle = std::f64::consts::TAU * f64::from(i) / 5.0;
        [angle.cos(), angle.sin()]
    };
    let mut points: Vec<Point2> = (0..5).map(corner).collect();
    points.push([0.0, 0.0]);
    let star: Vec<[u32; 3]> = (0..5).map(|i| [5, i, (i + 2) % 5]).collect();
    assert_eq!(
        findings(&points, &star),
        [Finding::OutlineWinding { revolutions: 2 }]
    );
    // Two triangles apart.
    let apart = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [5.0, 5.0],
        [6.0, 5.0],
        [5.0, 6.0],
    ];
    let found = findings(&apart, &[[0, 1, 2], [3, 4, 5]]);
    assert_eq!(found, [Finding::OutlineWinding { revolutions: 2 }]);
}

/// Of all triangulations made by flipping one edge of a right one, only those that flip a diagonal of cocircular
/// points are certified.
#[test]
fn one_flip_away_from_right_is_wrong() {
    for points in [
        random::square(61, 30),
        grids::lattice(4),
        families::curves::circle(20),
    ] {
        let right = by_flips(&points);
        let certificate = check::delaunay(&points, &right).expect("right");
        let (mut certified, mut flipped) = (0, 0);
        for other in flips::neighbours(&points, &right) {
            flipped += 1;
            certified += usize::from(check::delaunay(&points, &other).is_ok());
        }
        assert!(flipped > 10);
        assert_eq!(certified, certificate.cocircular);
    }
}
