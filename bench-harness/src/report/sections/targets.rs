//! What the fast methods are meant to take, if the run is about that.

use crate::analysis::targets::targets;
use crate::report::document::{Part, Section, Table};
use crate::report::{Material, command};

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let found = targets(material.run, material.targets);
    if found.rows.is_empty() {
        return None;
    }
    let page = found.page();
    let tables = page.sections.iter();
    let tables = tables.map(|section| Part::Table(Table::of(&section.heading, &section.sheet)));
    let head = page.preface.iter().chain([&page.headline]).map(Part::text);
    Some(Section {
        id: "targets".into(),
        heading: "Targets".into(),
        commands: vec![command(material.run, "targets", "")],
        parts: head.chain(tables).collect(),
    })
}
