//! The answer, for readers and programs.

use super::{Change, Diff, Row};
use crate::analysis::{h_text, ratio_text, text, time_text};
use crate::output::page::{Page, Section, json};
use crate::output::sheet::Sheet;

impl Diff {
    /// The answer for readers and programs.
    pub fn page(&self) -> Page {
        let mut sections = vec![self.times()];
        if !self.counts.is_empty() {
            sections.push(self.count_section());
        }
        if !self.lost.is_empty() {
            sections.push(self.lost_section());
        }
        let count = |change| self.changed(change).count();
        Page {
            title: "What has changed between two runs".into(),
            preface: vec![
                self.band.sentence(),
                "Ratio: now over before, with its 95 % interval over realisations and rounds. Slower or faster: the \
                 interval lies outside the band, and p < 0.05 adjusted for all cells (Holm)."
                    .into(),
            ],
            sections,
            long: self.long(),
            value: json(self),
            headline: format!(
                "{} cells compared, {} slower, {} faster, {} counts differ",
                self.rows.len(),
                count(Change::Slower),
                count(Change::Faster),
                self.counts.len()
            ),
        }
    }

    /// The cells that have changed, the worst first.
    fn times(&self) -> Section {
        let mut changed: Vec<&Row> = self
            .rows
            .iter()
            .filter(|row| row.change != Change::None)
            .collect();
        changed.sort_by(|a, b| b.ratio.total_cmp(&a.ratio));
        let mut sheet = Sheet::new(&[
            "case", "h", "engine", "before", "now", "ratio", "p", "change",
        ]);
        for row in &changed {
            sheet.push(vec![
                row.case.to_string(),
                h_text(row.h),
                row.engine.clone(),
                time_text(Some(row.before)),
                time_text(Some(row.after)),
                ratio_text(row.ratio.ln(), (row.low.ln(), row.high.ln())),
                format!("{:.2e}", row.p_value),
                row.change.to_string(),
            ]);
        }
        Section {
            heading: format!(
                "Times: {} of {} cells have changed",
                changed.len(),
                self.rows.len()
            ),
            sheet,
            notes: self.notes.clone(),
        }
    }

    fn count_section(&self) -> Section {
        let mut sheet = Sheet::new(&[
            "case", "engine", "counter", "before", "now", "ratio", "sets",
        ]);
        for row in &self.counts {
            sheet.push(vec![
                row.case.to_string(),
                row.engine.clone(),
                row.counter.clone(),
                row.before.to_string(),
                row.after.to_string(),
                format!("{:.4}", row.after as f64 / row.before as f64),
                row.realisations.to_string(),
            ]);
        }
        Section {
            heading: "Counts that differ; every one is exact".into(),
            sheet,
            notes: Vec::new(),
        }
    }

    fn lost_section(&self) -> Section {
        let mut sheet = Sheet::new(&["case", "seed", "engine", "outcome", "finding"]);
        for row in &self.lost {
            sheet.push(vec![
                row.case.to_string(),
                row.seed.to_string(),
                row.engine.clone(),
                row.outcome.clone(),
                row.finding.clone(),
            ]);
        }
        Section {
            heading: "Certified before, and no longer".into(),
            sheet,
            notes: Vec::new(),
        }
    }

    fn long(&self) -> Sheet {
        let mut sheet = Sheet::new(&[
            "definition",
            "set",
            "n",
            "h",
            "engine",
            "before",
            "after",
            "realisations",
            "ratio",
            "low",
            "high",
            "p",
            "change",
        ]);
        for row in &self.rows {
            sheet.push(vec![
                row.case.definition.clone(),
                row.case.set.clone(),
                row.case.n.to_string(),
                text(row.h.map(|h| h.middle)),
                row.engine.clone(),
                row.before.to_string(),
                row.after.to_string(),
                row.realisations.to_string(),
                row.ratio.to_string(),
                row.low.to_string(),
                row.high.to_string(),
                row.p_value.to_string(),
                row.change.to_string(),
            ]);
        }
        sheet
    }
}
