//! Where definitions lie: below `data/definitions/` of the checkout, or as built into the program.

use crate::failure::Failure;
use include_dir::{Dir, include_dir};
use std::collections::BTreeMap;
use std::path::Path;

/// The folder in a checkout.
const FOLDER: &str = "data/definitions";

/// The definitions as built into the program.
pub(crate) static BUILT_IN: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../data/definitions");

/// The text of a definition and where it lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Source {
    pub(crate) path: String,
    pub(crate) text: String,
}

/// Every definition in the folder `within` of `data/definitions`, by path; none if there is no such folder.
///
/// # Errors
///
/// A file that cannot be read.
pub(crate) fn all(within: &str) -> Result<Vec<Source>, Failure> {
    let checkout = Path::new(FOLDER);
    let mut found = BTreeMap::new();
    if checkout.is_dir() {
        let folder = checkout.join(within);
        if folder.is_dir() {
            collect(&folder, &mut found)?;
        }
    } else {
        for file in BUILT_IN.get_dir(within).into_iter().flat_map(Dir::files) {
            let path = format!("{FOLDER}/{}", file.path().display());
            if let Some(text) = file.contents_utf8().filter(|_| path.ends_with(".toml")) {
                found.insert(path, text.to_owned());
            }
        }
    }
    let source = |(path, text)| Source { path, text };
    Ok(found.into_iter().map(source).collect())
}

/// The file at `path`, given on the command line.
///
/// # Errors
///
/// A file that cannot be read.
pub(crate) fn at(path: &str) -> Result<Source, Failure> {
    let text = read(Path::new(path))?;
    let path = path.to_owned();
    Ok(Source { path, text })
}

fn collect(folder: &Path, found: &mut BTreeMap<String, String>) -> Result<(), Failure> {
    let remedy = "is this a whole checkout?";
    let failed = |error: &std::io::Error| Failure::io(folder.display(), error, remedy);
    for entry in std::fs::read_dir(folder).map_err(|error| failed(&error))? {
        let path = entry.map_err(|error| failed(&error))?.path();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            found.insert(path.display().to_string(), read(&path)?);
        }
    }
    Ok(())
}

fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path)
        .map_err(|error| Failure::io(path.display(), &error, "is it a readable text file?"))
}
