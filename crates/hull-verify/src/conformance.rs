//! The conformance suite: any method, one line.
//!
//! ```no_run
//! # let method: geometry_core::Method = unimplemented!();
//! hull_verify::conformance::planar_hull(&method);
//! ```
//!
//! For both boundaries, the suite asks of a method
//!
//! 1. **exact**: the oracle's answer, and a certificate for it, on every [family](crate::families);
//! 2. **metamorphic**: the same answer, carried along, when the points are reordered, doubled, scaled by powers
//!    of two, mirrored, turned or moved ([`change`]), and when points are added that change the answer in a known
//!    way (inside a hull; around layers);
//! 3. **exhaustive**: the oracle's answer for every set of up to six points of the 4 × 4 lattice, and for every
//!    sequence, repetitions included, of up to four points of the 3 × 3 lattice;
//! 4. **large**: an answer that the checker certifies, on sets of up to three thousand points;
//! 5. **observed**: the same answer from the tallied and the recorded instance with the exact kernel;
//! 6. **contradicted**: no panic, no endless loop and no index out of range when the kernel's answers contradict
//!    each other ([`hostile`]). [`HullError::Contradiction`] is a good answer.
//!
//! The expected answers are found once a process and shared by all methods. A failure panics with everything
//! needed to repeat it, and saves the points as `x,y` lines that read back to the same bits.

mod answer;
mod cases;
pub mod change;
mod delaunay;
pub mod hostile;
mod report;
pub mod space;
mod trial;

pub use delaunay::{delaunay, delaunay_families};
pub use space::spatial_hull;

use crate::families::{self, Family};
use answer::Answer;
use cases::{Solved, cases};
use change::Change;
use geometry_core::tolerance::formats::Single;
use geometry_core::{
    Boundary, Exact, Hull2, HullError, Kernel2, Layers, Method, Points, Recorder, Tally, Task,
    Tolerance,
};
use hostile::{Budget, Hostile};
use trial::Trial;

const BOUNDARIES: [Boundary; 2] = [Boundary::Extreme, Boundary::All];

/// Runs the whole suite on a method for planar hulls.
///
/// # Panics
///
/// On the first wrong answer, with the method, the points and the change that led to it; and if `method` is for
/// another task.
pub fn planar_hull(method: &Method) {
    let Task::PlanarHull(entry) = method.task else {
        panic!("{} does not compute planar hulls", method.slug);
    };
    Suite::<Hull2> {
        slug: method.slug,
        unseen: entry.unseen,
        exact: entry.exact,
        tallied: entry.tallied,
        recorded: entry.recorded,
    }
    .run();
}

/// Runs the whole suite on a method for planar convex layers.
///
/// # Panics
///
/// On the first wrong answer, with the method, the points and the change that led to it; and if `method` is for
/// another task.
pub fn planar_layers(method: &Method) {
    let Task::PlanarLayers(entry) = method.task else {
        panic!("{} does not compute planar layers", method.slug);
    };
    Suite::<Layers> {
        slug: method.slug,
        unseen: entry.unseen,
        exact: entry.exact,
        tallied: entry.tallied,
        recorded: entry.recorded,
    }
    .run();
}

/// The instances of a method whose answer is `A`.
struct Suite<A> {
    slug: &'static str,
    unseen: fn(&[[f64; 2]], Boundary) -> Result<A, HullError>,
    exact: fn(Points<'_, 2>, Boundary) -> Result<A, HullError>,
    tallied: fn(Points<'_, 2>, Boundary, &dyn Kernel2, &mut Tally) -> Result<A, HullError>,
    recorded: fn(Points<'_, 2>, Boundary, &dyn Kernel2, &mut Recorder) -> Result<A, HullError>,
}

impl<A: Answer> Suite<A> {
    fn run(&self) {
        for (number, solved) in (0..).zip(&cases::<A>().families) {
            self.observed(solved);
            self.metamorphic(solved, number);
            self.contradicted(solved);
            for boundary in BOUNDARIES {
                if let Some(grown) = solved.grown(boundary) {
                    self.exact(&grown, boundary, "as given");
                    self.reordered(&grown, boundary, number);
                }
            }
        }
        for solved in &cases::<A>().small {
            for boundary in BOUNDARIES {
                self.exact(solved, boundary, "as given");
            }
        }
        for family in families::large() {
            self.large(&family);
        }
    }

    /// The exact instance gives the expected answer, and the checker certifies it; so does the one from unseen points.
    fn exact(&self, solved: &Solved<A>, boundary: Boundary, change: &str) {
        let trial = self.trial("exact", solved, boundary, change);
        trial.expect(solved.answer(boundary), |points| {
            (self.exact)(points, boundary)
        });
        let trial = self.trial("unseen", solved, boundary, change);
        trial.expect(solved.answer(boundary), |points| {
            (self.unseen)(points.as_slice(), boundary)
        });
    }

    fn observed(&self, solved: &Solved<A>) {
        for boundary in BOUNDARIES {
            let expected = solved.answer(boundary);
            self.exact(solved, boundary, "as given");
            self.trial("tallied", solved, boundary, "as given")
                .expect(expected, |points| {
                    (self.tallied)(points, boundary, &Exact, &mut Tally::default())
                });
            self.trial("recorded", solved, boundary, "as given")
                .expect(expected, |points| {
                    (self.recorded)(points, boundary, &Exact, &mut Recorder::default())
                });
        }
    }

    fn metamorphic(&self, solved: &Solved<A>, seed: u64) {
        for change in change::all(&solved.points, seed) {
            let changed = solved.carried(&change);
            for boundary in BOUNDARIES {
                self.exact(&changed, boundary, &change.name);
            }
        }
    }

    fn reordered(&self, solved: &Solved<A>, boundary: Boundary, seed: u64) {
        for change in [
            Change::reversed(&solved.points),
            Change::shuffled(&solved.points, seed),
        ] {
            self.exact(&solved.carried(&change), boundary, &change.name);
        }
    }

    fn contradicted(&self, solved: &Solved<A>) {
        let rounded = [1e-4, 1e-1, 1e3].map(Tolerance::<Single>::new);
        let hostile = Hostile::all();
        let named = rounded
            .iter()
            .map(|kernel| ("tallied, tolerance in f32", kernel as &dyn Kernel2));
        let named = named.chain(
            hostile
                .iter()
                .map(|kernel| (kernel.name(), kernel as &dyn Kernel2)),
        );
        for (name, kernel) in named {
            for boundary in BOUNDARIES {
                let kernel = Budget::new(kernel, solved.points.len());
                self.trial(name, solved, boundary, "as given")
                    .survive(|points| {
                        (self.tallied)(points, boundary, &kernel, &mut Tally::default())
                    });
            }
        }
    }

    /// The exact instance gives an answer that the checker certifies.
    fn large(&self, family: &Family) {
        for boundary in BOUNDARIES {
            let trial = Trial {
                slug: self.slug,
                instance: "exact",
                family: family.name,
                change: "as given",
                boundary,
                points: &family.points,
            };
            trial.certify(|points| (self.exact)(points, boundary));
            trial.certify(|points| (self.unseen)(points.as_slice(), boundary));
        }
    }

    fn trial<'a>(
        &'a self,
        instance: &'a str,
        solved: &'a Solved<A>,
        boundary: Boundary,
        change: &'a str,
    ) -> Trial<'a> {
        Trial {
            slug: self.slug,
            instance,
            family: solved.name,
            change,
            boundary,
            points: &solved.points,
        }
    }
}
