//! What ran, what became of it, what to be careful about, and what it was for.

use crate::records::{Outcome, Run, Warning};
use crate::report::Material;
use crate::report::document::{Part, Section, Table};
use std::collections::{BTreeMap, BTreeSet};

/// Warnings beyond this many are folded.
const FEW: usize = 8;

pub(in crate::report) fn section(material: &Material<'_>) -> Section {
    let run = material.run;
    let mut parts = vec![Part::text(extent(run)), Part::Table(outcomes(run))];
    parts.extend(not_there(run));
    parts.extend(warnings(run));
    for id in run.definitions() {
        parts.extend(question(material, id));
    }
    let commands = run.manifest.command.split("; ").map(str::to_owned);
    Section {
        id: "overview".into(),
        heading: "Overview".into(),
        commands: commands.filter(|command| !command.is_empty()).collect(),
        parts,
    }
}

/// How much was done, in a sentence.
fn extent(run: &Run) -> String {
    let subjects = run.cells.iter().map(|cell| &cell.subject);
    let engines: BTreeSet<&str> = subjects
        .clone()
        .filter(|subject| subject.twin_of().is_none())
        .map(|subject| subject.engine.as_str())
        .collect();
    let realisations: BTreeSet<_> = subjects
        .map(|subject| (&subject.case, subject.seed))
        .collect();
    format!(
        "{} engines, {} cases (a point set at one size), {} realisations of them, {} samples of time. Begun {}.",
        engines.len(),
        run.cases().len(),
        realisations.len(),
        run.samples.len(),
        match run.manifest.started.as_str() {
            "" => "at a time not recorded",
            started => started,
        }
    )
}

fn outcomes(run: &Run) -> Table {
    let meanings = [
        (Outcome::Certified, "proved right, then timed"),
        (Outcome::Wrong, "proved wrong"),
        (Outcome::Refused, "declined, with a reason"),
        (Outcome::Timeout, "given up after its limit"),
        (Outcome::Crashed, "ended before it answered"),
        (Outcome::Garbled, "answered what is no answer"),
        (Outcome::Absent, "not built on this machine"),
    ];
    let mut table = Table::new("Outcomes", &["outcome", "cells", "meaning"]);
    for (outcome, meaning) in meanings {
        let count = run
            .cells
            .iter()
            .filter(|cell| cell.outcome == outcome)
            .count();
        if count > 0 {
            table.push(&[&outcome.to_string(), &count.to_string(), meaning]);
        }
    }
    table
}

/// The engines that were not built.
fn not_there(run: &Run) -> Option<Part> {
    let absent = run
        .cells
        .iter()
        .filter(|cell| cell.outcome == Outcome::Absent);
    let names: BTreeSet<&str> = absent.map(|cell| cell.subject.engine.as_str()).collect();
    let names: Vec<&str> = names.into_iter().collect();
    (!names.is_empty()).then(|| {
        Part::text(format!(
            "Not built on this machine: {}. They are built by: hullbench peers build.",
            names.join(", ")
        ))
    })
}

/// Warnings of a kind together: the first, and how many there are.
fn warnings(run: &Run) -> Option<Part> {
    let mut kinds: BTreeMap<(&str, &str), Vec<&Warning>> = BTreeMap::new();
    for warning in &run.warnings {
        let kind = warning.warning.split(':').next().unwrap_or_default();
        kinds
            .entry((kind, &warning.remedy))
            .or_default()
            .push(warning);
    }
    let mut table = Table::new("Warnings", &["warning", "where", "cells", "what to do"]);
    for ((_, remedy), of_kind) in &kinds {
        let first = of_kind[0];
        let place = match of_kind.len() {
            1 => format!("{}, {}", first.subject.case, first.subject.engine),
            _ => format!("first {}, {}", first.subject.case, first.subject.engine),
        };
        table.push(&[&first.warning, &place, &of_kind.len().to_string(), remedy]);
    }
    let part = match table.rows.len() {
        0 => return None,
        few if few <= FEW => Part::Table(table),
        many => Part::Fold {
            summary: format!("{many} kinds of warnings"),
            parts: vec![Part::Table(table)],
        },
    };
    Some(part)
}

/// What a definition asks, and who was left out of it.
fn question(material: &Material<'_>, id: &str) -> Vec<Part> {
    let mut parts = vec![Part::heading(format!("Definition: {id}"))];
    let Some(asked) = material.asked.iter().find(|asked| asked.id == id) else {
        parts.push(Part::text(
            "The text of this definition does not lie with the run.",
        ));
        return parts;
    };
    parts.push(Part::text(asked.question.trim()));
    if !asked.left_out.is_empty() {
        let mut table = Table::new("Left out", &["engine", "why"]);
        for (engine, reason) in &asked.left_out {
            table.push(&[engine, reason]);
        }
        parts.push(Part::Table(table));
    }
    parts
}
