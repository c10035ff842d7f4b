//! One run of a method on one point set, and the report if it fails.

use crate::check;
use crate::conformance::report::{message, save, shown};
use geometry_core::{Hull3, HullError, Point3, Points};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What is run on what.
pub(super) struct Trial<'a> {
    pub(super) slug: &'a str,
    pub(super) instance: &'a str,
    pub(super) family: &'a str,
    pub(super) change: &'a str,
    pub(super) points: &'a [Point3],
}

type Answer = Result<Hull3, HullError>;

impl Trial<'_> {
    /// Panics unless `method` gives `expected`.
    pub(super) fn equals(&self, expected: &Hull3, method: impl FnOnce(Points<'_, 3>) -> Answer) {
        self.compare(expected, &self.answer(method));
    }

    /// Panics unless `method` gives `expected` and the checker certifies it.
    pub(super) fn expect(&self, expected: &Hull3, method: impl FnOnce(Points<'_, 3>) -> Answer) {
        let answer = self.answer(method);
        self.compare(expected, &answer);
        self.certify_answer(&answer);
    }

    /// Panics unless `method` gives an answer that the checker certifies.
    pub(super) fn certify(&self, method: impl FnOnce(Points<'_, 3>) -> Answer) {
        self.certify_answer(&self.answer(method));
    }

    /// Panics if `method` does, or gives an index that is none; any other answer and any error will do.
    pub(super) fn survive(&self, method: impl FnOnce(Points<'_, 3>) -> Answer) {
        if let Ok(answer) = self.run(method) {
            let names_a_point = |&id: &u32| (id as usize) < self.points.len();
            if !answer.vertices().iter().all(names_a_point) {
                self.fail(&format!(
                    "the answer names points that do not exist: {answer:?}"
                ));
            }
        }
    }

    fn run(&self, method: impl FnOnce(Points<'_, 3>) -> Answer) -> Answer {
        let points = match Points::new(self.points) {
            Ok(points) => points,
            Err(error) => self.fail(&format!("the suite made a bad set: {error}")),
        };
        // Nothing that the method may have left half done is looked at after a panic.
        catch_unwind(AssertUnwindSafe(|| method(points)))
            .unwrap_or_else(|panic| self.fail(&format!("it panicked: {}", message(&*panic))))
    }

    /// The answer, which a method must give where the kernel is exact.
    fn answer(&self, method: impl FnOnce(Points<'_, 3>) -> Answer) -> Hull3 {
        self.run(method).unwrap_or_else(|error| {
            self.fail(&format!("expected an answer but got the error: {error}"))
        })
    }

    fn compare(&self, expected: &Hull3, answer: &Hull3) {
        if answer != expected {
            let findings = self.findings(answer);
            self.fail(&format!(
                "expected {}\nbut got  {}{findings}",
                Shown(expected),
                Shown(answer)
            ));
        }
    }

    fn certify_answer(&self, answer: &Hull3) {
        let findings = self.findings(answer);
        if !findings.is_empty() {
            self.fail(&format!("the answer is wrong:{findings}"));
        }
    }

    /// The first few findings of the checker, each on a line of its own; nothing for a right answer.
    fn findings(&self, answer: &Hull3) -> String {
        const MOST: usize = 5;
        let findings = check::hull3(self.points, answer).err().unwrap_or_default();
        findings
            .iter()
            .take(MOST)
            .map(|finding| format!("\nfinding: {finding}"))
            .collect()
    }

    #[cold]
    fn fail(&self, what: &str) -> ! {
        let Self {
            slug,
            instance,
            family,
            change,
            points,
        } = self;
        let saved = save(&format!("{slug}-{family}-{change}"), points);
        let shown = shown(points);
        panic!(
            "{slug} ({instance}) fails on {} points: {family}, {change}\n{what}{shown}\n{saved}",
            points.len()
        );
    }
}

/// A hull as its facets, or as it is if it has none.
struct Shown<'a>(&'a Hull3);

impl std::fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0 {
            Hull3::Solid(solid) => f.debug_list().entries(solid.facets()).finish(),
            flat => write!(f, "{flat:?}"),
        }
    }
}
