//! A part of a run: the rows of one definition.

use super::rows::{Cell, Subject};
use super::run::Run;
use std::collections::BTreeSet;

impl Run {
    /// The same run with the rows of one definition alone.
    #[must_use]
    pub fn only(&self, definition: &str) -> Self {
        let of = |subject: &Subject| subject.case.definition == definition;
        let cells: Vec<Cell> = self
            .cells
            .iter()
            .filter(|row| of(&row.subject))
            .cloned()
            .collect();
        let samples = self.samples.iter().filter(|row| of(&row.subject));
        let counts = self.counts.iter().filter(|row| of(&row.subject));
        let warnings = self.warnings.iter().filter(|row| of(&row.subject));
        let rows = (
            samples.cloned().collect(),
            counts.cloned().collect(),
            warnings.cloned().collect(),
        );
        let mut part = Self::from_rows(self.manifest.clone(), cells, rows);
        part.folder.clone_from(&self.folder);
        part.notes.clone_from(&self.notes);
        part
    }

    /// The definitions that it has cases of, in order.
    pub fn definitions(&self) -> Vec<&str> {
        let cases = self.cases().into_iter();
        let ids: BTreeSet<&str> = cases.map(|case| case.definition.as_str()).collect();
        ids.into_iter().collect()
    }
}
