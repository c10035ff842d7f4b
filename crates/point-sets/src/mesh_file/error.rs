//! Why a mesh file could not be read.

use std::fmt;
use std::path::PathBuf;
use thiserror::Error;

/// What is wrong with a mesh file, and where.
///
/// Printed as `hull.off:3:5: "x" where a coordinate is expected`: file, line and column, then the problem.
#[derive(Debug, Error)]
#[error("{}:{} {problem}", .path.display(), Shown(*.place))]
pub struct MeshFileError {
    /// The file, as it was named.
    pub path: PathBuf,
    /// The place in it; `None` if the file was not opened.
    pub place: Option<MeshPlace>,
    /// What is wrong there.
    pub problem: MeshProblem,
}

/// A place in a mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshPlace {
    /// A character of a text.
    Text {
        /// The line, from 1.
        line: usize,
        /// The character in the line, from 1.
        column: usize,
    },
    /// A byte of a binary body, from 0.
    Byte(usize),
}

/// A problem and where it is.
pub(super) type Failure = (MeshPlace, MeshProblem);

/// What can be wrong with a mesh file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MeshProblem {
    /// The file cannot be opened or read.
    #[error("cannot be read: {0}; check the name and the permissions")]
    Open(std::io::Error),
    /// The extension names no format that can be read.
    #[error("the extension names no mesh format that can be read; use .off, .obj or .ply")]
    NoFormat,
    /// A byte is not part of UTF-8 text.
    #[error("a byte is not UTF-8 text; save the file as text, without compression")]
    NotUtf8,
    /// Something else stands where something is expected.
    #[error("{found:?} where {expected} is expected")]
    Expected {
        /// What is expected.
        expected: &'static str,
        /// What is there, shortened.
        found: String,
    },
    /// The line or the file ends where something is expected.
    #[error("the {what} ends where {expected} is expected")]
    Ends {
        /// `line` or `file`.
        what: &'static str,
        /// What is expected.
        expected: &'static str,
    },
    /// A coordinate is NaN, infinite, or too large for double precision.
    #[error("{found:?} is not finite; every coordinate must be")]
    NotFinite {
        /// The coordinate, shortened.
        found: String,
    },
    /// A corner names no point.
    #[error("corner {found} is none of the {count} points")]
    NoSuchPoint {
        /// The index as written.
        found: String,
        /// How many points there are.
        count: usize,
    },
    /// A polygon has fewer than three corners.
    #[error("a polygon of {count} corners; a polygon has at least three")]
    FewCorners {
        /// How many it has.
        count: usize,
    },
    /// The format is right, but a kind of it that is not read.
    #[error("{what} cannot be read; {remedy}")]
    Unsupported {
        /// The kind.
        what: String,
        /// What to do.
        remedy: &'static str,
    },
}

struct Shown(Option<MeshPlace>);

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            None => Ok(()),
            Some(MeshPlace::Text { line, column }) => write!(f, "{line}:{column}:"),
            Some(MeshPlace::Byte(byte)) => write!(f, " byte {byte}:"),
        }
    }
}
