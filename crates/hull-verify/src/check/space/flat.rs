//! Hulls of dimension less than three.

use super::Tally;
use super::finding3::{Finding3, verdict};
use crate::arithmetic::scale::{Scale, Side, order3, shadow};
use crate::arithmetic::{Turn, order};
use crate::check::{self, Finding};
use geometry_core::{Axis, Boundary, Hull2, Point2, Point3};

type Verdict = Result<Tally, Vec<Finding3>>;

pub(super) fn empty(points: &[Point3]) -> Verdict {
    if points.is_empty() {
        Ok(Tally::default())
    } else {
        Err(vec![Finding3::WrongDimension {
            claimed: None,
            witness: 0,
        }])
    }
}

pub(super) fn point(points: &[Point3], id: u32) -> Verdict {
    let place = at(points, id)?;
    let mut tally = Tally::default();
    let mut findings = Vec::new();
    for (other, &p) in (0..).zip(points) {
        if order3(p, place).is_eq() {
            findings.extend(tally.copy(id, other));
        } else {
            findings.push(Finding3::WrongDimension {
                claimed: Some(0),
                witness: other,
            });
        }
    }
    verdict(findings).map(|()| tally)
}

pub(super) fn segment(points: &[Point3], scale: Scale, ends: [u32; 2]) -> Verdict {
    let [first, second] = ends;
    let [a, b] = [at(points, first)?, at(points, second)?];
    if order3(a, b).is_eq() {
        return Err(vec![Finding3::EqualVertices { first, second }]);
    }
    if order3(a, b).is_gt() {
        return Err(vec![Finding3::WrongStart { first, second }]);
    }
    let mut tally = Tally::default();
    let mut findings = Vec::new();
    for (point, &p) in (0..).zip(points) {
        let (from_a, from_b) = (order3(a, p), order3(p, b));
        if !scale.collinear(a, b, p) {
            findings.push(Finding3::WrongDimension {
                claimed: Some(1),
                witness: point,
            });
        } else if from_a.is_eq() {
            findings.extend(tally.copy(first, point));
        } else if from_b.is_eq() {
            findings.extend(tally.copy(second, point));
        } else if from_a.is_gt() {
            findings.push(Finding3::BeyondEnd { point, end: first });
        } else if from_b.is_gt() {
            findings.push(Finding3::BeyondEnd { point, end: second });
        } else {
            tally.inside += 1;
        }
    }
    verdict(findings).map(|()| tally)
}

pub(super) fn planar(points: &[Point3], scale: Scale, ids: &[u32]) -> Verdict {
    let mut corners = Vec::with_capacity(ids.len());
    for &id in ids {
        corners.push(at(points, id)?);
    }
    let [a, b, c, ..] = corners[..] else {
        return Err(vec![Finding3::FlatPolygon]);
    };
    let turns = Axis::ALL.map(|axis| (axis, scale.turn(axis, a, b, c)));
    let Some((axis, turn)) = turns.into_iter().find(|&(_, turn)| turn != Turn::Straight) else {
        return Err(vec![Finding3::FlatPolygon]);
    };
    let off_plane = |&(_, &p): &(u32, &Point3)| scale.side(a, b, c, p) != Side::On;
    let witnesses = (0..).zip(points).filter(off_plane);
    let off = witnesses.map(|(witness, _)| Finding3::WrongDimension {
        claimed: Some(2),
        witness,
    });
    verdict(off.collect())?;
    // In the plane, the shadow of a point tells which point it is, and no orientation is lost.
    let shadows: Vec<Point2> = points.iter().map(|&p| shadow(axis, p)).collect();
    let in_shadow = |findings: Vec<Finding>| -> Vec<Finding3> {
        let finding = |finding| Finding3::InShadow { axis, finding };
        findings.into_iter().map(finding).collect()
    };
    let polygon = as_polygon(&shadows, ids, turn);
    let certificate = check::hull2(&shadows, Boundary::Extreme, &polygon).map_err(in_shadow)?;
    verdict(wrong_start(points, ids))?;
    Ok(Tally {
        copies: certificate.copies,
        on_boundary: certificate.on_edges,
        inside: certificate.inside,
    })
}

/// The polygon of the shadows, as it is listed in the plane.
fn as_polygon(shadows: &[Point2], ids: &[u32], turn: Turn) -> Hull2 {
    let mut cycle = ids.to_vec();
    if turn == Turn::Right {
        cycle.reverse();
    }
    let at = |i: usize| shadows[cycle[i] as usize];
    let first = (0..cycle.len()).min_by(|&i, &j| order(at(i), at(j)));
    cycle.rotate_left(first.unwrap_or(0));
    Hull2::Polygon(cycle)
}

/// What is wrong with the start of a polygon of three corners or more, or with its direction.
fn wrong_start(points: &[Point3], ids: &[u32]) -> Vec<Finding3> {
    let at = |id: u32| points[id as usize];
    let [first, second] = [ids[0], ids[1]];
    let last = ids[ids.len() - 1];
    let starts_well = ids.iter().all(|&id| order3(at(first), at(id)).is_le())
        && order3(at(second), at(last)).is_lt();
    if starts_well {
        Vec::new()
    } else {
        vec![Finding3::WrongStart { first, second }]
    }
}

fn at(points: &[Point3], id: u32) -> Result<Point3, Vec<Finding3>> {
    points.get(id as usize).copied().ok_or_else(|| {
        let count = points.len();
        vec![Finding3::NoSuchPoint { id, count }]
    })
}
