//! The suite for Delaunay triangulations.

use super::change::{self, Change, Handedness};
use super::report::{message, save, shown};
use crate::check::{self, DelaunayCertificate};
use crate::families::{self, Family, curves, grids};
use geometry_core::{HullError, Method, Point2, Points, Task, Triangulation};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs the whole suite on a method for Delaunay triangulations.
///
/// 1. Every family of the plane, every set in [`delaunay_families`], and the large families: a triangulation that the
///    checker certifies.
/// 2. Every one of them up to a hundred points reordered, doubled, scaled, mirrored, turned, moved: another certificate; and where
///    the triangulation is the only one, the same one, carried along.
/// 3. Every set of up to five points of the 4 × 4 lattice: a certificate.
///
/// # Panics
///
/// On the first wrong answer, with the method, the points and the change that led to it; and if `method` is for
/// another task.
pub fn delaunay(method: &Method) {
    let Task::Delaunay(entry) = method.task else {
        panic!("{} does not compute Delaunay triangulations", method.slug);
    };
    let small = families::all().into_iter().chain(delaunay_families());
    for (seed, family) in (0..).zip(small) {
        let trial = Trial {
            slug: method.slug,
            family: family.name,
            change: "as given",
            points: &family.points,
        };
        let (answer, certificate) = trial.certify(entry.exact);
        for change in change::all(&family.points, seed) {
            let trial = Trial {
                change: &change.name,
                points: &change.points,
                ..trial
            };
            let (changed, _) = trial.certify(entry.exact);
            if certificate.cocircular == 0 {
                trial.compare(&carried(&answer, &change), &changed);
            }
        }
    }
    for family in families::large() {
        let trial = Trial {
            slug: method.slug,
            family: family.name,
            change: "as given",
            points: &family.points,
        };
        trial.certify(entry.exact);
        trial.certify(|points| (entry.unseen)(points.as_slice()));
    }
    for points in super::cases::subsets_of_lattice(4, 5) {
        let trial = Trial {
            slug: method.slug,
            family: "subsets of a 4 x 4 lattice",
            change: "as given",
            points: &points,
        };
        trial.certify(entry.exact);
    }
}

/// Sets on which squares and products of coordinates go wrong if they are rounded.
pub fn delaunay_families() -> Vec<Family> {
    let family = |name, points| Family { name, points };
    let moved = |points: Vec<Point2>, by: f64| -> Vec<Point2> {
        points.into_iter().map(|p| p.map(|x| x + by)).collect()
    };
    let times = |points: Vec<Point2>, by: f64| -> Vec<Point2> {
        points.into_iter().map(|p| p.map(|x| x * by)).collect()
    };
    let mut circle_with_centre = curves::integer_circle();
    circle_with_centre.push([0.0, 0.0]);
    vec![
        family(
            "far-lattice-of-tenths",
            moved(grids::lattice_of_tenths(6), 1e7),
        ),
        family("far-square", moved(families::random::square(51, 40), 1e7)),
        family(
            "very-far-square",
            moved(families::random::square(52, 40), 1e15),
        ),
        family("far-circle", moved(curves::integer_circle(), 1e7)),
        family("circle-with-centre", circle_with_centre),
        family("two-circles", {
            let mut points = curves::integer_circle();
            points.extend(times(curves::integer_circle(), 2.0));
            points
        }),
        family(
            "square-of-1e300",
            times(families::random::square(53, 30), 1e300),
        ),
        family("lattice-of-1e300", times(grids::lattice(5), 1e300)),
        family(
            "disc-of-1e-300",
            times(families::random::disc(54, 30), 1e-300),
        ),
        family(
            "disc-of-1e-160",
            times(families::random::disc(55, 30), 1e-160),
        ),
    ]
}

/// The only Delaunay triangulation of the changed points, where `answer` is the only one of the original points.
fn carried(answer: &Triangulation, change: &Change) -> Triangulation {
    let standing: Vec<u32> = (0..change.points.len() as u32)
        .map(|id| change.stands_for(id))
        .collect();
    let triangles = answer.triangles().iter().map(|corners| {
        let mut corners = corners.map(|id| standing[id as usize]);
        if change.handedness == Handedness::Mirrored {
            corners.reverse();
        }
        corners
    });
    Triangulation::new(triangles.collect())
}

/// What is run on what.
#[derive(Clone, Copy)]
struct Trial<'a> {
    slug: &'a str,
    family: &'a str,
    change: &'a str,
    points: &'a [Point2],
}

impl Trial<'_> {
    /// The answer of `method`, certified.
    fn certify(
        &self,
        method: impl Fn(Points<'_, 2>) -> Result<Triangulation, HullError>,
    ) -> (Triangulation, DelaunayCertificate) {
        let points = match Points::new(self.points) {
            Ok(points) => points,
            Err(error) => self.fail(&format!("the suite made a bad set: {error}")),
        };
        // Nothing that the method may have left half done is looked at after a panic.
        let answer = catch_unwind(AssertUnwindSafe(|| method(points)))
            .unwrap_or_else(|panic| self.fail(&format!("it panicked: {}", message(&*panic))))
            .unwrap_or_else(|error| {
                self.fail(&format!("expected an answer but got the error: {error}"))
            });
        match check::delaunay(self.points, &answer) {
            Ok(certificate) => (answer, certificate),
            Err(findings) => {
                const MOST: usize = 5;
                let findings = findings.iter().take(MOST);
                let findings: String = findings.map(|f| format!("\nfinding: {f}")).collect();
                self.fail(&format!("the answer is wrong:{findings}"))
            }
        }
    }

    fn compare(&self, expected: &Triangulation, answer: &Triangulation) {
        if answer != expected {
            let (expected, answer) = (expected.triangles(), answer.triangles());
            self.fail(&format!("expected {expected:?}\nbut got  {answer:?}"));
        }
    }

    #[cold]
    fn fail(&self, what: &str) -> ! {
        let Self {
            slug,
            family,
            change,
            points,
        } = self;
        let saved = save(&format!("{slug}-{family}-{change}"), points);
        let shown = shown(points);
        panic!(
            "{slug} fails on {} points: {family}, {change}\n{what}{shown}\n{saved}",
            points.len()
        );
    }
}
