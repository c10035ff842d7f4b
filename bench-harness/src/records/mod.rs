//! A run on disk: what was measured, by which engine, on which points, and on which machine.
//!
//! ```text
//! RUN/manifest.json   where the run comes from: commit, compiler, machine, load, engines
//! RUN/cells.csv       what became of each engine on each point set, certified or not
//! RUN/samples.csv     every sample, in integer nanoseconds; append-only
//! RUN/counts.csv      exact integers of separate, untimed runs
//! RUN/warnings.csv    what to be careful about
//! RUN/definitions/    the texts of the definitions, ID.toml
//! ```
//!
//! A key occurs once in a file: definition, set, n, seed and engine, and with it the round of a sample, the
//! counter of a count, the text of a warning. A sample of a cell without a certificate does not exist. Everything
//! that is said about a run is computed from this folder.
//!
//! | module | holds |
//! |---|---|
//! | [`rows`] | the rows, typed |
//! | [`row`] | what a row is to a file: its name, its header, its key |
//! | [`manifest`] | where a run comes from |
//! | [`read`] | files in, with errors that name file, line and field |
//! | [`write`](mod@write) | whole files out |
//! | [`journal`] | rows appended one by one, so that a killed run can go on |
//! | [`run`] | a loaded folder, and views of it; `part`: the rows of one definition |
//! | [`error`] | what can be wrong with a folder |

pub mod error;
pub mod journal;
pub mod manifest;
mod part;
pub mod read;
pub mod row;
pub mod rows;
pub mod run;
pub mod write;

/// The folder, in a run's, of the texts of its definitions.
pub const DEFINITIONS: &str = "definitions";

pub use error::{Problem, RecordError};
pub use journal::{Journal, Recovered};
pub use manifest::Manifest;
pub use row::Row;
pub use rows::{Case, Cell, Count, Outcome, Sample, Subject, Warning};
pub use run::{Realisation, Run, Spread, TwinPair};
