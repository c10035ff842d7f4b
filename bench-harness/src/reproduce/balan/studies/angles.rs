//! Which point a merge would go to by the paper's angles (B-2).
//!
//! Section 3.1.2.2 of the paper takes the angle between two facets from the arc cosine of their normals, which is
//! between 0 and 180 degrees, and has a rule to make it one between 0 and 360: "If the sign is negative, we know the
//! convex angle is calculated in anticlockwise direction. So, we subtract the θ from 360". The sign is that of the
//! cosine. The candidate with the largest angle is the next point.
//!
//! ```text
//!            t                  the last facet is l u t; candidates are the neighbours of u in its hull and
//!           / \                 those of l in the other; all lie on one side of the last facet, so the angle
//!          /   \                at the edge l u, from t, is between 0 and 180 degrees, and the next
//!        u ----- l              point is the one where it is largest
//!          \   /
//!           \ /                 θ ≤ 90: the rule leaves it;  θ > 90: it makes 360 - θ of it, and so turns the
//!          next                 order of these candidates round
//! ```
//!
//! The steps here are those of a right merge: the hulls of the two halves and of all points are certified, every
//! facet between the halves is one step, and each rule is asked for the next point there. Whether a program that
//! follows a rule gets to its end is another question: one wrong choice leads it off the hull.

use crate::reproduce::balan::definition::Studies;
use crate::reproduce::balan::records::{AngleRow, Records};
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::{FailureRow, SetRow};
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::certify;
use anyhow::Result;
use geometry_core::{Exact, Hull3, Kernel3, Point3};
use std::collections::{BTreeMap, BTreeSet};

/// The name of this study in the records.
pub(crate) const STAGE: &str = "angles";

/// Repeats the top merge of every set of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let progress = Progress::start(STAGE, studies.angles.len());
    for block in &studies.angles {
        let sets = block.sets();
        let merged = parallel::map(&sets, |(distribution, n, replicate)| {
            let set = PointSet3::generate(studies.seed, distribution, *n, *replicate)?;
            merge(&set)
        })?;
        for (row, sets, failures) in merged {
            records.own.angles.extend(row);
            records.sets.extend(sets);
            records.failures.extend(failures);
        }
        progress.finished(&format!("{:?} {:?}", block.distributions, block.n));
    }
    Ok(())
}

/// The merge of the two halves of `set` by y, if all three hulls are certified.
fn merge(set: &PointSet3) -> Result<(Option<AngleRow>, Vec<SetRow>, Vec<FailureRow>)> {
    let mut points = set.points.clone();
    points.sort_unstable_by(|p, q| p[1].total_cmp(&q[1]));
    let middle = points.len() / 2;
    let parts = [&points[..], &points[..middle], &points[middle..]];
    let names = ["all", "lower half", "upper half"];
    let mut hulls = Vec::new();
    let (mut sets, mut failures) = (Vec::new(), Vec::new());
    for (part, name) in parts.into_iter().zip(names) {
        let name = format!("{}, {name} by y", set.distribution);
        let part = set.clone().changed(&name, |points| *points = part.to_vec());
        let certified = certify(STAGE, &part, &["quickhull-3d".to_owned()])?;
        sets.push(certified.set);
        failures.extend(certified.failures);
        hulls.extend(certified.hull);
    }
    let row = match &hulls[..] {
        [all, lower, upper] => Some(AngleRow {
            distribution: set.distribution.clone(),
            n: set.n,
            replicate: set.replicate,
            ..choices(&points, middle as u32, all, [lower, upper])
        }),
        _ => None,
    };
    Ok((row, sets, failures))
}

/// For each vertex, those it shares an edge with.
type Neighbours = BTreeMap<u32, BTreeSet<u32>>;

/// The edges of a hull whose points are numbered from `first` on.
fn neighbours(hull: &Hull3, first: u32) -> Neighbours {
    let mut neighbours = Neighbours::new();
    for [a, b, c] in hull.triangles() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            neighbours
                .entry(first + from)
                .or_default()
                .insert(first + to);
        }
    }
    neighbours
}

/// Asks every rule at every step of the merge of the points before `middle` with the others.
fn choices(points: &[Point3], middle: u32, all: &Hull3, halves: [&Hull3; 2]) -> AngleRow {
    let around = [neighbours(halves[0], 0), neighbours(halves[1], middle)];
    let mut apexes: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for [a, b, c] in all.triangles() {
        apexes.extend([((a, b), c), ((b, c), a), ((c, a), b)]);
    }
    let mut row = AngleRow::default();
    for (&(u, l), &t) in &apexes {
        // Each edge between the halves once, always from the first half to the second, so that the merge goes round.
        let (true, Some(&next)) = (u < middle && l >= middle, apexes.get(&(l, u))) else {
            continue;
        };
        let candidates = [(0, u), (1, l)]
            .into_iter()
            .filter_map(|(half, end): (usize, u32)| around[half].get(&end))
            .flatten()
            .copied()
            .filter(|&id| id != t);
        let candidates: Vec<u32> = candidates.collect();
        let step = Step {
            points,
            u,
            l,
            t,
            candidates: &candidates,
        };
        step.ask(next, &mut row);
    }
    row
}

/// One step of a merge.
struct Step<'a> {
    points: &'a [Point3],
    /// The ends of the last edge between the halves.
    u: u32,
    l: u32,
    /// The third corner of the last facet.
    t: u32,
    candidates: &'a [u32],
}

impl Step<'_> {
    /// Adds to `row` which rules choose `next`.
    fn ask(&self, next: u32, row: &mut AngleRow) {
        let cosines: Vec<f64> = self.candidates.iter().map(|&id| self.cosine(id)).collect();
        let obtuse = cosines.iter().filter(|cosine| **cosine < 0.0).count();
        row.steps += 1;
        row.candidates += cosines.len() as u64;
        // All candidates are on the same side of the last facet, so none is in anticlockwise direction.
        row.directions_right += (cosines.len() - obtuse) as u64;
        row.ambiguous += u64::from(obtuse >= 2);
        let right = |angle: &dyn Fn(usize) -> f64| {
            let best = (0..cosines.len()).max_by(|&i, &j| angle(i).total_cmp(&angle(j)));
            u64::from(best.is_some_and(|best| self.candidates[best] == next))
        };
        row.printed += right(&|i| by_sign(cosines[i], cosines[i]));
        row.printed_outward += right(&|i| by_sign(-cosines[i], -cosines[i]));
        row.unsigned += right(&|i| degrees(cosines[i]));
        row.triple += right(&|i| by_sign(self.triple_product(self.candidates[i]), cosines[i]));
        row.exact += u64::from(self.furthest() == Some(next));
    }

    fn at(&self, id: u32) -> Point3 {
        self.points[id as usize]
    }

    /// The normals of the last facet and of that of `id`, from corners in the same order: u, l, third.
    fn normals(&self, id: u32) -> [Point3; 2] {
        let edge = minus(self.at(self.l), self.at(self.u));
        [self.t, id].map(|third| cross(edge, minus(self.at(third), self.at(self.u))))
    }

    fn cosine(&self, id: u32) -> f64 {
        let [last, candidate] = self.normals(id);
        dot(last, candidate) / (dot(last, last).sqrt() * dot(candidate, candidate).sqrt())
    }

    /// Positive where the facet of `id` is on the side of the last one on which the hull is.
    fn triple_product(&self, id: u32) -> f64 {
        let [last, candidate] = self.normals(id);
        -dot(
            cross(last, candidate),
            minus(self.at(self.l), self.at(self.u)),
        )
    }

    /// The candidate beyond the planes of all others, exactly.
    fn furthest(&self) -> Option<u32> {
        let (u, l) = (self.at(self.u), self.at(self.l));
        let beyond = |x: u32, y: u32| Exact.orient3(l, u, self.at(x), self.at(y)).is_positive();
        self.candidates
            .iter()
            .copied()
            .reduce(|best, id| if beyond(best, id) { id } else { best })
    }
}

/// The paper's formula for the angle between two normals.
fn degrees(cosine: f64) -> f64 {
    cosine.acos() * 180.0 / std::f64::consts::PI
}

/// The angle of `cosine`, taken from 360 degrees if `sign` is negative.
fn by_sign(sign: f64, cosine: f64) -> f64 {
    if sign < 0.0 {
        360.0 - degrees(cosine)
    } else {
        degrees(cosine)
    }
}

fn minus(p: Point3, q: Point3) -> Point3 {
    std::array::from_fn(|i| p[i] - q[i])
}

fn cross(p: Point3, q: Point3) -> Point3 {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        p[j] * q[k] - p[k] * q[j]
    })
}

fn dot(p: Point3, q: Point3) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_turns_the_order_of_obtuse_angles_round() {
        let cosine = |angle: f64| angle.to_radians().cos();
        let rule = |angle: f64| by_sign(cosine(angle), cosine(angle));
        assert!((rule(30.0) - 30.0).abs() < 1e-9 && (rule(150.0) - 210.0).abs() < 1e-9);
        assert!(rule(100.0) > rule(150.0) && rule(100.0) > rule(89.0));
    }

    /// On the edge u l along the x-axis, the last facet in the plane z = 0, the hull below it.
    #[test]
    fn signs_and_angles_of_known_facets() {
        let turned = |angle: f64| {
            let angle = angle.to_radians();
            [0.5, angle.cos(), -angle.sin()]
        };
        let points = [
            [0.0; 3],
            [1.0, 0.0, 0.0],
            turned(0.0),
            turned(40.0),
            turned(110.0),
            turned(150.0),
        ];
        let step = Step {
            points: &points,
            u: 0,
            l: 1,
            t: 2,
            candidates: &[3, 4, 5],
        };
        for (id, angle) in [(3, 40.0), (4, 110.0), (5, 150.0)] {
            assert!((degrees(step.cosine(id)) - angle).abs() < 1e-9);
            assert!(step.triple_product(id) > 0.0);
        }
        let mut row = AngleRow::default();
        step.ask(5, &mut row);
        assert_eq!(
            (row.candidates, row.directions_right, row.ambiguous),
            (3, 1, 1)
        );
        assert_eq!((row.printed, row.printed_outward), (0, 0));
        assert_eq!((row.unsigned, row.triple, row.exact), (1, 1, 1));
    }

    #[test]
    fn exact_choices_follow_the_merge() {
        for (distribution, n) in [("ball", 60), ("sphere", 80), ("normal3", 60)] {
            let set = PointSet3::generate(3, distribution, n, 0).expect("a set");
            let (row, sets, failures) = merge(&set).expect("hulls");
            let row = row.expect("certified");
            assert_eq!((sets.len(), failures.len()), (3, 0));
            assert!(row.steps >= 3);
            assert_eq!(row.exact, row.steps, "{distribution}");
        }
    }
}
