//! The innermost loop of the paper, with a candidate's own corners tested or skipped by their indices (N-6).
//!
//! The candidates of a certified wrap are tried again, in the paper's arithmetic: the unit normal once a candidate, a
//! distance and a comparison with ε a point, until a point lies outside. Nothing but the test for the own corners
//! differs between the two ways.

use crate::reproduce::nathan::definition::Corners;
use crate::reproduce::nathan::records::Records;
use crate::reproduce::nathan::sets;
use crate::reproduce::rows::SetRow;
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::surface::is_hull;
use anyhow::Result;
use geometry_core::{Exact, HullError, Observer, Perturbed, Point3, Points, Silent, Step};
use gift_wrap::nathan::{NathanOptions, NathanRun, OwnCorners, PrintedArithmetic, study};

/// Of so many sets in a row at least one must come out right, or the cell is given up.
const PATIENCE: u64 = 20;

/// The two ways.
pub(crate) const BOTH: [OwnCorners; 2] = [OwnCorners::Tested, OwnCorners::Skipped];

/// A set, and the candidates that wrapping it tries.
#[derive(Clone, Debug)]
pub(crate) struct Trial {
    pub(crate) points: Vec<Point3>,
    candidates: Vec<[u32; 3]>,
    epsilon: f64,
}

impl Trial {
    /// How many of the candidates have no point outside.
    pub(crate) fn accepted(&self, own_corners: OwnCorners) -> usize {
        match own_corners {
            OwnCorners::Tested => self.count::<false>(),
            OwnCorners::Skipped => self.count::<true>(),
        }
    }

    fn count<const SKIPS: bool>(&self) -> usize {
        let accepted = |corners: &&[u32; 3]| self.leaves_all_inside::<SKIPS>(corners);
        self.candidates.iter().filter(accepted).count()
    }

    fn leaves_all_inside<const SKIPS: bool>(&self, corners: &[u32; 3]) -> bool {
        let [a, b, c] = corners.map(|id| self.points[id as usize]);
        let normal = unit_normal(a, b, c);
        (0..).zip(&self.points).all(|(id, point)| {
            (SKIPS && corners.contains(&id)) || dot(normal, minus(*point, a)) <= self.epsilon
        })
    }

    /// The whole wrap with exact answers in place of the epsilon.
    pub(crate) fn wrap_exactly(&self, own_corners: OwnCorners) -> Result<NathanRun, HullError> {
        let points = Points::new(&self.points)?;
        let options = NathanOptions {
            own_corners,
            ..NathanOptions::PRINTED
        };
        Ok(study(points, options, &Perturbed(Exact), &mut Silent))
    }
}

fn minus(p: Point3, q: Point3) -> Point3 {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn dot(p: Point3, q: Point3) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

fn unit_normal(a: Point3, b: Point3, c: Point3) -> Point3 {
    let (e, f) = (minus(b, a), minus(c, b));
    let normal = [
        e[1] * f[2] - e[2] * f[1],
        e[2] * f[0] - e[0] * f[2],
        e[0] * f[1] - e[1] * f[0],
    ];
    let length = dot(normal, normal).sqrt();
    normal.map(|x| x / length)
}

/// Collects the candidates of a wrap.
#[derive(Default)]
struct Candidates {
    edge: [u32; 2],
    found: Vec<[u32; 3]>,
}

impl Observer for Candidates {
    const ACTIVE: bool = true;

    fn record(&mut self, step: Step) {
        match step {
            Step::Line(u, v) => self.edge = [u, v],
            Step::Candidate(w) => self.found.push([self.edge[0], self.edge[1], w]),
            _ => {}
        }
    }
}

/// Batches of sets of a cell on which both ways accept exactly the triangles of the certified hull: a way that loses a
/// facet to its epsilon would be timed for other work.
pub(crate) fn batches(
    seed: u64,
    distribution: &str,
    n: usize,
    block: &Corners,
    records: &mut Records,
) -> Result<Vec<Vec<Trial>>> {
    let batch = block.points_a_batch.div_ceil(n as u64) as usize;
    let wanted = block.realisations as usize * batch;
    let mut trials: Vec<Trial> = Vec::new();
    for replicate in 0..PATIENCE * wanted as u64 {
        if trials.len() == wanted {
            break;
        }
        let set = sets::generate(seed, distribution, n, replicate)?;
        match super::proved("corners", &set)? {
            Err(failures) => records.failures.extend(failures),
            Ok(hull) => {
                let (trial, run) = trial(&set)?;
                let right = |own| trial.accepted(own) == run.triangles.len();
                let points = Points::new(&set.points)?;
                if is_hull(points, &run.triangles, &hull) && BOTH.into_iter().all(right) {
                    records.sets.push(SetRow {
                        stage: "corners".to_owned(),
                        distribution: set.distribution.clone(),
                        n,
                        replicate,
                        seed: set.seed,
                        fingerprint: set.fingerprint(),
                        vertices: hull.len(),
                        facets: Some(hull.facets().count()),
                        certified: BOTH.len(),
                        methods: BOTH.len(),
                    });
                    trials.push(trial);
                }
            }
        }
    }
    trials.truncate(trials.len() / batch * batch);
    Ok(trials.chunks(batch).map(<[Trial]>::to_vec).collect())
}

/// The set's wrap with exact answers, and its candidates.
fn trial(set: &PointSet3) -> Result<(Trial, NathanRun)> {
    let points = Points::new(&set.points)?;
    let mut candidates = Candidates::default();
    let run = study(
        points,
        NathanOptions::PRINTED,
        &Perturbed(Exact),
        &mut candidates,
    );
    let trial = Trial {
        points: set.points.clone(),
        candidates: candidates.found,
        epsilon: PrintedArithmetic::of(points).epsilon,
    };
    Ok((trial, run))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_accept_the_triangles_of_the_wrap() {
        let set = sets::generate(1, "ball", 60, 0).expect("a set");
        let (trial, run) = trial(&set).expect("finite");
        assert!(trial.candidates.len() > 10 * run.triangles.len());
        for own_corners in BOTH {
            assert_eq!(trial.accepted(own_corners), run.triangles.len());
            let exactly = trial.wrap_exactly(own_corners).expect("finite");
            assert_eq!(exactly.triangles, run.triangles);
        }
    }
}
