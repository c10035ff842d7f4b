//! What goes wrong in a conversation with an engine.

use std::fmt;
use std::time::Duration;

/// Why an engine gave no answer. Each kind is an outcome that is recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It said no, and why. The conversation can go on.
    Refused {
        /// Its reason.
        reason: String,
    },
    /// It did not answer in time, and was killed.
    Timeout {
        /// The command that it did not answer.
        command: &'static str,
        /// The time it was given.
        limit: Duration,
    },
    /// It ended before it had answered.
    Crashed {
        /// How it ended.
        status: String,
        /// The end of what it wrote to standard error.
        stderr: String,
    },
    /// It answered, but not by the protocol, and was killed.
    Garbled {
        /// What was due.
        expected: String,
        /// What came.
        got: String,
    },
    /// It cannot be started.
    Absent {
        /// What is missing, and what to do.
        missing: String,
    },
}

impl Fault {
    /// The outcome in one word, as it is recorded.
    pub fn word(&self) -> &'static str {
        match self {
            Fault::Refused { .. } => "refused",
            Fault::Timeout { .. } => "timeout",
            Fault::Crashed { .. } => "crashed",
            Fault::Garbled { .. } => "garbled",
            Fault::Absent { .. } => "absent",
        }
    }

    /// Whether the engine is still there to be asked something else.
    pub fn leaves_it_running(&self) -> bool {
        matches!(self, Fault::Refused { .. })
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Refused { reason } => write!(f, "refused: {reason}"),
            Fault::Timeout { command, limit } => {
                write!(f, "no answer to '{command}' within {limit:?}")
            }
            Fault::Crashed { status, stderr } => {
                write!(f, "ended with {status}")?;
                // Rust ends with advice about backtraces.
                let says_something = |line: &&str| !line.is_empty() && !line.starts_with("note:");
                match stderr.lines().map(str::trim).rfind(says_something) {
                    Some(last) => write!(f, ": {last}"),
                    None => Ok(()),
                }
            }
            Fault::Garbled { expected, got } => write!(f, "expected {expected}, got {got}"),
            Fault::Absent { missing } => f.write_str(missing),
        }
    }
}

impl std::error::Error for Fault {}
