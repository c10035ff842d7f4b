//! How much memory a call takes.

use crate::records::Count;
use crate::report::document::{Entry, Part, Section, Table};
use crate::report::matrix::{matrix, short};
use crate::report::{Material, command};
use crate::stats::summary::median;
use std::collections::BTreeMap;

/// What the protocol calls it.
pub(in crate::report) const COUNTER: &str = "peak_bytes";

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let run = material.run;
    let mut values: BTreeMap<_, Vec<f64>> = BTreeMap::new();
    let of = |count: &&Count| count.counter == COUNTER;
    for count in run.counts.iter().filter(of) {
        let key = (&count.subject.case, count.subject.engine.as_str());
        values.entry(key).or_default().push(count.value as f64);
    }
    let tables = run.definitions().into_iter().filter_map(|id| {
        matrix(
            run,
            id,
            &format!("{id}: peak of memory, in KiB"),
            |case, engine| {
                let bytes = values.get(&(case, engine))?;
                Some(Entry::new(&short(median(bytes) / 1024.0)))
            },
        )
    });
    let tables: Vec<Table> = tables.collect();
    (!tables.is_empty()).then(|| Section {
        id: "memory".into(),
        heading: "Memory".into(),
        commands: vec![command(run, "table", &format!("--counter {COUNTER}"))],
        parts: std::iter::once(Part::text(
            "By how much the resident memory of the process rose in its first call, in whole pages: result and work \
             space, without the points and without code. Memory that the process had freed before and uses again does not show.",
        ))
        .chain(tables.into_iter().map(Part::Table))
        .collect(),
    })
}
