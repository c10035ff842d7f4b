//! Tables under one title, with what there is to say about them: the answer to one question about recorded runs.

use super::rows::write_json;
use super::sheet::Sheet;
use super::target::{Format, Report};
use serde::Serialize;
use std::io::{self, Write};

/// An answer: to be read as text, and by programs.
#[derive(Clone, Debug)]
pub struct Page {
    /// What it answers.
    pub title: String,
    /// What a reader must know first, a paragraph each.
    pub preface: Vec<String>,
    /// The tables for reading.
    pub sections: Vec<Section>,
    /// Everything in one table, unrounded: the CSV form.
    pub long: Sheet,
    /// Everything as one value: the JSON form.
    pub value: serde_json::Value,
    /// The answer in a few words.
    pub headline: String,
}

/// A table with a heading and notes.
#[derive(Clone, Debug)]
pub struct Section {
    /// Its heading.
    pub heading: String,
    /// The table.
    pub sheet: Sheet,
    /// What there is to say about it, a line each.
    pub notes: Vec<String>,
}

impl Page {
    /// As Markdown, which reads as plain text too.
    pub fn markdown(&self) -> String {
        let mut text = format!("# {}\n", self.title);
        for paragraph in &self.preface {
            text += &format!("\n{paragraph}\n");
        }
        for section in &self.sections {
            text += &format!("\n## {}\n\n", section.heading);
            if !section.sheet.is_empty() {
                text += &section.sheet.markdown();
            }
            for note in &section.notes {
                text += &format!("\n- {note}");
            }
            if !section.notes.is_empty() {
                text += "\n";
            }
        }
        text
    }

    fn latex(&self) -> String {
        let mut text = format!("% {}\n", self.title);
        for section in &self.sections {
            text += &format!("\n% {}\n{}", section.heading, section.sheet.latex());
        }
        text
    }
}

/// `value` as JSON. What these analyses hold always has a JSON form; a value that had none would be null.
pub fn json(value: &impl Serialize) -> serde_json::Value {
    serde_json::to_value(value).unwrap_or_default()
}

impl Report for Page {
    const FORMATS: &'static [Format] =
        &[Format::Markdown, Format::Csv, Format::Json, Format::Latex];

    fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()> {
        match format {
            Format::Markdown => out.write_all(self.markdown().as_bytes()),
            Format::Csv => out.write_all(self.long.csv().as_bytes()),
            Format::Json => write_json(out, &self.value),
            Format::Latex => out.write_all(self.latex().as_bytes()),
            _ => format.refuse(),
        }
    }

    fn write_summary(&self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(self.markdown().as_bytes())
    }

    fn headline(&self) -> String {
        self.headline.clone()
    }
}
