//! The records of a text file, one at a time, each with its place.

use super::delimiter::{Delimiter, SplitError};
use super::error::{Place, Problem};
use std::io::BufRead;
use std::ops::Range;

/// A problem and where it is.
pub(super) type Failure = (Option<Place>, Problem);

/// A quoted field longer than this is taken for a quote never closed.
const LONGEST_QUOTE: usize = 1 << 16;

/// Reads records one after another into one buffer.
pub(super) struct Records<R> {
    source: R,
    delimiter: Option<Delimiter>,
    /// The lines of the current record, line ends between them.
    text: String,
    /// Where its fields are in `text`.
    fields: Vec<Range<usize>>,
    /// The line in which it begins.
    first_line: u64,
    /// The line read last.
    line: u64,
}

/// One record: the fields of a line, or of several if a quoted field holds line ends.
#[derive(Clone, Copy)]
pub(super) struct Record<'a> {
    pub(super) text: &'a str,
    pub(super) fields: &'a [Range<usize>],
    pub(super) line: u64,
    pub(super) delimiter: Delimiter,
}

impl<R: BufRead> Records<R> {
    /// The records of `source`, split by `delimiter`, or by what the first record shows.
    pub(super) fn new(source: R, delimiter: Option<Delimiter>) -> Self {
        Records {
            source,
            delimiter,
            text: String::new(),
            fields: Vec::new(),
            first_line: 0,
            line: 0,
        }
    }

    /// The line read last.
    pub(super) fn line(&self) -> u64 {
        self.line
    }

    /// The next record, or `None` at the end. Blank lines and comment lines are passed over.
    pub(super) fn next(&mut self) -> Result<Option<Record<'_>>, Failure> {
        loop {
            self.text.clear();
            if !self.append_line()? {
                return Ok(None);
            }
            let content = self.text.trim_ascii_start();
            if !(content.is_empty() || content.starts_with('#') || content.starts_with("//")) {
                break;
            }
        }
        self.first_line = self.line;
        let delimiter = *self
            .delimiter
            .get_or_insert_with(|| Delimiter::detect(&self.text));
        loop {
            match delimiter.split(&self.text, &mut self.fields) {
                Ok(()) => break,
                Err(SplitError::AfterQuote(at)) => {
                    return Err((Some(self.record(delimiter).place(at)), Problem::AfterQuote));
                }
                Err(SplitError::Unclosed(at)) => {
                    let place = self.record(delimiter).place(at);
                    self.text.push('\n');
                    if self.text.len() - at > LONGEST_QUOTE || !self.append_line()? {
                        return Err((Some(place), Problem::UnclosedQuote));
                    }
                }
            }
        }
        Ok(Some(self.record(delimiter)))
    }

    fn record(&self, delimiter: Delimiter) -> Record<'_> {
        Record {
            text: &self.text,
            fields: &self.fields,
            line: self.first_line,
            delimiter,
        }
    }

    /// Appends the next line to the record, without its end; `false` if there is none.
    fn append_line(&mut self) -> Result<bool, Failure> {
        let start = self.text.len();
        let mut bytes = std::mem::take(&mut self.text).into_bytes();
        let read = self.source.read_until(b'\n', &mut bytes);
        let here = |column| Place {
            line: self.line + 1,
            column,
            field: None,
        };
        if read.map_err(|error| (Some(here(1)), Problem::Read(error)))? == 0 {
            // Only whole lines of text are ever kept, so this is what was taken out above.
            self.text = String::from_utf8(bytes).unwrap_or_default();
            return Ok(false);
        }
        trim_line_end(&mut bytes, start);
        if self.line == 0 && bytes.starts_with(BYTE_ORDER_MARK) {
            bytes.drain(..BYTE_ORDER_MARK.len());
        }
        self.text = String::from_utf8(bytes).map_err(|error| {
            let valid = error.utf8_error().valid_up_to();
            let byte = error.as_bytes()[valid];
            let before = String::from_utf8_lossy(&error.as_bytes()[start..valid]);
            let column = before.chars().count() as u64 + 1;
            (Some(here(column)), Problem::NotUtf8 { byte })
        })?;
        self.line += 1;
        Ok(true)
    }
}

const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

fn trim_line_end(bytes: &mut Vec<u8>, start: usize) {
    for end in [b'\n', b'\r'] {
        if bytes.len() > start && bytes.last() == Some(&end) {
            bytes.pop();
        }
    }
}

impl<'a> Record<'a> {
    /// How many fields there are.
    pub(super) fn len(self) -> usize {
        self.fields.len()
    }

    /// The text of field `index`, from 0, without quotes.
    pub(super) fn value(self, index: usize) -> &'a str {
        let raw = &self.text[self.fields[index].clone()];
        match raw.strip_prefix('"') {
            Some(quoted) => quoted.strip_suffix('"').unwrap_or(quoted).trim(),
            None => raw,
        }
    }

    /// The texts of all fields, doubled quotes made single.
    pub(super) fn names(self) -> Vec<String> {
        (0..self.len())
            .map(|index| self.value(index).replace("\"\"", "\""))
            .collect()
    }

    /// The place of the byte at this offset.
    pub(super) fn place(self, offset: usize) -> Place {
        let before = &self.text[..offset];
        let line_start = before.rfind('\n').map_or(0, |end| end + 1);
        Place {
            line: self.line + before.matches('\n').count() as u64,
            column: before[line_start..].chars().count() as u64 + 1,
            field: None,
        }
    }
}
