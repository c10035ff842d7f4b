//! Files of a run, in. An error names the file, the line and the field.

use super::error::{Problem, RecordError};
use super::row::{Fields, Row};
use csv::StringRecord;
use std::collections::HashSet;
use std::fs;
use std::io;
use std::path::Path;

/// A row and the line of its file, from 1.
#[derive(Clone, Debug)]
pub struct Numbered<R> {
    /// The line.
    pub line: u64,
    /// The row.
    pub row: R,
}

/// The rows of a file, and what the file ends with.
#[derive(Clone, Debug)]
pub struct Content<R> {
    /// Every row that is there whole.
    pub rows: Vec<Numbered<R>>,
    /// The keys of these rows.
    pub keys: HashSet<String>,
    /// A last line without an end, which is no row: its writer was stopped in the middle of it.
    pub torn: Option<String>,
    /// How many bytes come before it.
    pub whole_bytes: u64,
}

/// The rows of the file of `R` in `folder`; none if there is no such file.
///
/// # Errors
///
/// [`RecordError`] for a file that cannot be read, another header, a field that holds what it must not hold, or a
/// key that occurs twice.
pub fn rows<R: Row>(folder: &Path) -> Result<Content<R>, RecordError> {
    let path = folder.join(R::FILE);
    let text = match fs::read(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Vec::new(),
        other => other.map_err(|error| RecordError::io(&path, error))?,
    };
    parse(&path, &text)
}

/// The rows in `text`, the content of the file at `path`.
///
/// # Errors
///
/// As [`rows`].
pub fn parse<R: Row>(path: &Path, text: &[u8]) -> Result<Content<R>, RecordError> {
    let end = text
        .iter()
        .rposition(|&byte| byte == b'\n')
        .map_or(0, |end| end + 1);
    let (whole, rest) = text.split_at(end);
    let mut content = Content {
        rows: Vec::new(),
        keys: HashSet::new(),
        torn: (!rest.is_empty()).then(|| String::from_utf8_lossy(rest).into_owned()),
        whole_bytes: end as u64,
    };
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .from_reader(whole);
    let mut record = StringRecord::new();
    let mut is_first = true;
    while reader
        .read_record(&mut record)
        .map_err(|error| not_csv(path, &error))?
    {
        let line = record.position().map_or(1, csv::Position::line);
        let fail = |problem| RecordError::new(path, problem).at(line);
        if is_first {
            is_first = false;
            check_header::<R>(&record).map_err(fail)?;
            continue;
        }
        check_width::<R>(&record).map_err(fail)?;
        let row = R::parse(&mut Fields::new(R::HEADER, &record)).map_err(fail)?;
        let key = row.key();
        if content.keys.contains(&key) {
            return Err(fail(Problem::Duplicate { key }));
        }
        content.keys.insert(key);
        content.rows.push(Numbered { line, row });
    }
    Ok(content)
}

fn check_header<R: Row>(record: &StringRecord) -> Result<(), Problem> {
    if record.iter().eq(R::HEADER.iter().copied()) {
        return Ok(());
    }
    Err(Problem::Header {
        expected: R::HEADER.join(","),
        found: record.iter().collect::<Vec<_>>().join(","),
    })
}

fn check_width<R: Row>(record: &StringRecord) -> Result<(), Problem> {
    let (found, wanted) = (record.len(), R::HEADER.len());
    if found == wanted {
        return Ok(());
    }
    let name = R::HEADER.get(found).map_or_else(String::new, |field| {
        format!(", the first that is missing is {field}")
    });
    Err(Problem::Shape(format!(
        "{found} fields in place of {wanted}{name}"
    )))
}

fn not_csv(path: &Path, error: &csv::Error) -> RecordError {
    let found = RecordError::new(path, Problem::Shape(error.to_string()));
    match error.position() {
        Some(position) => found.at(position.line()),
        None => found,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::rows::{Cell, Count, Sample};

    const SAMPLES: &str = "definition,set,n,seed,engine,round,inner,nanoseconds\n";

    fn error<R: Row + std::fmt::Debug>(text: &str) -> String {
        parse::<R>(Path::new("RUN/x.csv"), text.as_bytes())
            .expect_err("a bad file")
            .to_string()
    }

    #[test]
    fn an_error_names_file_line_and_field() {
        let two = format!("{SAMPLES}d,disc,10,1,gs,0,1,5\nd,disc,10,1,gs,1,0,5\n");
        assert_eq!(
            error::<Sample>(&two),
            "RUN/x.csv:3: field inner: \"0\" is not a number of calls, 1 or more"
        );
        let float = format!("{SAMPLES}d,disc,10,1,gs,0,1,5.5\n");
        assert!(error::<Sample>(&float).starts_with("RUN/x.csv:2: field nanoseconds: \"5.5\""));
        let short = format!("{SAMPLES}d,disc,10,1,gs,0\n");
        assert!(error::<Sample>(&short).starts_with(
            "RUN/x.csv:2: 6 fields in place of 8, the first that is missing is inner"
        ));
        let nameless = "definition,set,n,seed,engine,counter,value\nd,disc,10,1,,visits,5\n";
        assert!(error::<Count>(nameless).contains(":2: field engine"));
        let fate = "definition,set,n,seed,fingerprint,engine,outcome,h,facets,finding\n\
                    d,disc,10,1,ab,gs,fine,3,,\n";
        assert!(error::<Cell>(fate).contains(":2: field outcome: \"fine\""));
    }

    #[test]
    fn another_header_and_a_second_row_of_a_key_are_errors() {
        assert!(error::<Sample>("a,b\n").starts_with("RUN/x.csv:1: the header is \"a,b\""));
        let twice = format!("{SAMPLES}d,disc,10,1,gs,0,1,5\nd,disc,10,1,gs,0,1,6\n");
        assert!(
            error::<Sample>(&twice)
                .starts_with("RUN/x.csv:3: a second row of gs on d/disc n=10 seed 1, round 0")
        );
    }

    #[test]
    fn a_torn_last_line_is_no_row_even_if_it_reads_like_one() {
        let text = format!("{SAMPLES}d,disc,10,1,gs,0,1,5\nd,disc,10,1,gs,1,1,812");
        let content = parse::<Sample>(Path::new("x"), text.as_bytes()).expect("samples");
        assert_eq!(content.rows.len(), 1);
        assert_eq!(content.torn.as_deref(), Some("d,disc,10,1,gs,1,1,812"));
        let empty = parse::<Sample>(Path::new("x"), b"").expect("nothing");
        assert!(empty.rows.is_empty() && empty.torn.is_none());
    }
}
