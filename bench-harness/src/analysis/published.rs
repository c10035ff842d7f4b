//! Times that the authors of other programs print, beside the same programs here.

use super::compare::Comparison;
use super::{ratio_text, text, time_text, typical_time};
use crate::engine::catalogue::{self, Entry};
use crate::output::page::{Page, Section, json};
use crate::output::sheet::Sheet;
use crate::records::{Case, Run};
use serde::{Deserialize, Serialize};

/// A published time.
#[derive(Clone, Debug, Deserialize, Serialize, PartialEq)]
#[serde(deny_unknown_fields)]
pub struct Figure {
    /// The definition that measures the same.
    pub definition: String,
    /// Its point set.
    pub set: String,
    /// Its number of points.
    pub n: usize,
    /// The program.
    pub engine: String,
    /// What is printed.
    pub seconds: f64,
    /// Where.
    pub source: String,
}

/// A published time beside what was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// What is printed.
    #[serde(flatten)]
    pub figure: Figure,
    /// The typical time of a call of the program here, in nanoseconds.
    pub nanoseconds: Option<f64>,
    /// The fastest of our methods on the case.
    pub ours: Option<String>,
    /// The time of the program over that of ours, here: ratio and its 95 % interval.
    pub over_ours: Option<[f64; 3]>,
}

/// The answer.
#[derive(Clone, Debug, Serialize)]
pub struct Published {
    /// A row a figure.
    pub rows: Vec<Row>,
}

/// Those of `figures` that are about definitions of `run`, with what was measured.
pub fn published(run: &Run, figures: &[Figure]) -> Published {
    let known = run.definitions();
    let about = |figure: &&Figure| known.contains(&figure.definition.as_str());
    let rows = figures.iter().filter(about).map(|figure| row(run, figure));
    Published {
        rows: rows.collect(),
    }
}

fn row(run: &Run, figure: &Figure) -> Row {
    let case = Case {
        definition: figure.definition.clone(),
        set: figure.set.clone(),
        n: figure.n,
    };
    let is_ours = |name: &&str| matches!(catalogue::find(name), Some(Entry::Own(_)));
    let time = |name: &str| typical_time(run, &case, name).unwrap_or(f64::INFINITY);
    let ours = run.timed(&case).into_iter().filter(is_ours);
    let ours = ours.min_by(|a, b| time(a).total_cmp(&time(b)));
    let compared = ours.and_then(|ours| Comparison::of(run, &case, &figure.engine, ours));
    Row {
        figure: figure.clone(),
        nanoseconds: typical_time(run, &case, &figure.engine),
        ours: ours.map(str::to_owned),
        over_ours: compared.map(|compared| {
            let (low, high) = compared.log.interval(0.95);
            [compared.log.median, low, high].map(f64::exp)
        }),
    }
}

impl Published {
    /// Set out as a page.
    pub fn page(&self) -> Page {
        let mut sheet = Sheet::new(&[
            "case",
            "program",
            "published",
            "here",
            "published over here",
            "ours here",
            "program over ours [95 %]",
            "source",
        ]);
        for row in &self.rows {
            let figure = &row.figure;
            let older = row.nanoseconds.map(|ns| 1e9 * figure.seconds / ns);
            let over_ours = row
                .over_ours
                .map(|[ratio, low, high]| ratio_text(ratio.ln(), (low.ln(), high.ln())));
            sheet.push(vec![
                format!("{} {}", figure.set, figure.n),
                figure.engine.clone(),
                format!("{} s", figure.seconds),
                time_text(row.nanoseconds),
                text(older.map(|ratio| format!("{ratio:.2}"))),
                text(row.ours.clone()),
                text(over_ours),
                figure.source.clone(),
            ]);
        }
        let measured = self.rows.iter().filter(|row| row.nanoseconds.is_some());
        Page {
            title: "Published times beside the same programs here".to_owned(),
            preface: vec![
                "The machines are not the same: what carries over is the order of programs and of point sets.".to_owned(),
            ],
            sections: vec![Section {
                heading: "Published and measured".to_owned(),
                sheet: sheet.clone(),
                notes: Vec::new(),
            }],
            long: sheet,
            headline: format!("{} of {} published times measured", measured.count(), self.rows.len()),
            value: json(self),
        }
    }
}
