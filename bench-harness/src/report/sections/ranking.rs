//! The engines over all cases of a definition.

use crate::analysis::rank::rank;
use crate::report::document::{Part, Section, Table};
use crate::report::{Material, command};

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let run = material.run;
    let mut parts = Vec::new();
    let mut commands = Vec::new();
    for id in run.definitions() {
        let ranked = rank(&run.only(id));
        if ranked.ranked.is_empty() {
            continue;
        }
        let page = ranked.page();
        if parts.is_empty() {
            parts.extend(page.preface.iter().skip(1).map(Part::text));
        }
        for section in &page.sections {
            let caption = format!("{id}: {}", section.heading);
            parts.push(Part::Table(Table::of(caption, &section.sheet)));
        }
        commands.push(command(run, "rank", &format!("--definition {id}")));
    }
    (!parts.is_empty()).then(|| Section {
        id: "ranks".into(),
        heading: "Ranks".into(),
        commands,
        parts,
    })
}
