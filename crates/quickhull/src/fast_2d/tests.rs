//! What is certified lies strictly inside, and would not with a smaller bound.

use super::ellipse::Ellipse;
use super::octagon::Octagon;
use super::polygon::{Corners, Edge, Polygon};
use super::region::{BLOCK, Kept, Region};
use super::sample::Sample;
use geometry_core::{Exact, Kernel2, Point2};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const U: f64 = f64::EPSILON / 2.0;

/// Whether p is an inner point of the hull of the corners: to the left of every line through two of them that has no
/// corner on its right.
fn is_inner(corners: &[Point2], p: Point2) -> bool {
    let supports = |a: Point2, b: Point2| {
        a != b
            && corners
                .iter()
                .all(|&c| !Exact.orient(a, b, c).is_negative())
    };
    let mut lines = 0;
    for &a in corners {
        for &b in corners {
            if supports(a, b) {
                lines += 1;
                if !Exact.orient(a, b, p).is_positive() {
                    return false;
                }
            }
        }
    }
    // Corners on one line, or copies of one, have no inner points.
    lines > 2
}

/// The points of the block that the region takes for inside.
fn certified(region: &impl Region, points: &[Point2; BLOCK]) -> Vec<Point2> {
    let outside = region.not_inside(points);
    let inside = |place: &usize| outside >> place & 1 == 0;
    (0..BLOCK)
        .filter(inside)
        .map(|place| points[place])
        .collect()
}

/// Points on a line but for rounding, and some units in the last place off it.
fn near(line: [Point2; 2], rng: &mut ChaCha8Rng) -> Point2 {
    let t: f64 = rng.random_range(-0.2..1.2);
    let [a, b] = line;
    [0, 1].map(|axis| {
        let x = a[axis] + t * (b[axis] - a[axis]);
        let off = rng.random_range(0..3_u64).wrapping_sub(1);
        f64::from_bits(x.to_bits().wrapping_add(off))
    })
}

/// The greatest value, in units of u M, of an edge's function at a point that does not lie to the left of the edge: what a
/// bound must not be below.
fn greatest_error(scale: f64, offset: f64, rng: &mut ChaCha8Rng) -> f64 {
    let mut greatest: f64 = 0.0;
    for _ in 0..20_000 {
        let mut corner = || [0, 1].map(|_| scale * (offset + rng.random_range(-1.0..1.0_f64)));
        let line = [corner(), corner()];
        let edge = Edge::through(line[0], line[1]);
        let most = line
            .as_flattened()
            .iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        let point = near(line, rng);
        if point[0].abs() + point[1].abs() < 2.0 * most
            && !Exact.orient(line[0], line[1], point).is_positive()
        {
            greatest = greatest.max(edge.at(point) / (U * most));
        }
    }
    greatest
}

#[test]
fn the_bound_is_needed_and_is_enough() {
    let mut rng = ChaCha8Rng::seed_from_u64(1978);
    for scale in [2.0_f64.powi(-890), 1e-30, 1.0, 1e200, 2.0_f64.powi(990)] {
        for offset in [0.0, 1.0, 1e3, 1e9] {
            let error = greatest_error(scale, offset, &mut rng);
            let case = format!("scale {scale:e}, offset {offset}: {error} u M");
            // Points that are not left of an edge are computed to be: without a bound they would be thrown away.
            assert!(error > 0.2, "{case}");
            // 16 is what the proof gives, 32 the bound.
            assert!(error < 16.0, "{case}");
        }
    }
}

/// Corners in any order, in few places, flat or folded: what is certified is an inner point of their hull.
#[test]
fn any_chain_of_corners_certifies_inner_points_only() {
    let mut rng = ChaCha8Rng::seed_from_u64(1979);
    let mut certified_in_all = 0;
    for round in 0..4_000 {
        let places = rng.random_range(2..8_i32);
        let shear = rng.random_range(0.0..1.0) / 3.0;
        let mut place = || {
            let [x, y] = [0, 1].map(|_| f64::from(rng.random_range(0..places)));
            [x + shear * y, y - shear * x]
        };
        let mut corners: Vec<Point2> = (0..6).map(|_| place()).collect();
        if round % 2 == 0 {
            // Anticlockwise about a point, but seldom convex.
            let [x, y] = place();
            corners.sort_by(|p, q| {
                let angle = |p: &Point2| (p[1] - y).atan2(p[0] - x);
                angle(p).total_cmp(&angle(q))
            });
        }
        let mut points = [[0.0; 2]; BLOCK];
        points.fill_with(&mut place);
        for (index, point) in points.iter_mut().enumerate().take(BLOCK / 2) {
            *point = near([corners[index % 6], corners[(index + 1) % 6]], &mut rng);
        }
        let chain = Corners::distinct(corners.iter().copied());
        let Some(polygon) = Polygon::of(&chain) else {
            continue;
        };
        for point in certified(&polygon, &points) {
            certified_in_all += 1;
            assert!(is_inner(&corners, point), "{point:?} among {corners:?}");
        }
    }
    assert!(
        certified_in_all > 1_000,
        "only {certified_in_all} were certified"
    );
}

/// What passes the core's comparisons is an inner point of the hull of the corners, next to its sides too.
#[test]
fn the_core_certifies_inner_points_only() {
    let mut rng = ChaCha8Rng::seed_from_u64(1980);
    let mut cores = 0;
    for _ in 0..1_500 {
        let [width, height] = [0, 1].map(|_| 2.0_f64.powi(rng.random_range(-12..12)));
        let offset = [0.0, 1.0, 1e4, 1e9][rng.random_range(0..4)];
        let mut place = || {
            let [x, y] = [0, 1].map(|_| offset + rng.random_range(-1.0..1.0_f64));
            [width * x, height * y]
        };
        let cloud: Vec<Point2> = (0..40).map(|_| place()).collect();
        let corners = Corners::of(Sample::all(&cloud))
            .expect("there are points")
            .refined(Sample::all(&cloud));
        let centre = [width * offset, height * offset];
        let Some(core) =
            Polygon::of(&corners).and_then(|polygon| Octagon::inside(&polygon, &corners, centre))
        else {
            continue;
        };
        cores += 1;
        let ends = core.ends();
        let mut points = [[0.0; 2]; BLOCK];
        points.fill_with(&mut place);
        for (index, point) in points.iter_mut().enumerate().take(BLOCK / 2) {
            *point = near([ends[index % 8], ends[(index + 3) % 8]], &mut rng);
        }
        for point in certified(&core, &points) {
            assert!(is_inner(corners.as_slice(), point), "{point:?} in {core:?}");
        }
    }
    assert!(cores > 500, "only {cores} cores");
}

/// The octagon of the proof reaches beyond the polygon if its shrinking is left out, and the check says so.
#[test]
fn an_octagon_that_sticks_out_is_refused() {
    let circle: Vec<Point2> = (0..16)
        .map(|i| f64::from(i) * std::f64::consts::PI / 8.0 + 0.2)
        .map(|angle| [angle.cos(), angle.sin()])
        .collect();
    let corners = Corners::distinct(circle);
    let polygon = Polygon::of(&corners).expect("sixteen corners");
    let around = Octagon::around(&corners).expect("as wide as high");
    assert!(!around.is_inside(&polygon));
    let core = Octagon::inside(&polygon, &corners, [0.0, 0.0]).expect("room about the centre");
    assert!(core.is_inside(&polygon));
    // A centre outside leaves no room.
    assert!(Octagon::inside(&polygon, &corners, [2.0, 0.0]).is_none());
}

#[test]
fn what_is_not_finite_or_far_away_is_not_inside() {
    let corners = Corners::distinct([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]);
    let polygon = Polygon::of(&corners).expect("a square");
    let octagon = Octagon::inside(&polygon, &corners, [0.0, 0.0]).expect("room about the centre");
    let ellipse = Ellipse::inside(&polygon, &corners, [0.0, 0.0]).expect("room about the centre");
    let values = [
        0.0,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MAX,
        f64::MIN,
    ];
    let mut points = [[0.0; 2]; BLOCK];
    for (point, place) in points.iter_mut().zip(0..36) {
        *point = [values[place % 6], values[place / 6]];
    }
    for bits in [
        polygon.not_inside(&points),
        octagon.not_inside(&points),
        ellipse.not_inside(&points),
    ] {
        assert_eq!(bits, (1 << 36) - 2);
    }
}

/// The proof ends at magnitudes near the ends of the range; no polygon is made there.
#[test]
fn magnitudes_out_of_range_make_no_polygon() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    for (exponent, is_some) in [(-901, false), (-900, true), (1000, true), (1001, false)] {
        let scaled = square.map(|corner: Point2| corner.map(|x| x * 2.0_f64.powi(exponent)));
        assert_eq!(
            Polygon::of(&Corners::distinct(scaled)).is_some(),
            is_some,
            "{exponent}"
        );
    }
    for bad in [f64::NAN, f64::INFINITY, f64::MAX] {
        let corners = Corners::distinct([[0.0, 0.0], [1.0, 0.0], [bad, 1.0], [0.0, 1.0]]);
        assert!(Polygon::of(&corners).is_none());
    }
}

/// Thinned in parts of any length, the same points are left as in one pass.
#[test]
fn parts_keep_what_one_pass_keeps() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let [outer, inner] = [1.0, 0.5].map(|scale| {
        let corners = square.map(|corner: Point2| corner.map(|x| scale * x));
        Polygon::of(&Corners::distinct(corners)).expect("a square")
    });
    let mut rng = ChaCha8Rng::seed_from_u64(2026);
    let points: Vec<Point2> = (0..1_000)
        .map(|_| [0, 1].map(|_| rng.random_range(-1.5..1.5)))
        .collect();
    let kept = |thin: &dyn Fn(&mut Kept)| {
        let mut kept = Kept::default();
        kept.fill(&points, 0, &inner);
        thin(&mut kept);
        (kept.points().to_vec(), kept.ids().to_vec())
    };
    let expected = kept(&|kept| kept.thin(&outer));
    assert!((100..900).contains(&expected.1.len()));
    for part in [1, BLOCK, 100, 5_000] {
        let found = kept(&|kept| kept.thin_in_parts(&outer, part));
        assert_eq!(found, expected, "{part}");
    }
}
