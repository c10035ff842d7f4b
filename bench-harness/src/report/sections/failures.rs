//! Who fails where: every engine on every point set, and what was found.

use crate::analysis::cmp::{Uncertified, cmp};
use crate::records::{Cell, Outcome, Run};
use crate::report::document::{Entry, Part, Section, Table};
use crate::report::{Material, command};
use std::collections::{BTreeMap, BTreeSet};

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let run = material.run;
    if run.cells.is_empty() {
        return None;
    }
    let mut parts = vec![Part::text(
        "Certified cells of all cells of an engine on a point set, over sizes and realisations; below what stands there \
         instead. An engine that was not built is left out.",
    )];
    parts.extend(
        run.definitions()
            .into_iter()
            .filter_map(|id| who_where(run, id))
            .map(Part::Table),
    );
    parts.push(match findings(run) {
        Some(table) => Part::Table(table),
        None => Part::text("No engine that is built failed anywhere."),
    });
    Some(Section {
        id: "failures".into(),
        heading: "Who fails where".into(),
        commands: vec![command(run, "cmp", "")],
        parts,
    })
}

/// A row an engine, a column a point set.
fn who_where(run: &Run, id: &str) -> Option<Table> {
    let present = |cell: &&Cell| {
        let subject = &cell.subject;
        subject.case.definition == id
            && subject.twin_of().is_none()
            && cell.outcome != Outcome::Absent
    };
    let cells: Vec<&Cell> = run.cells.iter().filter(present).collect();
    let sets: BTreeSet<&str> = cells
        .iter()
        .map(|cell| cell.subject.case.set.as_str())
        .collect();
    let engines: BTreeSet<&str> = cells
        .iter()
        .map(|cell| cell.subject.engine.as_str())
        .collect();
    let mut columns = vec!["engine"];
    columns.extend(&sets);
    let mut table = Table::new(
        format!("{id}: certified of all, engine by point set"),
        &columns,
    );
    for engine in engines {
        let on = |set: &&str| {
            let of = cells
                .iter()
                .filter(|cell| cell.subject.engine == engine && cell.subject.case.set == *set);
            entry(&of.map(|cell| cell.outcome).collect::<Vec<_>>())
        };
        let row = std::iter::once(Entry::new(engine)).chain(sets.iter().map(on));
        table.rows.push(row.collect());
    }
    (!table.rows.is_empty()).then_some(table)
}

/// `6/6`, or `4/6: wrong, timeout`.
fn entry(outcomes: &[Outcome]) -> Entry {
    let failed: BTreeSet<Outcome> = outcomes
        .iter()
        .copied()
        .filter(|o| *o != Outcome::Certified)
        .collect();
    let certified = outcomes
        .iter()
        .filter(|o| **o == Outcome::Certified)
        .count();
    let share = format!("{certified}/{}", outcomes.len());
    match (outcomes.len(), failed.len()) {
        (0, _) => Entry::new("–"),
        (_, 0) => Entry::new(&share),
        _ => {
            let names: Vec<String> = failed.iter().map(ToString::to_string).collect();
            Entry::failed(format!("{share}: {}", names.join(", ")))
        }
    }
}

/// What was found, but for engines that are not built: the sizes of a point set that have the same finding together.
fn findings(run: &Run) -> Option<Table> {
    let columns = ["engine", "set", "n", "outcome", "realisations", "finding"];
    let mut table = Table::new("What was found", &columns);
    let mut rows = cmp(run, None).uncertified;
    rows.retain(|row| row.outcome != Outcome::Absent.to_string());
    let mut alike: BTreeMap<[&str; 5], Vec<&Uncertified>> = BTreeMap::new();
    for row in &rows {
        let case = &row.case;
        let key = [
            &row.engine,
            &case.definition,
            &case.set,
            &row.outcome,
            &row.finding,
        ];
        alike.entry(key.map(String::as_str)).or_default().push(row);
    }
    for ([engine, definition, set, outcome, finding], rows) in &alike {
        let sizes: BTreeSet<usize> = rows.iter().map(|row| row.case.n).collect();
        let sizes: Vec<String> = sizes.iter().map(ToString::to_string).collect();
        let realisations: usize = rows.iter().map(|row| row.realisations).sum();
        table.push(&[
            engine,
            &format!("{definition}/{set}"),
            &sizes.join(", "),
            outcome,
            &realisations.to_string(),
            finding,
        ]);
    }
    (!table.rows.is_empty()).then_some(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_names_what_failed() {
        let all = entry(&[Outcome::Certified; 3]);
        assert!(all.text == "3/3" && !all.failed);
        let some = entry(&[
            Outcome::Certified,
            Outcome::Timeout,
            Outcome::Wrong,
            Outcome::Wrong,
        ]);
        assert!(some.text == "1/4: wrong, timeout" && some.failed);
        assert_eq!(entry(&[]).text, "–");
    }
}
