//! The suite for methods in space: hulls and Delaunay triangulations.
//!
//! As in the plane ([`super`]): exact answers on every [family](crate::families_space), metamorphic changes
//! ([`change`]), exhaustive small sets, large sets judged by the certificate, all instances, contradictory kernels
//! ([`hostile`]).

mod cases;
pub mod change;
pub mod hostile;
mod trial;

use crate::families_space::{self, Family3};
use cases::{Solved, cases};
use geometry_core::method::SpatialHull;
use geometry_core::{Exact, Kernel3, Method, Recorder, Tally, Task};
use hostile::{Budget3, Hostile3, Rounded};
use trial::Trial;

/// Runs the whole suite on a method for hulls in space.
///
/// 1. **exact**: the oracle's answer, and a certificate for it, on every family, from all three instances;
/// 2. **metamorphic**: the same answer, carried along, under ten orders, copies, scalings by powers of two, and
///    permutations and reflections of the axes; and the same answer when points inside are added;
/// 3. **exhaustive**: the oracle's answer for every set of up to five points of the 3 × 3 × 3 lattice, and for every
///    sequence, repetitions included, of up to five corners of a cube;
/// 4. **large**: an answer that the checker certifies, on sets of up to eight thousand points;
/// 5. **contradicted**: no panic, no endless loop and no index out of range when the kernel's answers contradict each
///    other. [`HullError::Contradiction`](geometry_core::HullError::Contradiction) is a good answer.
///
/// # Panics
///
/// On the first wrong answer, with the method, the points and the change that led to it; and if `method` is for
/// another task.
pub fn spatial_hull(method: &Method) {
    let Task::SpatialHull(entry) = method.task else {
        panic!("{} does not compute hulls in space", method.slug);
    };
    let suite = Suite {
        slug: method.slug,
        entry,
    };
    for (number, solved) in (0..).zip(&cases().families) {
        suite.observed(solved);
        suite.metamorphic(solved, number);
        suite.contradicted(solved);
    }
    for solved in &cases().small {
        let trial = suite.trial("exact", solved, "as given");
        trial.equals(&solved.answer, entry.exact);
    }
    for family in families_space::large() {
        suite.large(&family);
    }
}

struct Suite {
    slug: &'static str,
    entry: SpatialHull,
}

impl Suite {
    fn observed(&self, solved: &Solved) {
        self.exact(solved, "as given");
        self.trial("tallied", solved, "as given")
            .expect(&solved.answer, |points| {
                (self.entry.tallied)(points, &Exact, &mut Tally::default())
            });
        self.trial("recorded", solved, "as given")
            .expect(&solved.answer, |points| {
                (self.entry.recorded)(points, &Exact, &mut Recorder::default())
            });
    }

    fn metamorphic(&self, solved: &Solved, seed: u64) {
        for change in change::all(&solved.points, seed) {
            self.exact(&solved.carried(&change), &change.name);
        }
        let grown = solved.grown();
        self.exact(&grown, "with more points inside");
        for change in change::reorderings(&grown.points, seed).into_iter().take(5) {
            self.exact(&grown.carried(&change), &change.name);
        }
    }

    fn exact(&self, solved: &Solved, change: &str) {
        self.trial("exact", solved, change)
            .expect(&solved.answer, self.entry.exact);
        self.trial("unseen", solved, change)
            .expect(&solved.answer, |points| {
                (self.entry.unseen)(points.as_slice())
            });
    }

    fn contradicted(&self, solved: &Solved) {
        // Enough to show what a method does with contradictions; larger sets only take longer.
        const MOST: usize = 64;
        if solved.points.len() > MOST {
            return;
        }
        let hostile = Hostile3::all();
        let kernels = hostile
            .iter()
            .map(|kernel| (kernel.name(), kernel as &dyn Kernel3))
            .chain([("tallied, rounded to f32", &Rounded as &dyn Kernel3)]);
        for (name, kernel) in kernels {
            let kernel = Budget3::new(kernel, solved.points.len());
            self.trial(name, solved, "as given")
                .survive(|points| (self.entry.tallied)(points, &kernel, &mut Tally::default()));
        }
    }

    fn large(&self, family: &Family3) {
        let trial = Trial {
            slug: self.slug,
            instance: "exact",
            family: family.name,
            change: "as given",
            points: &family.points,
        };
        trial.certify(self.entry.exact);
        trial.certify(|points| (self.entry.unseen)(points.as_slice()));
    }

    fn trial<'a>(&'a self, instance: &'a str, solved: &'a Solved, change: &'a str) -> Trial<'a> {
        Trial {
            slug: self.slug,
            instance,
            family: solved.name,
            change,
            points: &solved.points,
        }
    }
}
