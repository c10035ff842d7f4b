//! Times that the authors of other programs print, if the run is about them.

use crate::analysis::published::published;
use crate::report::document::{Section, whole};
use crate::report::{Material, command};

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let found = published(material.run, material.figures);
    if found.rows.is_empty() {
        return None;
    }
    Some(Section {
        id: "published".into(),
        heading: "Published times".into(),
        commands: vec![command(material.run, "published", "")],
        parts: whole(&found.page()),
    })
}
