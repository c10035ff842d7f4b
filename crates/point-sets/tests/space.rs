//! What each set of space promises about its geometry.

mod common;

use common::{Point3, corners_of_facets, extreme3, facets, points3};
use geometry_core::dimension::AffineBasis;
use geometry_core::{Exact, Kernel3, Points, Sign};
use point_sets::{Spec, catalogue};
use std::collections::BTreeSet;

fn distinct(points: &[Point3]) -> usize {
    let bits: BTreeSet<_> = points.iter().map(|point| point.map(f64::to_bits)).collect();
    bits.len()
}

fn spans(points: &[Point3]) -> AffineBasis {
    AffineBasis::of(Points::new(points).unwrap(), &Exact)
}

fn length([x, y, z]: Point3) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

#[test]
fn every_set_has_any_small_size_and_finite_coordinates() {
    for entry in catalogue().iter().filter(|entry| entry.dimensions() == [3]) {
        for n in (0..40).chain([97]) {
            let points = points3(entry.name, n, 1);
            assert_eq!(points.len(), n, "{}", entry.name);
            assert!(
                points.as_flattened().iter().all(|c| c.is_finite()),
                "{}",
                entry.name
            );
        }
        let points = points3(entry.name, 60, 1);
        assert!(
            matches!(spans(&points), AffineBasis::Space(_)),
            "{} spans space",
            entry.name
        );
        assert_eq!(distinct(&points), 60, "{}", entry.name);
    }
}

#[test]
fn a_longer_random_set_begins_with_the_shorter() {
    for spec in [
        "ball",
        "cube",
        "normal3",
        "cauchy3",
        "sphere",
        "cube-faces",
        "near-coplanar",
        "paraboloid",
    ] {
        assert_eq!(
            points3(spec, 1000, 3)[..300],
            points3(spec, 300, 3),
            "{spec}"
        );
        assert_ne!(points3(spec, 100, 1), points3(spec, 100, 2), "{spec}");
    }
}

#[test]
fn a_set_is_of_one_dimension() {
    let error = |text: &str, space: bool| {
        let spec: Spec = text.parse().unwrap();
        let made = if space {
            spec.generate3(5, 0).map(|_| ())
        } else {
            spec.generate(5, 0).map(|_| ())
        };
        made.unwrap_err().to_string()
    };
    let text = error("ball", false);
    assert!(
        text.starts_with(
            "ball is a set of space and a set of the plane is needed; take one of disc, "
        ),
        "{text}"
    );
    let text = error("shuffled:of=disc", true);
    assert!(
        text.starts_with(
            "disc is a set of the plane and a set of space is needed; take one of ball, "
        ),
        "{text}"
    );
    let text = error("minkowski:of=ball,with=disc", true);
    assert!(text.starts_with("disc is a set of the plane"), "{text}");
    let text = error("paraboloid:of=ball", true);
    assert!(text.starts_with("ball is a set of space"), "{text}");
    for (text, dimension) in [
        ("disc", 2),
        ("ball", 3),
        ("duplicated:of=(shuffled:of=cube)", 3),
        ("minkowski:of=disc,with=square", 2),
    ] {
        assert_eq!(
            text.parse::<Spec>().unwrap().dimension(),
            dimension,
            "{text}"
        );
    }
}

#[test]
fn sizes_follow_from_the_parameters() {
    for (text, size) in [
        ("cubic-lattice:cols=2,rows=3,layers=4", Some(24)),
        ("cubic-lattice:cols=2,rows=3", None),
        (
            "minkowski:of=(cubic-lattice:cols=2,rows=3,layers=4),with=cube,parts=5",
            Some(120),
        ),
        (
            "duplicated:of=(cubic-lattice:cols=2,rows=3,layers=4),copies=3",
            Some(72),
        ),
        ("ball", None),
    ] {
        assert_eq!(text.parse::<Spec>().unwrap().size(), size, "{text}");
    }
    let spec: Spec = "cubic-lattice:cols=2,rows=3,layers=4".parse().unwrap();
    let error = spec.generate3(25, 0).unwrap_err().to_string();
    assert!(
        error.starts_with("cubic-lattice: 4 layers of 3 rows of 2 are 24 points and 25 are asked"),
        "{error}"
    );
}

#[test]
fn lattices_have_the_corners_and_faces_of_a_cube() {
    for spec in ["cubic-lattice", "cube-faces:spacing=lattice"] {
        let n = if spec == "cubic-lattice" { 64 } else { 56 };
        let points = points3(spec, n, 0);
        let corners = extreme3(&points);
        assert_eq!(corners.len(), 8, "{spec}");
        assert!(
            corners.iter().flatten().all(|c| *c == 0.0 || *c == 3.0),
            "{spec}"
        );
        assert_eq!(facets(&points).len(), 6, "{spec}");
    }
    for point in points3("cube-faces", 500, 4) {
        assert!(point.iter().any(|c| *c == 0.0 || *c == 1.0));
        assert!(point.iter().all(|c| (0.0..=1.0).contains(c)));
    }
}

#[test]
fn the_convex_surfaces_have_only_extreme_points() {
    for spec in [
        "sphere",
        "paraboloid",
        "moment-curve",
        "moment-curve:spacing=random",
        "antiprism",
        "antiprism:levels=4",
    ] {
        assert_eq!(extreme3(&points3(spec, 48, 2)).len(), 48, "{spec}");
    }
    assert!(
        points3("sphere", 1000, 2)
            .into_iter()
            .all(|p| (length(p) - 1.0).abs() < 1e-15)
    );
}

#[test]
fn the_lift_of_a_lattice_has_square_facets() {
    let points = points3("paraboloid:of=lattice", 16, 0);
    let sizes: Vec<usize> = facets(&points).iter().map(BTreeSet::len).collect();
    assert_eq!(
        sizes.iter().filter(|&&size| size == 4).count(),
        9 + 4 + 1,
        "{sizes:?}"
    );
}

#[test]
fn prisms_have_exact_walls() {
    for (spec, n, corners) in [("prism", 24, 24), ("prism:levels=4", 24, 12)] {
        let points = points3(spec, n, 0);
        assert_eq!(extreme3(&points).len(), corners, "{spec}");
        assert_eq!(facets(&points).len(), corners / 2 + 2, "{spec}");
    }
}

#[test]
fn near_coplanar_points_are_coplanar_but_for_the_last_bits() {
    let flat = points3("near-coplanar:ulps=0", 500, 6);
    assert!(matches!(spans(&flat), AffineBasis::Plane(_)));
    for ([x, y, z], moved) in flat.iter().zip(points3("near-coplanar:ulps=0", 500, 6)) {
        assert_eq!((*z, [*x, *y, *z]), (x + y, moved));
    }
    assert!(matches!(
        spans(&points3("near-coplanar", 50, 6)),
        AffineBasis::Space(_)
    ));
    assert!(
        points3("near-coplanar", 500, 6)
            .iter()
            .all(|[x, y, z]| (z - x - y).abs() < 1e-14)
    );
}

#[test]
fn each_point_of_the_axis_sees_all_that_came_before() {
    let points = points3("circle-and-axis", 40, 0);
    assert!(
        points[..20]
            .iter()
            .all(|p| p[2] == 0.0 && (length(*p) - 1.0).abs() < 1e-15)
    );
    for end in 21..=40 {
        let extreme = extreme3(&points[..end]);
        assert_eq!(extreme.len(), 21);
        assert!(extreme.contains(&points[end - 1]));
    }
}

/// Facets as triangles, as a wrap makes them: the sum of corners - 2.
fn triangles(points: &[Point3]) -> usize {
    facets(points).iter().map(|facet| facet.len() - 2).sum()
}

#[test]
fn the_fan_is_as_defined() {
    for (m, axis, name) in [
        (3, 1, "fan"),
        (8, 1, "fan"),
        (5, 0, "fan:axis=x"),
        (5, 2, "fan:axis=z"),
    ] {
        let points = points3(name, 4 * m + 2, 0);
        let (lower, upper) = points.split_at(2 * m + 1);
        let height = |p: &Point3| p[axis];
        assert!(lower.iter().all(|p| height(p) <= 1.0) && upper.iter().all(|p| height(p) >= 2.0));
        assert_eq!(upper.iter().filter(|p| height(p) > 2.0).count(), m + 1);
        assert_eq!(points[0], [0.0; 3]);
        // The lower hull is a cone: its tip is on all of the N = 2m sides.
        let tip = points[0];
        assert_eq!(
            corners_of_facets(lower)
                .iter()
                .filter(|facet| facet.contains(&tip.map(f64::to_bits)))
                .count(),
            2 * m
        );
        // Of the whole, m of the sides are left, and m times two new facets join them at the tip.
        let around = corners_of_facets(&points);
        let at_tip = around
            .iter()
            .filter(|facet| facet.contains(&tip.map(f64::to_bits)))
            .count();
        assert_eq!(
            at_tip,
            3 * m,
            "m sides and two facets over each that is gone"
        );
        // Extreme: tip, ring, the m above, and the tip of the pyramid.
        assert_eq!(extreme3(&points).len(), 1 + 2 * m + m + 1);
        assert_eq!(triangles(&points), 2 * (3 * m + 2) - 4);
    }
}

#[test]
fn of_the_cone_only_the_tip_is_left_of_the_lower_half() {
    for m in [3, 8] {
        let points = points3("cone", 4 * m + 2, 7);
        let (lower, upper) = points.split_at(2 * m + 1);
        assert!(lower.iter().all(|p| p[1] <= 1.0) && upper.iter().all(|p| p[1] >= 1.8));
        assert_eq!(extreme3(lower).len(), 2 * m + 1);
        let extreme = extreme3(&points);
        assert_eq!(extreme.len(), 2 * m + 2);
        assert!(extreme.contains(&[0.0; 3]) && upper.iter().all(|p| extreme.contains(p)));
    }
}

#[test]
fn minkowski_sums_are_sums() {
    let sums = points3(
        "minkowski:of=cube,with=(cubic-lattice:cols=2,rows=2,layers=2)",
        40,
        3,
    );
    let cube = points3("cube", 5, 3);
    assert_eq!(sums[0], cube[0]);
    for (index, sum) in sums.iter().enumerate() {
        let corner = index % 8;
        let shift = [corner % 2, corner / 2 % 2, corner / 4].map(|c| c as f64);
        let expected: Point3 = std::array::from_fn(|axis| cube[index / 8][axis] + shift[axis]);
        assert_eq!(*sum, expected);
    }
}

#[test]
fn flattened_points_lie_in_the_disc_and_move_with_the_offset() {
    let spec: Spec = "flattened-sphere".parse().unwrap();
    let far: Spec = "flattened-sphere:offset=1048576".parse().unwrap();
    let (near, far) = (
        spec.generate(500, 1).unwrap(),
        far.generate(500, 1).unwrap(),
    );
    let rim = near.iter().filter(|[x, y]| x * x + y * y > 0.75).count();
    // P(r > sqrt(3)/2) = 1/2, with a standard deviation of 11.
    assert!((213..288).contains(&rim), "{rim}");
    for (a, b) in near.as_flattened().iter().zip(far.as_flattened()) {
        assert_eq!(a + 1048576.0, *b);
    }
    let error = "flattened-sphere:offset=1e308"
        .parse::<Spec>()
        .unwrap()
        .generate(1, 0)
        .unwrap_err();
    assert!(error.to_string().contains("leaves no room"), "{error}");
}

#[test]
fn signs_of_the_fan_need_no_luck() {
    // The points above lie strictly beyond one side and strictly beneath its neighbours.
    let (m, points) = (64, points3("fan", 258, 0));
    for j in 0..m {
        let above = points[1 + 2 * m + j];
        for side in 0..2 * m {
            let (a, b) = (points[1 + side], points[1 + (side + 1) % (2 * m)]);
            let beyond = Exact.orient3(points[0], a, b, above)
                == Exact.orient3(points[0], a, b, [0.0, 1.0, 0.0]);
            assert_eq!(!beyond, side == 2 * j, "{j} {side}");
        }
        assert_ne!(
            Exact.orient3(points[0], points[1], points[2], above),
            Sign::Zero
        );
    }
}
