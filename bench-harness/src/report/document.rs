//! What a report consists of.

use crate::output::page;
use crate::output::sheet::Sheet;
use serde::Serialize;

/// A report.
#[derive(Clone, Debug, Serialize)]
pub struct Document {
    /// Its title.
    pub title: String,
    /// What it is, in a paragraph.
    pub lead: String,
    /// Its sections, in order.
    pub sections: Vec<Section>,
}

/// A section.
#[derive(Clone, Debug, Serialize)]
pub struct Section {
    /// Its name in links.
    pub id: String,
    /// Its heading.
    pub heading: String,
    /// The commands that give what is in it.
    pub commands: Vec<String>,
    /// What is in it.
    pub parts: Vec<Part>,
}

/// A piece of a section.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Part {
    /// A heading below the section's.
    Heading {
        /// What it says.
        text: String,
    },
    /// A paragraph.
    Text {
        /// What it says.
        text: String,
    },
    /// Short notes.
    Notes {
        /// A line each.
        items: Vec<String>,
    },
    /// A table.
    Table(Table),
    /// A drawing.
    Figure {
        /// SVG.
        svg: String,
        /// What it shows.
        caption: String,
    },
    /// A link to a file beside the report.
    Link {
        /// Where to.
        href: String,
        /// What it says.
        text: String,
    },
    /// Details that are shown on demand, and in print.
    Fold {
        /// What is always shown.
        summary: String,
        /// The details.
        parts: Vec<Part>,
    },
}

/// A table whose first column names the rows.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// The names of its columns.
    pub columns: Vec<String>,
    /// Its rows.
    pub rows: Vec<Vec<Entry>>,
}

/// A cell of a table.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Entry {
    /// What it says.
    pub text: String,
    /// The best of its row.
    pub strong: bool,
    /// Set to the right: it begins as a number does.
    pub number: bool,
    /// An engine that did not come to an answer that is right.
    pub failed: bool,
}

impl Part {
    /// A paragraph.
    pub fn text(text: impl Into<String>) -> Self {
        Part::Text { text: text.into() }
    }

    /// A heading.
    pub fn heading(text: impl Into<String>) -> Self {
        Part::Heading { text: text.into() }
    }
}

/// A number with its interval is no longer; what is longer is a sentence that begins with one.
const LONGEST_NUMBER: usize = 24;

impl Entry {
    /// A cell that says `text`; between two pairs of stars it is the best of its row.
    pub fn new(text: &str) -> Self {
        let bold = text
            .strip_prefix("**")
            .and_then(|rest| rest.strip_suffix("**"));
        let plain = bold.unwrap_or(text).replace("\\|", "|");
        let begins = plain.trim_start_matches(['-', '+', '−']).chars().next();
        Self {
            number: begins.is_some_and(|first| first.is_ascii_digit())
                && plain.chars().count() <= LONGEST_NUMBER,
            strong: bold.is_some(),
            failed: false,
            text: plain,
        }
    }

    /// An engine that failed.
    pub fn failed(text: String) -> Self {
        Self {
            text,
            strong: false,
            number: false,
            failed: true,
        }
    }
}

impl Table {
    /// A table with these columns and no rows.
    pub fn new(caption: impl Into<String>, columns: &[&str]) -> Self {
        Self {
            caption: caption.into(),
            columns: columns.iter().map(|column| (*column).to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row of texts.
    pub fn push(&mut self, texts: &[&str]) {
        self.rows
            .push(texts.iter().map(|text| Entry::new(text)).collect());
    }

    /// `sheet`, as it is.
    pub fn of(caption: impl Into<String>, sheet: &Sheet) -> Self {
        let entries = |row: &Vec<String>| row.iter().map(|text| Entry::new(text)).collect();
        Self {
            caption: caption.into(),
            columns: sheet.columns().to_vec(),
            rows: sheet.rows().iter().map(entries).collect(),
        }
    }

    /// The same table with the columns that tell the rows apart, the first `lead`, and those called `columns`; `None` if there
    /// is no such column.
    pub fn only(&self, lead: usize, columns: &[&str]) -> Option<Self> {
        let place = |name: &&str| self.columns.iter().position(|column| column == name);
        let named: Option<Vec<usize>> = columns.iter().map(place).collect();
        let places: Vec<usize> = (0..lead).chain(named?).collect();
        let rows = self
            .rows
            .iter()
            .map(|row| places.iter().map(|&i| row[i].clone()).collect());
        Some(Self {
            caption: self.caption.clone(),
            columns: places.iter().map(|&i| self.columns[i].clone()).collect(),
            rows: rows.collect(),
        })
    }

    /// As Markdown.
    pub fn markdown(&self) -> String {
        self.sheet().markdown()
    }

    /// As a sheet, the best of a row between two pairs of stars.
    pub fn sheet(&self) -> Sheet {
        let columns: Vec<&str> = self.columns.iter().map(String::as_str).collect();
        let mut sheet = Sheet::new(&columns);
        for row in &self.rows {
            let shown = |entry: &Entry| match entry.strong {
                true => format!("**{}**", entry.text),
                false => entry.text.clone(),
            };
            sheet.push(row.iter().map(shown).collect());
        }
        sheet
    }
}

/// The preface of an answer, the answer in a few words, and its tables.
pub fn whole(page: &page::Page) -> Vec<Part> {
    let head = page.preface.iter().chain([&page.headline]);
    let tables = page.sections.iter().flat_map(answer);
    head.map(Part::text).chain(tables).collect()
}

/// A section of an answer: its table, headed as there, and its notes.
pub fn answer(section: &page::Section) -> Vec<Part> {
    let mut parts = Vec::new();
    if !section.sheet.is_empty() {
        parts.push(Part::Table(Table::of(&section.heading, &section.sheet)));
    }
    if !section.notes.is_empty() {
        let items = section.notes.clone();
        parts.push(Part::Notes { items });
    }
    parts
}
