//! What the commands on recorded runs share: loading, and delivering an answer.

use crate::failure::Failure;
use crate::output::page::Page;
use crate::output::target::{OutputArgs, Report, note};
use crate::records::{Manifest, Run};
use std::fs;
use std::path::{Path, PathBuf};

/// Where runs are recorded if nothing else is said.
const RUNS: &str = "runs";

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

/// The run below `runs/` that was written last.
///
/// # Errors
///
/// [`Failure::Io`] if there is none.
pub fn latest() -> Result<PathBuf, Failure> {
    let written = |folder: PathBuf| {
        let manifest = fs::metadata(folder.join(Manifest::FILE)).ok()?;
        Some((manifest.modified().ok()?, folder))
    };
    let folders = fs::read_dir(RUNS).into_iter().flatten().flatten();
    let latest = folders.filter_map(|entry| written(entry.path())).max();
    latest.map(|(_, folder)| folder).ok_or_else(|| {
        Failure::Io(format!(
            "{RUNS}/: no recorded run; give the folder of one, or make one with `hullbench measure`"
        ))
    })
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
