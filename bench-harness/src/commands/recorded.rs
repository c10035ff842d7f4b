//! What the commands on recorded runs share: loading, and delivering an answer.

use crate::failure::Failure;
use crate::output::page::Page;
use crate::output::target::{OutputArgs, Report, note};
use crate::records::Run;
use std::path::Path;

/// Loads the run in `folder`, and says on standard error what a reader must know about it.
///
/// # Errors
///
/// [`Failure::Data`] with file, line and field; [`Failure::Io`].
pub fn load(folder: &Path) -> Result<Run, Failure> {
    if !folder.is_dir() {
        return Err(Failure::Io(format!(
            "{}: there is no such folder; give the folder of a recorded run",
            folder.display()
        )));
    }
    let run = Run::load(folder)?;
    for text in &run.notes {
        note(&format!("note: {}: {text}", folder.display()));
    }
    Ok(run)
}

/// Writes `page` as asked.
///
/// # Errors
///
/// Those of [`OutputArgs::delivery`] and of writing.
pub fn deliver(page: &Page, output: &OutputArgs) -> Result<(), Failure> {
    output.delivery(Page::FORMATS)?.send(page)
}

/// The failure to find `wanted` of this `kind` among `known`.
pub fn unknown(kind: &str, wanted: &str, known: &[&str]) -> Failure {
    Failure::Usage(format!(
        "no {kind} of this run is called '{wanted}'; there are {}",
        if known.is_empty() {
            "none".to_owned()
        } else {
            known.join(", ")
        }
    ))
}
