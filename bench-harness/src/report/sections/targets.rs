//! What the fast methods are meant to take, if the run is about that.

use crate::analysis::targets::targets;
use crate::report::document::{Section, whole};
use crate::report::{Material, command};

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let found = targets(material.run, material.targets);
    if found.rows.is_empty() {
        return None;
    }
    Some(Section {
        id: "targets".into(),
        heading: "Targets".into(),
        commands: vec![command(material.run, "targets", "")],
        parts: whole(&found.page()),
    })
}
