//! What is wrong with a definition, and where.

use std::fmt;

/// A fault at a place of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Fault {
    path: String,
    line: usize,
    column: usize,
    what: String,
}

impl Fault {
    /// A fault at byte `offset` of `text`.
    pub(crate) fn new(path: &str, text: &str, offset: usize, what: &str) -> Self {
        let before = text.get(..offset).unwrap_or(text);
        let last = before.rsplit('\n').next().unwrap_or_default();
        Self {
            path: path.to_owned(),
            line: before.matches('\n').count() + 1,
            column: last.chars().count() + 1,
            what: what.to_owned(),
        }
    }

    /// What the TOML reader says: bad syntax, an unknown, missing or mistyped key.
    pub(crate) fn of_toml(path: &str, text: &str, error: &toml::de::Error) -> Self {
        let offset = error.span().map_or(0, |span| span.start);
        Self::new(path, text, offset, error.message())
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}:{}:{}: {}",
            self.path, self.line, self.column, self.what
        )
    }
}

impl std::error::Error for Fault {}
