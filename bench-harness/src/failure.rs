//! Why the program stops early, and the exit code that says so.

use point_sets::file::{FileError, Problem};
use point_sets::mesh_file::{MeshFileError, MeshProblem};
use std::fmt;
use std::io;
use std::process::ExitCode;

/// What stopped a command. Each kind has its own exit code; each message says what is wrong and what to do.
#[derive(Debug)]
pub enum Failure {
    /// Exit code 1: a result could not be certified, a claim does not hold, or a run got worse.
    Verification(String),
    /// Exit code 2: the command line asks for something that does not exist.
    Usage(String),
    /// Exit code 3: the input data is not what it should be.
    Data(String),
    /// Exit code 4: a file could not be read or written.
    Io(String),
    /// Exit code 0: whoever reads our output has read enough.
    Closed,
}

impl Failure {
    /// The failure of reading or writing `what`, with `remedy` for the user.
    pub fn io(what: impl fmt::Display, error: &io::Error, remedy: &str) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Failure::Closed;
        }
        Failure::Io(format!("{what}: {}; {remedy}", plain(error)))
    }

    /// The exit code of the process.
    pub fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self {
            Failure::Closed => 0,
            Failure::Verification(_) => 1,
            Failure::Usage(_) => 2,
            Failure::Data(_) => 3,
            Failure::Io(_) => 4,
        })
    }
}

/// What the operating system said, without its error number.
fn plain(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or_default();
    text.to_lowercase()
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Verification(message)
            | Failure::Usage(message)
            | Failure::Data(message)
            | Failure::Io(message) => f.write_str(message),
            Failure::Closed => f.write_str("the reader of the output is gone"),
        }
    }
}

impl std::error::Error for Failure {}

/// A file that cannot be opened or read on is [`Failure::Io`]; anything else about it is [`Failure::Data`].
impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        let message = error.to_string();
        match error.problem {
            Problem::Open(_) | Problem::Read(_) => Failure::Io(message),
            _ => Failure::Data(message),
        }
    }
}

/// A file that cannot be opened is [`Failure::Io`]; anything else about it is [`Failure::Data`].
impl From<MeshFileError> for Failure {
    fn from(error: MeshFileError) -> Self {
        let message = error.to_string();
        match error.problem {
            MeshProblem::Open(_) => Failure::Io(message),
            _ => Failure::Data(message),
        }
    }
}

/// Classifies by the causes: a [`Failure`] keeps its kind, a [`FileError`] has its own, an [`io::Error`] is
/// [`Failure::Io`], and anything else is taken for bad input data.
impl From<anyhow::Error> for Failure {
    fn from(error: anyhow::Error) -> Self {
        let error = match error.downcast::<Failure>() {
            Ok(failure) => return failure,
            Err(other) => other,
        };
        let error = match error.downcast::<FileError>() {
            Ok(error) => return error.into(),
            Err(other) => other,
        };
        let message = format!("{error:#}");
        let io_kind = error
            .chain()
            .find_map(|cause| cause.downcast_ref::<io::Error>())
            .map(io::Error::kind);
        match io_kind {
            Some(io::ErrorKind::BrokenPipe) => Failure::Closed,
            Some(_) => Failure::Io(message),
            None => Failure::Data(message),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::Context;

    #[test]
    fn a_failure_keeps_its_kind_through_anyhow() {
        let error = anyhow::Error::from(Failure::Verification("a claim is refuted".into()));
        assert!(matches!(Failure::from(error), Failure::Verification(_)));
    }

    #[test]
    fn an_io_error_is_found_under_its_context() {
        let error = Err::<(), _>(io::Error::from(io::ErrorKind::PermissionDenied))
            .context("reports/x")
            .unwrap_err();
        let failure = Failure::from(error);
        assert!(matches!(&failure, Failure::Io(message) if message.starts_with("reports/x: ")));
    }

    #[test]
    fn a_broken_pipe_is_no_error() {
        let error = anyhow::Error::from(io::Error::from(io::ErrorKind::BrokenPipe));
        assert!(matches!(Failure::from(error), Failure::Closed));
        let broken = io::Error::from(io::ErrorKind::BrokenPipe);
        assert!(matches!(
            Failure::io("stdout", &broken, ""),
            Failure::Closed
        ));
    }
}
