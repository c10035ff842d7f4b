//! One run of a method on one point set, and the report if it fails.

use super::answer::Answer;
use super::report::{message, save, shown};
use geometry_core::{Boundary, HullError, Point2, Points};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What is run on what.
pub(super) struct Trial<'a> {
    pub(super) slug: &'a str,
    pub(super) instance: &'a str,
    pub(super) family: &'a str,
    pub(super) change: &'a str,
    pub(super) boundary: Boundary,
    pub(super) points: &'a [Point2],
}

impl Trial<'_> {
    /// Panics unless `method` gives `expected` and the checker certifies it.
    pub(super) fn expect<A: Answer>(
        &self,
        expected: &A,
        method: impl FnOnce(Points<'_, 2>) -> Result<A, HullError>,
    ) {
        let answer = self.answer(method);
        let findings = self.findings(&answer);
        if answer != *expected || !findings.is_empty() {
            self.fail(&format!(
                "expected {expected:?}\nbut got  {answer:?}{findings}"
            ));
        }
    }

    /// Panics unless `method` gives an answer that the checker certifies.
    pub(super) fn certify<A: Answer>(
        &self,
        method: impl FnOnce(Points<'_, 2>) -> Result<A, HullError>,
    ) {
        let findings = self.findings(&self.answer(method));
        if !findings.is_empty() {
            self.fail(&format!("the answer is wrong:{findings}"));
        }
    }

    /// Panics if `method` does, or gives an index that is none; any other answer and any error will do.
    pub(super) fn survive<A: Answer>(
        &self,
        method: impl FnOnce(Points<'_, 2>) -> Result<A, HullError>,
    ) {
        if let Ok(answer) = self.run(method)
            && !answer.names_points(self.points.len())
        {
            self.fail(&format!(
                "the answer names points or rings that do not exist: {answer:?}"
            ));
        }
    }

    fn run<A>(
        &self,
        method: impl FnOnce(Points<'_, 2>) -> Result<A, HullError>,
    ) -> Result<A, HullError> {
        let points = match Points::new(self.points) {
            Ok(points) => points,
            Err(error) => self.fail(&format!("the suite made a bad set: {error}")),
        };
        // Nothing that the method may have left half done is looked at after a panic.
        catch_unwind(AssertUnwindSafe(|| method(points)))
            .unwrap_or_else(|panic| self.fail(&format!("it panicked: {}", message(&*panic))))
    }

    /// The answer, which a method must give where the kernel is exact.
    fn answer<A>(&self, method: impl FnOnce(Points<'_, 2>) -> Result<A, HullError>) -> A {
        self.run(method).unwrap_or_else(|error| {
            self.fail(&format!("expected an answer but got the error: {error}"))
        })
    }

    /// The first few findings of the checker, each on a line of its own; nothing for a right answer.
    fn findings<A: Answer>(&self, answer: &A) -> String {
        const MOST: usize = 5;
        let findings = answer
            .certify(self.points, self.boundary)
            .err()
            .unwrap_or_default();
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
            boundary,
            points,
        } = self;
        let saved = save(&format!("{slug}-{family}-{change}-{boundary:?}"), points);
        let shown = shown(points);
        panic!(
            "{slug} ({instance}) fails on {} points: {family}, {change}, {boundary:?}\n{what}{shown}\n{saved}",
            points.len()
        );
    }
}
