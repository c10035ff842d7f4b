//! What a row is to a file: the file's name, its header, the row's key and fields.

use super::error::Problem;
use csv::StringRecord;
use std::str::FromStr;

/// A row of a file of a run.
pub trait Row: Sized {
    /// The name of the file in the run's folder.
    const FILE: &'static str;

    /// The names of its columns, in order.
    const HEADER: &'static [&'static str];

    /// What identifies the row among those of its file, readable.
    fn key(&self) -> String;

    /// Its fields, in the order of the header. Only free text may hold line breaks; see [`one_line`].
    fn fields(&self) -> Vec<String>;

    /// The row that has these fields.
    ///
    /// # Errors
    ///
    /// [`Problem::Field`] for the first field that holds what it must not hold.
    fn parse(fields: &mut Fields<'_>) -> Result<Self, Problem>;
}

/// The fields of a line, taken one after the other in the order of the header.
#[derive(Debug)]
pub struct Fields<'a> {
    header: &'static [&'static str],
    record: &'a StringRecord,
    next: usize,
}

impl<'a> Fields<'a> {
    /// The fields of `record`, which has as many as `header`.
    pub fn new(header: &'static [&'static str], record: &'a StringRecord) -> Self {
        Self {
            header,
            record,
            next: 0,
        }
    }

    fn take(&mut self) -> (&'static str, &'a str) {
        let place = self.next;
        self.next += 1;
        (
            self.header.get(place).copied().unwrap_or("?"),
            self.record.get(place).unwrap_or_default(),
        )
    }

    /// The next field as it is.
    pub fn text(&mut self) -> String {
        self.take().1.to_owned()
    }

    /// The next field, which must not be empty.
    ///
    /// # Errors
    ///
    /// [`Problem::Field`].
    pub fn name(&mut self) -> Result<String, Problem> {
        match self.take() {
            (field, "") => Err(not_a(field, "", "a name")),
            (_, text) => Ok(text.to_owned()),
        }
    }

    /// The next field as `wanted`.
    ///
    /// # Errors
    ///
    /// [`Problem::Field`].
    pub fn parse<T: FromStr>(&mut self, wanted: &'static str) -> Result<T, Problem> {
        let (field, text) = self.take();
        text.parse().map_err(|_| not_a(field, text, wanted))
    }

    /// The next field as `wanted`, or nothing if it is empty.
    ///
    /// # Errors
    ///
    /// [`Problem::Field`].
    pub fn optional<T: FromStr>(&mut self, wanted: &'static str) -> Result<Option<T>, Problem> {
        let (field, text) = self.take();
        if text.is_empty() {
            return Ok(None);
        }
        let value = text.parse().map_err(|_| not_a(field, text, wanted))?;
        Ok(Some(value))
    }
}

fn not_a(field: &'static str, found: &str, wanted: &'static str) -> Problem {
    let found = found.to_owned();
    Problem::Field {
        field,
        found,
        wanted,
    }
}

/// `text` on one line, so that a line of a file is a row: breaks become ` | `.
pub fn one_line(text: &str) -> String {
    let lines = text
        .lines()
        .map(str::trim_end)
        .filter(|line| !line.is_empty());
    lines.collect::<Vec<_>>().join(" | ")
}
