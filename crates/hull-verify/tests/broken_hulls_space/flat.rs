//! Broken hulls of dimension two and less, and hulls of the wrong dimension.

use super::{cube, findings, hulls};
use geometry_core::{Axis, Hull3, Point3};
use hull_verify::check::{self, Finding, Finding3};

const ROW: [Point3; 4] = [[1.0; 3], [0.0; 3], [3.0; 3], [2.0; 3]];

/// A unit square in the plane z = x + y, with its centre.
const SQUARE: [Point3; 5] = [
    [0.5, 0.5, 1.0],
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 2.0],
    [0.0, 1.0, 1.0],
];

#[test]
fn right_flat_hulls() {
    assert!(check::hull3(&[], &Hull3::Empty).is_ok());
    assert!(check::hull3(&ROW[..1], &Hull3::Point(0)).is_ok());
    let certificate = check::hull3(&ROW, &Hull3::Segment([1, 2])).expect("right");
    assert_eq!(
        (certificate.h, certificate.inside, certificate.dimension),
        (2, 2, Some(1))
    );
    // From the smallest corner (0, 0, 0) towards (0, 1, 1).
    let certificate = check::hull3(&SQUARE, &Hull3::Planar(vec![1, 4, 3, 2])).expect("right");
    assert_eq!(
        (certificate.h, certificate.inside, certificate.facets),
        (4, 1, 0)
    );
}

#[test]
fn every_dimension_but_the_right_one_is_rejected() {
    for (name, points, hull) in hulls() {
        let ids = hull.vertices();
        let mut claims = vec![Hull3::Empty];
        claims.extend(ids.first().map(|&id| Hull3::Point(id)));
        if let [first, .., last] = *ids {
            claims.extend([Hull3::Segment([first, last]), Hull3::Segment([last, first])]);
        }
        if ids.len() >= 3 {
            claims.push(Hull3::Planar(ids.to_vec()));
        }
        for claim in claims {
            assert_eq!(
                check::hull3(&points, &claim).is_ok(),
                claim == hull,
                "{name}: {claim:?}"
            );
        }
    }
}

#[test]
fn wrong_points() {
    let off = |claimed, witness| Finding3::WrongDimension { claimed, witness };
    assert_eq!(findings(&ROW, &Hull3::Empty), [off(None, 0)]);
    let found = findings(&ROW, &Hull3::Point(1));
    assert_eq!(found, [0, 2, 3].map(|witness| off(Some(0), witness)));
    let copies = [[1.0, 0.0, 2.0], [1.0, -0.0, 2.0]];
    assert!(check::hull3(&copies, &Hull3::Point(0)).is_ok());
    let larger = Finding3::LargerCopy {
        vertex: 1,
        smaller: 0,
    };
    assert_eq!(findings(&copies, &Hull3::Point(1)), [larger]);
    let stranger = |id, count| Finding3::NoSuchPoint { id, count };
    assert_eq!(findings(&copies, &Hull3::Point(2)), [stranger(2, 2)]);
    assert_eq!(findings(&copies, &Hull3::Segment([0, 7])), [stranger(7, 2)]);
    assert_eq!(
        findings(&copies, &Hull3::Planar(vec![0, 1, 9])),
        [stranger(9, 2)]
    );
}

#[test]
fn wrong_segments() {
    let wrong_start = Finding3::WrongStart {
        first: 2,
        second: 1,
    };
    assert_eq!(findings(&ROW, &Hull3::Segment([2, 1])), [wrong_start]);
    let beyond = |point, end| Finding3::BeyondEnd { point, end };
    assert_eq!(
        findings(&ROW, &Hull3::Segment([0, 3])),
        [beyond(1, 0), beyond(2, 3)]
    );
    let mut bent = ROW.to_vec();
    bent[3][2] = 2.0_f64.next_up();
    let off = Finding3::WrongDimension {
        claimed: Some(1),
        witness: 3,
    };
    assert_eq!(findings(&bent, &Hull3::Segment([1, 2])), [off]);
    let mut copied = ROW.to_vec();
    copied.push([0.0; 3]);
    let larger = Finding3::LargerCopy {
        vertex: 4,
        smaller: 1,
    };
    assert_eq!(findings(&copied, &Hull3::Segment([4, 2])), [larger]);
    let equal = Finding3::EqualVertices {
        first: 1,
        second: 4,
    };
    assert_eq!(findings(&copied, &Hull3::Segment([1, 4])), [equal]);
}

#[test]
fn wrong_polygons() {
    let planar = |ids: &[u32]| Hull3::Planar(ids.to_vec());
    let wrong_start = |first, second| Finding3::WrongStart { first, second };
    assert_eq!(
        findings(&SQUARE, &planar(&[1, 2, 3, 4])),
        [wrong_start(1, 2)]
    );
    assert_eq!(
        findings(&SQUARE, &planar(&[4, 3, 2, 1])),
        [wrong_start(4, 3)]
    );
    assert_eq!(findings(&SQUARE, &planar(&[1, 4])), [Finding3::FlatPolygon]);
    assert_eq!(
        findings(&SQUARE, &planar(&[1, 0, 3])),
        [Finding3::FlatPolygon]
    );
    let in_shadow = |finding| Finding3::InShadow {
        axis: Axis::X,
        finding,
    };
    let outside = Finding::Outside {
        point: 2,
        from: 1,
        to: 3,
    };
    let found = findings(&SQUARE, &planar(&[1, 4, 3]));
    assert!(
        found == [in_shadow(outside)]
            || found
                == [in_shadow(Finding::Outside {
                    point: 2,
                    from: 3,
                    to: 1
                })],
        "{found:?}"
    );
    let mut lifted = SQUARE.to_vec();
    lifted[0][2] = 1.0_f64.next_up();
    let off = Finding3::WrongDimension {
        claimed: Some(2),
        witness: 0,
    };
    assert_eq!(findings(&lifted, &planar(&[1, 4, 3, 2])), [off]);
    let found = findings(&cube(), &planar(&[0, 1, 3, 2]));
    assert_eq!(found.len(), 4);
}
