//! Where a run comes from: `manifest.json`.

use super::error::{Problem, RecordError};
use crate::output::atomic::{self, Existing};
use crate::output::rows::write_json;
use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;

/// Everything a reader needs to judge a run, and to run it again. What is not known is left out, never guessed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Manifest {
    /// The commit of the sources.
    pub commit: String,
    /// Whether the sources differ from it.
    pub dirty: bool,
    /// The compiler and its version.
    pub compiler: String,
    /// What it was told: profile, target, flags.
    pub flags: String,
    /// The processor's name.
    pub processor: String,
    /// Its cores.
    pub cores: usize,
    /// The memory, in bytes.
    pub memory: u64,
    /// The capacities of its data caches, the smallest first.
    pub caches: Vec<Cache>,
    /// The operating system's kernel.
    pub kernel: String,
    /// How the processor's frequency was governed, if that is known.
    pub governor: Option<String>,
    /// The load averages over 1, 5 and 15 minutes before the run.
    pub load_before: Option<[f64; 3]>,
    /// The same after it; none of a run that has not ended.
    pub load_after: Option<[f64; 3]>,
    /// The command line.
    pub command: String,
    /// When it started, RFC 3339.
    pub started: String,
    /// What was asked for.
    pub definitions: Vec<DefinitionStamp>,
    /// Who took part.
    pub engines: Vec<EngineStamp>,
}

/// A data cache.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Cache {
    /// L1, L2, L3, ...: 1, 2, 3, ...
    pub level: u8,
    /// Its capacity.
    pub bytes: u64,
}

/// A definition, and the digest that says which text of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct DefinitionStamp {
    /// Its id, as in the rows.
    pub id: String,
    /// SHA-256 of its text, in hexadecimal.
    pub sha256: String,
}

/// An engine, as it introduced itself.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct EngineStamp {
    /// Its name, as in the rows.
    pub name: String,
    /// Its version.
    pub version: String,
    /// The measured resolution of its clock, in nanoseconds.
    pub clock_ns: u64,
}

impl Manifest {
    /// The name of the file in the run's folder.
    pub const FILE: &'static str = "manifest.json";

    /// Reads the manifest of the run in `folder`.
    ///
    /// # Errors
    ///
    /// [`Problem::Io`], [`Problem::Manifest`] with the line.
    pub fn read(folder: &Path) -> Result<Self, RecordError> {
        let path = folder.join(Self::FILE);
        let text = fs::read(&path).map_err(|error| RecordError::io(&path, error))?;
        serde_json::from_slice(&text).map_err(|error| {
            RecordError::new(&path, Problem::Manifest(error.to_string())).at(error.line() as u64)
        })
    }

    /// Writes the manifest of the run in `folder`, whole or not at all, in the place of an older one.
    ///
    /// # Errors
    ///
    /// [`Problem::Io`].
    pub fn write(&self, folder: &Path) -> Result<(), RecordError> {
        let path = folder.join(Self::FILE);
        atomic::write(&path, Existing::Replace, |out| write_json(out, self))
            .map_err(|error| RecordError::io(&path, error))
    }
}
