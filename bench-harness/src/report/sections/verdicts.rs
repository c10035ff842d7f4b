//! The papers: verdicts on their claims, and their tables beside ours.

use crate::report::Material;
use crate::report::document::{Part, Section, Table};
use crate::report::papers::Paper;

pub(in crate::report) fn section(material: &Material<'_>) -> Option<Section> {
    let papers = material.papers;
    (!papers.is_empty()).then(|| Section {
        id: "papers".into(),
        heading: "The papers".into(),
        commands: vec!["hullbench reproduce".into()],
        parts: papers.iter().flat_map(paper).collect(),
    })
}

fn paper(paper: &Paper) -> Vec<Part> {
    let named = |table: &Table| Table {
        caption: format!("{}: {}", paper.title, table.caption.to_lowercase()),
        ..table.clone()
    };
    let mut parts = vec![Part::heading(&paper.title)];
    parts.extend(paper.verdicts.iter().map(named).map(Part::Table));
    parts.push(Part::Fold {
        summary: "Every part of every claim".into(),
        parts: vec![Part::Table(named(&paper.parts))],
    });
    for (title, tables) in &paper.tables {
        parts.push(Part::Fold {
            summary: title.clone(),
            parts: tables.iter().cloned().map(Part::Table).collect(),
        });
    }
    parts.push(Part::Link {
        href: paper.report.to_string_lossy().into_owned(),
        text: format!("The whole report on {}", paper.title),
    });
    parts
}
