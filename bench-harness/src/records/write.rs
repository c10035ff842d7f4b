//! Whole files of a run, out. A file appears whole or not at all.

use super::error::{Problem, RecordError};
use super::row::Row;
use crate::output::atomic::{self, Existing};
use std::collections::HashSet;
use std::path::Path;

/// Writes the file of `R` in `folder` with these rows, in the place of an older one.
///
/// # Errors
///
/// [`Problem::Duplicate`] if two rows have the same key, [`Problem::Shape`] if a name holds a line break,
/// [`Problem::Io`].
pub fn rows<R: Row>(folder: &Path, rows: &[R]) -> Result<(), RecordError> {
    let path = folder.join(R::FILE);
    let fail = |problem| RecordError::new(&path, problem);
    let mut text = header::<R>();
    let mut keys = HashSet::new();
    for row in rows {
        let key = row.key();
        if keys.contains(&key) {
            return Err(fail(Problem::Duplicate { key }));
        }
        keys.insert(key);
        text += &line(&row.fields()).map_err(fail)?;
    }
    atomic::write(&path, Existing::Replace, |out| {
        out.write_all(text.as_bytes())
    })
    .map_err(|error| RecordError::io(&path, error))
}

/// The first line of the file of `R`.
pub(super) fn header<R: Row>() -> String {
    R::HEADER.join(",") + "\n"
}

/// The line that holds `fields`.
pub(super) fn line(fields: &[String]) -> Result<String, Problem> {
    if let Some(field) = fields.iter().find(|field| field.contains(['\n', '\r'])) {
        return Err(Problem::Shape(format!("{field:?} holds a line break")));
    }
    let quoted = fields.iter().map(|field| {
        if field.contains([',', '"']) {
            format!("\"{}\"", field.replace('"', "\"\""))
        } else {
            field.clone()
        }
    });
    Ok(quoted.collect::<Vec<_>>().join(",") + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::read;
    use crate::records::rows::{Case, Cell, Outcome, Subject};

    fn cell(set: &str, engine: &str, finding: &str) -> Cell {
        Cell {
            subject: Subject {
                case: Case {
                    definition: "d".into(),
                    set: set.into(),
                    n: 100,
                },
                seed: u64::MAX,
                engine: engine.into(),
            },
            fingerprint: "ab".into(),
            outcome: Outcome::Crashed,
            h: None,
            facets: Some(4),
            finding: finding.into(),
        }
    }

    #[test]
    fn what_is_written_reads_back() {
        let folder = tempfile::tempdir().expect("a folder");
        let rows_in = [
            cell("oblique:cols=10,rows=10", "gs", "says \"no\", and ends"),
            cell("disc", "gs", ""),
        ];
        rows(folder.path(), &rows_in).expect("written");
        let back = read::rows::<Cell>(folder.path()).expect("read");
        let back: Vec<Cell> = back.rows.into_iter().map(|numbered| numbered.row).collect();
        assert_eq!(back, rows_in);
    }

    #[test]
    fn text_of_several_lines_becomes_one_and_a_name_must_be_one() {
        let folder = tempfile::tempdir().expect("a folder");
        rows(folder.path(), &[cell("disc", "gs", "panic\r\n\n at 5\n")]).expect("written");
        let back = read::rows::<Cell>(folder.path()).expect("read");
        assert_eq!(back.rows[0].row.finding, "panic |  at 5");
        let broken = rows(folder.path(), &[cell("di\nsc", "gs", "")]);
        assert!(matches!(
            broken.expect_err("broken").problem,
            Problem::Shape(_)
        ));
    }

    #[test]
    fn a_key_occurs_once() {
        let folder = tempfile::tempdir().expect("a folder");
        let twice = rows(
            folder.path(),
            &[cell("disc", "gs", "a"), cell("disc", "gs", "b")],
        );
        assert!(matches!(
            twice.expect_err("twice").problem,
            Problem::Duplicate { .. }
        ));
        assert!(!folder.path().join(Cell::FILE).exists());
    }
}
