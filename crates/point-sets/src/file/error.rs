//! Why a file could not be read.

use super::columns::TakenColumn;
use std::fmt;
use std::path::PathBuf;
use thiserror::Error;

/// What is wrong with a file, and where.
///
/// Printed as `points.csv:12:7: field 2 (y): "1.2.3" is not a number; ...`: file, line and column as editors
/// and compilers write them, then the problem and its remedy.
#[derive(Debug, Error)]
#[error("{}", self.text())]
pub struct FileError {
    /// The file, as it was named.
    pub path: PathBuf,
    /// The place in it; `None` if the file could not be opened.
    pub place: Option<Box<Place>>,
    /// What is wrong there.
    pub problem: Problem,
}

/// A place in a text file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The line, from 1.
    pub line: u64,
    /// The character in the line, from 1; a byte order mark does not count.
    pub column: u64,
    /// The field at fault, if it is one field.
    pub field: Option<TakenColumn>,
}

/// What can be wrong with a file of points. Every message ends with a remedy.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Problem {
    /// The file cannot be opened.
    #[error("cannot be opened: {0}; check the name and the permissions")]
    Open(std::io::Error),
    /// Reading stopped in the middle.
    #[error("cannot be read on: {0}")]
    Read(std::io::Error),
    /// There is no point.
    #[error("no points: {found}; give one point a line, such as {example}")]
    Empty {
        /// What there is instead.
        found: &'static str,
        /// A point as it may be written.
        example: &'static str,
    },
    /// A byte is not part of UTF-8 text.
    #[error("byte 0x{byte:02x} is not UTF-8 text; save the file as UTF-8, without compression")]
    NotUtf8 {
        /// The byte.
        byte: u8,
    },
    /// A field is no number.
    #[error("{text:?} is not a number; {remedy}")]
    NotANumber {
        /// The field, shortened.
        text: String,
        /// What to write instead.
        remedy: &'static str,
    },
    /// A field is a number that is not finite, or too large for double precision.
    #[error("{text:?} is not a finite number; remove the line, or give a value up to 1.797e308")]
    NotFinite {
        /// The field, shortened.
        text: String,
    },
    /// A field is empty.
    #[error("the value is missing; fill it in or remove the line")]
    Missing,
    /// A line has more or fewer fields than the first.
    #[error(
        "{} where line {first_line} has {expected}; separate every line alike, and quote fields that hold \
         the separator {delimiter:?}",
        fields(*.found)
    )]
    Ragged {
        /// Fields in this line.
        found: usize,
        /// Fields in the first line.
        expected: usize,
        /// The first line's number.
        first_line: u64,
        /// What separates fields.
        delimiter: &'static str,
    },
    /// The first line may be a header or a point.
    #[error("{text:?} may be a header or a point, since {reason}; say which, or correct it")]
    Ambiguous {
        /// The line, shortened.
        text: String,
        /// Why it may be either.
        reason: &'static str,
    },
    /// A column asked for by name is not there.
    #[error("there is no column {name:?}{}; {}", suggestion(.nearest), available(.names))]
    NoSuchName {
        /// The name asked for.
        name: String,
        /// The most similar name, if one is similar.
        nearest: Option<String>,
        /// The header; empty if there is none.
        names: Vec<String>,
    },
    /// A column asked for by number is not there.
    #[error(
        "there is no column {number}; choose from 1 to {count}, or another separator than {delimiter:?}"
    )]
    NoSuchNumber {
        /// The number asked for.
        number: usize,
        /// How many columns there are.
        count: usize,
        /// What separates fields.
        delimiter: &'static str,
    },
    /// Fewer columns hold numbers than a point has coordinates.
    #[error(
        "{text:?} has {numeric} numeric of {}, and a point needs {needed}; choose the columns, or the separator \
         (now {delimiter:?})",
        fields(*.count)
    )]
    TooFewColumns {
        /// The line, shortened.
        text: String,
        /// Columns that hold numbers.
        numeric: usize,
        /// Coordinates of a point.
        needed: usize,
        /// Columns in all.
        count: usize,
        /// What separates fields.
        delimiter: &'static str,
    },
    /// A quoted field does not end.
    #[error(
        "a quote opens here and never closes; close it, or double a quote that belongs to the text"
    )]
    UnclosedQuote,
    /// Text follows the end of a quoted field.
    #[error("text follows a closed quote; double a quote that belongs to the text")]
    AfterQuote,
    /// More points than 32-bit indices can name.
    #[error("more than {limit} points, and no more can be indexed; split the file")]
    TooManyPoints {
        /// The most points there can be.
        limit: usize,
    },
}

impl FileError {
    fn text(&self) -> impl fmt::Display + '_ {
        struct Text<'a>(&'a FileError);
        impl fmt::Display for Text<'_> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{}:", self.0.path.display())?;
                if let Some(place) = &self.0.place {
                    write!(f, "{}:{}:", place.line, place.column)?;
                    if let Some(field) = &place.field {
                        write!(f, " {field}:")?;
                    }
                }
                write!(f, " {}", self.0.problem)
            }
        }
        Text(self)
    }
}

fn fields(count: usize) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} field{plural}")
}

fn suggestion(nearest: &Option<String>) -> String {
    nearest
        .as_ref()
        .map_or(String::new(), |name| format!(" (did you mean {name}?)"))
}

fn available(names: &[String]) -> String {
    if names.is_empty() {
        "without a header choose columns by number".to_owned()
    } else {
        format!("the header has {}", shortened(&names.join(", "), 200))
    }
}

/// At most `limit` characters of `text`.
pub(crate) fn shortened(text: &str, limit: usize) -> String {
    match text.char_indices().nth(limit) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}
