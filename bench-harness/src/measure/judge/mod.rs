//! Whether an answer is right, and how wrong a wrong one is.
//!
//! The reference is our own hull, proved by the checker. An answer equal to it is right; any other is given to the
//! checker; and of one that is refuted it is said which extreme points it misses, how far outside they lie, and which
//! of its vertices are none.
//!
//! | module | holds |
//! |---|---|
//! | `plane` | answers about hulls of the plane |
//! | `space` | answers about hulls in space |
//! | `difference` | how the vertices of an answer differ from the extreme points |

mod difference;
mod plane;
mod space;

use crate::counting::PointSet;
use crate::engine::answer::Answer;
use crate::engine::protocol::{Kind, Problem};
use crate::records::Outcome;
use geometry_core::{Boundary, Hull3, Layers, Points, Triangulation};
use hull_verify::check;
use std::collections::HashMap;

/// What became of an engine's answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Judgement {
    pub(super) outcome: Outcome,
    /// Vertices; the mean over a batch.
    pub(super) h: Option<u64>,
    /// Facets, triangles or layers; the mean over a batch.
    pub(super) facets: Option<u64>,
    pub(super) finding: String,
}

impl Judgement {
    /// There is nothing to judge.
    pub(super) fn without_answer(outcome: Outcome, finding: String) -> Self {
        Self {
            outcome,
            h: None,
            facets: None,
            finding,
        }
    }

    /// There is no hull to judge, by design.
    pub(super) fn yardstick(about: &str) -> Self {
        Self::without_answer(Outcome::Certified, about.to_owned())
    }

    fn certified(answer: &Answer, finding: &str) -> Self {
        Self {
            outcome: Outcome::Certified,
            h: Some(answer.vertices().len() as u64),
            facets: (answer.kind() != Kind::Cycle).then(|| answer.parts().count() as u64),
            finding: finding.to_owned(),
        }
    }

    fn wrong(answer: &Answer, finding: String) -> Self {
        Self {
            outcome: Outcome::Wrong,
            finding,
            ..Self::certified(answer, "")
        }
    }

    /// That of a batch: wrong if any is.
    pub(super) fn of_all(judgements: Vec<Judgement>) -> Self {
        let count = judgements.len() as u64;
        let mean = |of: fn(&Judgement) -> Option<u64>| {
            let values: Option<Vec<u64>> = judgements.iter().map(of).collect();
            values.map(|values| (values.iter().sum::<u64>() + count / 2) / count.max(1))
        };
        let (h, facets) = (mean(|j| j.h), mean(|j| j.facets));
        let wrong = judgements
            .iter()
            .filter(|j| j.outcome != Outcome::Certified)
            .count();
        let first = judgements.iter().find(|j| j.outcome != Outcome::Certified);
        match first.or(judgements.first()) {
            None => Self::without_answer(Outcome::Garbled, "no sets".to_owned()),
            Some(shown) => Self {
                outcome: shown.outcome,
                h,
                facets,
                finding: match (wrong, count) {
                    (0, _) | (_, 1) => shown.finding.clone(),
                    _ => format!("{wrong} of {count} sets; the first: {}", shown.finding),
                },
            },
        }
    }
}

/// The right answers of a stop, each made and proved when it is first asked for.
#[derive(Debug)]
pub(super) struct Reference {
    problem: Problem,
    boundary: Boundary,
    proved: HashMap<usize, Result<Proved, String>>,
}

/// A value that the checker has proved.
#[derive(Clone, Debug)]
enum Proved {
    Plane(plane::Reference),
    Space(Hull3),
    Layers(Layers),
    Delaunay(Triangulation),
}

impl Reference {
    /// For answers whose vertices are those of `boundary`.
    pub(super) fn new(problem: Problem, boundary: Boundary) -> Self {
        Self {
            problem,
            boundary,
            proved: HashMap::new(),
        }
    }

    /// Judges `answer` about set `number` of the stop.
    pub(super) fn judge(&mut self, number: usize, set: &PointSet, answer: &Answer) -> Judgement {
        let (problem, boundary) = (self.problem, self.boundary);
        let proved = self
            .proved
            .entry(number)
            .or_insert_with(|| prove(problem, boundary, set));
        let judged = match (proved, set) {
            (Err(what), _) => Err(format!("the reference has no certificate: {what}")),
            (Ok(Proved::Plane(proved)), PointSet::Plane(points)) => proved.judge(points, answer),
            (Ok(Proved::Space(hull)), PointSet::Space(points)) => {
                space::judge(points, hull, answer)
            }
            (Ok(Proved::Layers(layers)), PointSet::Plane(points)) => {
                let found = view(points).map(|points| answer.layers(points));
                match found {
                    Ok(found) if found.as_ref() == Some(layers) => Ok(String::new()),
                    Ok(_) => Err("these are not the layers".to_owned()),
                    Err(what) => Err(what),
                }
            }
            (Ok(Proved::Delaunay(proved)), PointSet::Plane(points)) => {
                delaunay(points, proved, answer)
            }
            _ => Err("points of another dimension".to_owned()),
        };
        match judged {
            Ok(finding) => Judgement::certified(answer, &finding),
            Err(finding) => Judgement::wrong(answer, finding),
        }
    }
}

fn view<const D: usize>(points: &[[f64; D]]) -> Result<Points<'_, D>, String> {
    Points::new(points).map_err(|error| error.to_string())
}

/// Makes and proves the right answer.
fn prove(problem: Problem, boundary: Boundary, set: &PointSet) -> Result<Proved, String> {
    let error = |error: hullkit::HullError| error.to_string();
    match (problem, set) {
        (Problem::Hull2, PointSet::Plane(points)) => {
            plane::Reference::prove(points, boundary).map(Proved::Plane)
        }
        (Problem::Layers, PointSet::Plane(points)) => {
            let layers = hullkit::convex_layers(points, boundary).map_err(error)?;
            check::layers(points, boundary, &layers).map_err(|f| first(&f))?;
            Ok(Proved::Layers(layers))
        }
        (Problem::Delaunay, PointSet::Plane(points)) => {
            let triangulation = hullkit::delaunay(points).map_err(error)?;
            check::delaunay(points, &triangulation).map_err(|f| first(&f))?;
            Ok(Proved::Delaunay(triangulation))
        }
        (Problem::Hull3, PointSet::Space(points)) => {
            let hull = hullkit::convex_hull_3d(points).map_err(error)?;
            check::hull3(points, &hull).map_err(|f| first(&f))?;
            Ok(Proved::Space(hull))
        }
        _ => Err("points of another dimension".to_owned()),
    }
}

fn first<F: std::fmt::Display>(findings: &[F]) -> String {
    let first = findings
        .first()
        .map(ToString::to_string)
        .unwrap_or_default();
    format!("{} findings, first: {first}", findings.len())
}

fn delaunay(
    points: &[[f64; 2]],
    proved: &Triangulation,
    answer: &Answer,
) -> Result<String, String> {
    let Some(found) = answer.triangulation() else {
        return Err("no triangles".to_owned());
    };
    if found == *proved {
        return Ok(String::new());
    }
    match check::delaunay(points, &found) {
        Ok(_) => Ok("another triangulation of cocircular points".to_owned()),
        Err(findings) => Err(first(&findings)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(problem: Problem, set: &PointSet, answer: &Answer) -> Judgement {
        Reference::new(problem, Boundary::Extreme).judge(0, set, answer)
    }

    #[test]
    fn planar_answers() {
        let points = vec![
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 4.0],
            [0.0, 4.0],
            [2.0, 0.0],
            [1.0, 1.0],
        ];
        let set = PointSet::Plane(points);
        let says = |kind, ids: &[u32]| judged(Problem::Hull2, &set, &Answer::new(kind, [ids]));
        let certified = says(Kind::Cycle, &[0, 1, 2, 3]);
        assert_eq!(
            (certified.outcome, certified.h),
            (Outcome::Certified, Some(4))
        );
        assert_eq!(
            says(Kind::Vertices, &[3, 1, 0, 2]).outcome,
            Outcome::Certified
        );
        let all = says(Kind::Cycle, &[0, 4, 1, 2, 3]);
        assert_eq!(all.outcome, Outcome::Certified);
        assert!(all.finding.contains("on edges"));
        let displaced = says(Kind::Cycle, &[0, 1, 4, 2, 3]);
        assert_eq!(displaced.outcome, Outcome::Wrong);
        let misses = says(Kind::Cycle, &[0, 1, 2]);
        assert_eq!(misses.outcome, Outcome::Wrong);
        assert!(
            misses
                .finding
                .contains("misses 1 extreme points, the furthest 2.828e0"),
            "{}",
            misses.finding
        );
        assert!(
            says(Kind::Cycle, &[0, 1, 2, 3, 5])
                .finding
                .contains("1 vertices are no")
        );
        assert_eq!(says(Kind::Cycle, &[0, 2, 1, 3]).outcome, Outcome::Wrong);
    }

    #[test]
    fn spatial_answers() {
        let points: Vec<[f64; 3]> = (0..8)
            .map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from))
            .collect();
        let hull = hullkit::convex_hull_3d(&points).expect("a cube");
        let triangles: Vec<[u32; 3]> = hull.triangles().collect();
        let set = PointSet::Space(points);
        let says =
            |kind, parts: &[[u32; 3]]| judged(Problem::Hull3, &set, &Answer::new(kind, parts));
        assert_eq!(
            judged(Problem::Hull3, &set, &Answer::from(&hull)).outcome,
            Outcome::Certified
        );
        assert_eq!(
            says(Kind::Triangles, &triangles).outcome,
            Outcome::Certified
        );
        assert_eq!(
            says(Kind::Triangles, &triangles[1..]).outcome,
            Outcome::Wrong
        );
        let tetrahedron = [[0, 2, 1], [0, 1, 4], [0, 4, 2], [1, 2, 4]];
        assert!(
            says(Kind::Triangles, &tetrahedron)
                .finding
                .contains("misses 4 extreme points")
        );
    }

    #[test]
    fn a_batch_is_as_bad_as_its_worst() {
        let right = Judgement {
            outcome: Outcome::Certified,
            h: Some(4),
            facets: None,
            finding: String::new(),
        };
        let wrong = Judgement {
            outcome: Outcome::Wrong,
            h: Some(3),
            facets: None,
            finding: "misses".to_owned(),
        };
        let both = Judgement::of_all(vec![right.clone(), wrong]);
        assert_eq!((both.outcome, both.h), (Outcome::Wrong, Some(4)));
        assert_eq!(both.finding, "1 of 2 sets; the first: misses");
        assert_eq!(Judgement::of_all(vec![right.clone(), right.clone()]), right);
    }
}
