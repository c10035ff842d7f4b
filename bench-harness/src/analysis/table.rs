//! Times and counts in the layout of a paper: a table a point set, a row a size, a column an engine.

use super::{h_text, text, time_text, typical_time};
use crate::output::page::{Page, Section};
use crate::output::sheet::Sheet;
use crate::records::{Case, Outcome, Run};
use crate::stats::summary::mean;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// What stands in one place of a table.
#[derive(Clone, Debug, PartialEq)]
enum Entry {
    /// A number: nanoseconds, or the mean of a count.
    Value(f64),
    /// Why there is none.
    Without(Outcome),
    /// It was not asked for.
    Nothing,
}

/// One table.
#[derive(Clone, Debug)]
struct Layout {
    definition: String,
    set: String,
    /// What is in it: nanoseconds, or a counter.
    quantity: String,
    engines: Vec<String>,
    /// n, h and an entry an engine.
    rows: Vec<(usize, String, Vec<Entry>)>,
}

/// The tables of a run.
#[derive(Clone, Debug)]
pub struct Tables {
    layouts: Vec<Layout>,
}

/// The table of times of every point set, and one for each of `counters`.
pub fn table(run: &Run, counters: &[String]) -> Tables {
    let counts = mean_counts(run, counters);
    let outcomes: BTreeMap<(&Case, &str), Outcome> = run
        .cells
        .iter()
        .filter(|cell| cell.outcome != Outcome::Certified)
        .map(|cell| {
            (
                (&cell.subject.case, cell.subject.engine.as_str()),
                cell.outcome,
            )
        })
        .collect();
    let missing = |case: &Case, engine: &str| {
        let outcome = outcomes.get(&(case, engine));
        outcome.map_or(Entry::Nothing, |outcome| Entry::Without(*outcome))
    };
    let time = |case: &Case, engine: &str| match typical_time(run, case, engine) {
        Some(time) => Entry::Value(time),
        None => missing(case, engine),
    };
    let mut layouts = Vec::new();
    for (definition, set) in sets(run) {
        let of_set =
            |case: &&Case| (case.definition.as_str(), case.set.as_str()) == (definition, set);
        let cases: Vec<&Case> = run.cases().into_iter().filter(of_set).collect();
        layouts.extend(layout(run, &cases, "nanoseconds", time));
        for counter in counters {
            let count = |case: &Case, engine: &str| {
                let found = counts.get(&(case, engine, counter.as_str()));
                found.map_or_else(|| missing(case, engine), |mean| Entry::Value(*mean))
            };
            layouts.extend(layout(run, &cases, counter, count));
        }
    }
    Tables { layouts }
}

fn sets(run: &Run) -> BTreeSet<(&str, &str)> {
    let cases = run.cases().into_iter();
    cases
        .map(|case| (case.definition.as_str(), case.set.as_str()))
        .collect()
}

/// The mean of each counter over the realisations.
fn mean_counts<'a>(
    run: &'a Run,
    counters: &[String],
) -> BTreeMap<(&'a Case, &'a str, &'a str), f64> {
    let mut values: BTreeMap<(&Case, &str, &str), Vec<f64>> = BTreeMap::new();
    for count in &run.counts {
        if counters.contains(&count.counter) {
            let key = (
                &count.subject.case,
                count.subject.engine.as_str(),
                count.counter.as_str(),
            );
            values.entry(key).or_default().push(count.value as f64);
        }
    }
    let means = values.into_iter();
    means.map(|(key, values)| (key, mean(&values))).collect()
}

/// The table of `cases`, which differ in n alone; `None` if it would hold no number.
fn layout(
    run: &Run,
    cases: &[&Case],
    quantity: &str,
    entry: impl Fn(&Case, &str) -> Entry,
) -> Option<Layout> {
    let first = cases.first()?;
    let counted = cases.iter().flat_map(|case| run.counted(case));
    let timed = cases.iter().flat_map(|case| run.timed(case));
    let engines: BTreeSet<&str> = timed.chain(counted).collect();
    let has_number = |engine: &&str| {
        cases
            .iter()
            .any(|case| matches!(entry(case, engine), Entry::Value(_)))
    };
    let engines: Vec<&str> = engines.into_iter().filter(has_number).collect();
    let row = |case: &&Case| {
        let entries = engines.iter().map(|engine| entry(case, engine)).collect();
        (case.n, h_text(run.h(case)), entries)
    };
    let rows = cases.iter().map(row).collect();
    (!engines.is_empty()).then(|| Layout {
        definition: first.definition.clone(),
        set: first.set.clone(),
        quantity: quantity.to_owned(),
        engines: engines.into_iter().map(str::to_owned).collect(),
        rows,
    })
}

impl Tables {
    /// The answer for readers and programs.
    pub fn page(&self) -> Page {
        Page {
            title: "Tables".into(),
            preface: vec![
                "Times: the median over realisations of the median time of a call. Counts: the mean over realisations. \
                 The least of a row is bold."
                    .into(),
            ],
            sections: self.layouts.iter().map(Layout::section).collect(),
            long: self.long(),
            value: Value::Array(self.layouts.iter().map(Layout::value).collect()),
            headline: format!("{} tables", self.layouts.len()),
        }
    }

    fn long(&self) -> Sheet {
        let mut sheet = Sheet::new(&[
            "definition",
            "set",
            "n",
            "h",
            "engine",
            "quantity",
            "value",
            "outcome",
        ]);
        for layout in &self.layouts {
            for (n, h, entries) in &layout.rows {
                for (engine, entry) in layout.engines.iter().zip(entries) {
                    let (value, outcome) = match entry {
                        Entry::Value(value) => (Some(value), None),
                        Entry::Without(outcome) => (None, Some(outcome)),
                        Entry::Nothing => continue,
                    };
                    sheet.push(vec![
                        layout.definition.clone(),
                        layout.set.clone(),
                        n.to_string(),
                        h.clone(),
                        engine.clone(),
                        layout.quantity.clone(),
                        text(value),
                        text(outcome),
                    ]);
                }
            }
        }
        sheet
    }
}

impl Layout {
    fn section(&self) -> Section {
        let mut columns = vec!["n", "h"];
        columns.extend(self.engines.iter().map(String::as_str));
        let mut sheet = Sheet::new(&columns);
        for (n, h, entries) in &self.rows {
            let least = entries
                .iter()
                .filter_map(Entry::value)
                .fold(f64::INFINITY, f64::min);
            let mut row = vec![n.to_string(), h.clone()];
            row.extend(entries.iter().map(|entry| match entry {
                Entry::Value(value) if *value <= least => format!("**{}**", self.shown(*value)),
                Entry::Value(value) => self.shown(*value),
                Entry::Without(outcome) => outcome.to_string(),
                Entry::Nothing => String::new(),
            }));
            sheet.push(row);
        }
        Section {
            heading: format!("{}/{}: {}", self.definition, self.set, self.quantity),
            sheet,
            notes: Vec::new(),
        }
    }

    fn shown(&self, value: f64) -> String {
        match self.quantity.as_str() {
            "nanoseconds" => time_text(Some(value)),
            _ => format!("{value:.1}"),
        }
    }

    fn value(&self) -> Value {
        let row = |(n, h, entries): &(usize, String, Vec<Entry>)| {
            let by_engine = self.engines.iter().zip(entries);
            let values: Map<String, Value> = by_engine
                .map(|(engine, entry)| (engine.clone(), json!(entry.value())))
                .collect();
            json!({"n": n, "h": h, "values": values})
        };
        json!({
            "definition": self.definition,
            "set": self.set,
            "quantity": self.quantity,
            "rows": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }
}

impl Entry {
    fn value(&self) -> Option<f64> {
        match self {
            Entry::Value(value) => Some(*value),
            Entry::Without(_) | Entry::Nothing => None,
        }
    }
}
