//! One run of a method on one point set, and the report if it fails.

use super::answer::Answer;
use geometry_core::{Boundary, HullError, Point2, Points};
use std::any::Any;
use std::fmt::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;

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
        let saved = match self.save() {
            Ok(path) => format!("points saved in {}", path.display()),
            Err(error) => format!("the points could not be saved: {error}"),
        };
        let Self {
            slug,
            instance,
            family,
            change,
            boundary,
            points,
        } = self;
        let shown = if points.len() <= 12 {
            format!("\npoints: {points:?}")
        } else {
            String::new()
        };
        panic!(
            "{slug} ({instance}) fails on {} points: {family}, {change}, {boundary:?}\n{what}{shown}\n{saved}",
            points.len()
        );
    }

    /// Writes the points as lines `x,y`, each number the shortest that reads back to the same bits.
    fn save(&self) -> std::io::Result<PathBuf> {
        let folder =
            std::env::var_os("CARGO_TARGET_TMPDIR").map_or_else(std::env::temp_dir, PathBuf::from);
        let name = format!(
            "{}-{}-{}-{:?}.csv",
            self.slug, self.family, self.change, self.boundary
        );
        let plain = |c: char| {
            if c.is_ascii_alphanumeric() || "-.".contains(c) {
                c
            } else {
                '_'
            }
        };
        let path = folder.join(name.chars().map(plain).collect::<String>());
        let mut text = String::from("x,y\n");
        for [x, y] in self.points {
            let _ = writeln!(text, "{x:?},{y:?}");
        }
        std::fs::write(&path, text)?;
        Ok(path)
    }
}

/// The message of a caught panic.
pub(super) fn message(panic: &(dyn Any + Send)) -> &str {
    panic
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| panic.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("(no message)")
}
