//! What can be wrong with a run folder.

use crate::failure::Failure;
use std::fmt;
use std::io;
use std::path::PathBuf;

/// A file of a run that cannot be used: which, where in it, and why.
#[derive(Debug)]
pub struct RecordError {
    /// The file.
    pub path: PathBuf,
    /// The line, from 1, if one is to blame.
    pub line: Option<u64>,
    /// What is wrong.
    pub problem: Problem,
}

/// What is wrong with a file of a run.
#[derive(Debug)]
pub enum Problem {
    /// It cannot be read or written.
    Io(io::Error),
    /// Another process is appending to it.
    Locked,
    /// It is no CSV, or a line has more or fewer fields than the header.
    Shape(String),
    /// Its first line is not the header of this kind of file.
    Header {
        /// What it should be.
        expected: String,
        /// What it is.
        found: String,
    },
    /// A field holds what it must not hold.
    Field {
        /// Its column.
        field: &'static str,
        /// What it holds.
        found: String,
        /// What it should hold.
        wanted: &'static str,
    },
    /// A key that an earlier line has.
    Duplicate {
        /// The key.
        key: String,
    },
    /// A sample of a cell that is not certified.
    Uncertified {
        /// The cell.
        cell: String,
    },
    /// The manifest is not what it should be.
    Manifest(String),
}

impl RecordError {
    /// The problem `problem` of the file `path`, at no line in particular.
    pub fn new(path: impl Into<PathBuf>, problem: Problem) -> Self {
        let path = path.into();
        Self {
            path,
            line: None,
            problem,
        }
    }

    /// The same problem at `line`.
    #[must_use]
    pub fn at(mut self, line: u64) -> Self {
        self.line = Some(line);
        self
    }

    /// What the operating system said about `path`.
    pub fn io(path: impl Into<PathBuf>, error: io::Error) -> Self {
        Self::new(path, Problem::Io(error))
    }
}

impl fmt::Display for RecordError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.path.display())?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        write!(f, ": {}", self.problem)
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Problem::Io(error) => {
                let text = error.to_string();
                let text = text.split(" (os error").next().unwrap_or_default();
                write!(
                    f,
                    "{}; check the name and the permissions",
                    text.to_lowercase()
                )
            }
            Problem::Locked => f.write_str(
                "another process is appending to it; let it end, or write to another folder",
            ),
            Problem::Shape(what) => write!(f, "{what}; each line needs the fields of the header"),
            Problem::Header { expected, found } => write!(
                f,
                "the header is {found:?} where it should be {expected:?}; is this a run folder of this version?"
            ),
            Problem::Field {
                field,
                found,
                wanted,
            } => write!(f, "field {field}: {found:?} is not {wanted}"),
            Problem::Duplicate { key } => {
                write!(f, "a second row of {key}; a key occurs once in a file")
            }
            Problem::Uncertified { cell } => write!(
                f,
                "a sample of {cell}, which has no certificate in cells.csv; only certified cells are timed"
            ),
            Problem::Manifest(what) => write!(f, "no manifest: {what}"),
        }
    }
}

impl std::error::Error for RecordError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.problem {
            Problem::Io(error) => Some(error),
            _ => None,
        }
    }
}

/// A file that cannot be read or written is [`Failure::Io`]; anything else about it is [`Failure::Data`].
impl From<RecordError> for Failure {
    fn from(error: RecordError) -> Self {
        let message = error.to_string();
        match error.problem {
            Problem::Io(_) | Problem::Locked => Failure::Io(message),
            _ => Failure::Data(message),
        }
    }
}
