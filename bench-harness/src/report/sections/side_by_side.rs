//! The engines side by side: one matrix a definition, then every case with its intervals.

use crate::analysis::cmp::cmp;
use crate::report::document::{Part, Section, answer};
use crate::report::matrix::ratios;
use crate::report::{Material, command};

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let run = material.run;
    let answered = cmp(run, material.baseline);
    let page = answered.page();
    if answered.rows.is_empty() {
        return None;
    }
    let mut parts: Vec<Part> = page.preface.iter().map(Part::text).collect();
    let against = match material.baseline {
        Some(baseline) => format!("{baseline}, or the fastest where it was not timed"),
        None => "the fastest engine of the row".to_owned(),
    };
    parts.push(Part::text(format!(
        "In the tables below the baseline is {against}; its own time stands in parentheses. Bold: not slower than the \
         baseline by more than the band. h is the number of vertices of the hull, over the realisations."
    )));
    let by_case: Vec<_> = answered
        .rows
        .chunk_by(|a, b| a.case == b.case)
        .zip(&page.sections)
        .collect();
    for id in run.definitions() {
        let Some(table) = ratios(run, &answered, id) else {
            continue;
        };
        parts.push(Part::heading(id));
        parts.push(Part::Table(table));
        let of = by_case
            .iter()
            .filter(|(rows, _)| rows[0].case.definition == id);
        parts.push(Part::Fold {
            summary: format!("{id}, case by case: times, ratios with 95 % intervals, standings"),
            parts: of.flat_map(|(_, section)| answer(section)).collect(),
        });
    }
    let option = material
        .baseline
        .map_or_else(String::new, |name| format!("--baseline {name}"));
    Some(Section {
        id: "side-by-side".into(),
        heading: "Side by side".into(),
        commands: vec![command(run, "cmp", &option)],
        parts,
    })
}
