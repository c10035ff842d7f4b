//! The folder of a report. Every file in it begins with where it comes from.

use crate::output::atomic::{self, Existing};
use crate::reproduce::provenance::Provenance;
use anyhow::{Context, Result};
use std::path::PathBuf;

/// The folder a report is written to.
#[derive(Debug)]
pub(crate) struct Folder {
    path: PathBuf,
    provenance: Provenance,
}

impl Folder {
    /// Opens the folder at `path`, made if it is not there.
    pub(crate) fn open(path: PathBuf, provenance: Provenance) -> Result<Self> {
        std::fs::create_dir_all(&path).with_context(|| format!("{}", path.display()))?;
        Ok(Self { path, provenance })
    }

    /// Writes a Markdown file: title, origin, body.
    pub(crate) fn markdown(&self, name: &str, title: &str, body: &str) -> Result<()> {
        self.write(
            name,
            &format!("# {title}\n\n{}\n{body}", self.provenance.markdown()),
        )
    }

    /// Writes a CSV file: origin in comment lines, then `text`.
    pub(crate) fn csv(&self, name: &str, text: &str) -> Result<()> {
        self.write(name, &format!("{}{text}", self.provenance.comment("# ")))
    }

    /// Writes an SVG file: origin and title as its description, then the drawing.
    pub(crate) fn svg(&self, name: &str, title: &str, drawing: &str) -> Result<()> {
        let escape = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;");
        let description = format!(
            "<title>{}</title>\n<desc>\n{}</desc>",
            escape(title),
            escape(&self.provenance.comment(""))
        );
        let text = match drawing.split_once('>') {
            Some((open, rest)) => format!("{open}>\n{description}{rest}"),
            None => drawing.to_owned(),
        };
        self.write(name, &text)
    }

    /// Where the folder is.
    pub(crate) fn path(&self) -> &std::path::Path {
        &self.path
    }

    fn write(&self, name: &str, text: &str) -> Result<()> {
        let path = self.path.join(name);
        atomic::write(&path, Existing::Replace, |out| {
            out.write_all(text.as_bytes())
        })
        .with_context(|| format!("{}", path.display()))
    }
}
