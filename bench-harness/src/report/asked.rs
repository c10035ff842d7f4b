//! What a run was to find out: the texts of its definitions, which lie with it.
//!
//! Only what a reader is told is read, so that a run of an older or a newer program can be reported too.

use crate::failure::Failure;
use crate::records::DEFINITIONS;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A definition, as far as a reader is told of it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(default)]
pub struct Asked {
    /// Its name, as in the rows.
    pub id: String,
    /// What it is to find out.
    pub question: String,
    /// Engines that do not take part, each with the reason.
    pub left_out: BTreeMap<String, String>,
}

/// The definitions that lie with the run in `folder`, by name; none if it keeps no texts.
///
/// # Errors
///
/// [`Failure::Data`] for a text that is no TOML, [`Failure::Io`].
pub fn of_run(folder: &Path) -> Result<Vec<Asked>, Failure> {
    let folder = folder.join(DEFINITIONS);
    let fail = |path: &Path, error| Failure::io(path.display(), &error, "check the permissions");
    let mut asked = Vec::new();
    if !folder.is_dir() {
        return Ok(asked);
    }
    for entry in fs::read_dir(&folder).map_err(|error| fail(&folder, error))? {
        let path = entry.map_err(|error| fail(&folder, error))?.path();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            let text = fs::read_to_string(&path).map_err(|error| fail(&path, error))?;
            let found = toml::from_str(&text).map_err(|error| {
                Failure::Data(format!("{}: {}", path.display(), error.message()))
            })?;
            asked.push(found);
        }
    }
    asked.sort_by(|a: &Asked, b| a.id.cmp(&b.id));
    Ok(asked)
}
