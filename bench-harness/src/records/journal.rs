//! Rows appended one by one, so that a run that is killed has lost nothing but the line it was writing, and can
//! go on.
//!
//! Invariants:
//!
//! 1. Up to `length` the file is a header and whole lines.
//! 2. `keys` holds the keys of exactly these lines.
//! 3. The file is locked: nobody else appends.

use super::error::{Problem, RecordError};
use super::read::{self, Content};
use super::row::Row;
use super::write::{header, line};
use std::collections::HashSet;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, SeekFrom, Write};
use std::marker::PhantomData;
use std::path::{Path, PathBuf};

/// A file of a run that rows are appended to.
#[derive(Debug)]
pub struct Journal<R> {
    path: PathBuf,
    file: File,
    length: u64,
    keys: HashSet<String>,
    rows: PhantomData<R>,
}

/// What was in the file when it was opened.
#[derive(Clone, Debug)]
pub struct Recovered<R> {
    /// Its rows.
    pub rows: Vec<R>,
    /// A last line that was not whole, and is now gone.
    pub torn: Option<String>,
}

impl<R: Row> Journal<R> {
    /// Opens the file of `R` in `folder`, made if it is not there, and drops a torn last line.
    ///
    /// # Errors
    ///
    /// [`Problem::Locked`] if another process has it open; those of [`read::rows`].
    pub fn open(folder: &Path) -> Result<(Self, Recovered<R>), RecordError> {
        let path = folder.join(R::FILE);
        let fail = |error| RecordError::io(&path, error);
        let mut file = OpenOptions::new()
            .read(true)
            .write(true)
            .create(true)
            .truncate(false)
            .open(&path)
            .map_err(fail)?;
        match file.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                return Err(RecordError::new(&path, Problem::Locked));
            }
            Err(TryLockError::Error(error)) => return Err(fail(error)),
        }
        let mut text = Vec::new();
        file.read_to_end(&mut text).map_err(fail)?;
        let Content {
            rows,
            keys,
            torn,
            whole_bytes,
        } = read::parse::<R>(&path, &text)?;
        let mut journal = Self {
            path,
            file,
            length: whole_bytes,
            keys,
            rows: PhantomData,
        };
        journal.cut()?;
        if whole_bytes == 0 {
            journal.push(&header::<R>())?;
        }
        let rows = rows.into_iter().map(|numbered| numbered.row).collect();
        Ok((journal, Recovered { rows, torn }))
    }

    /// Appends `row`.
    ///
    /// # Errors
    ///
    /// [`Problem::Duplicate`] if its key is there, [`Problem::Shape`] if a name holds a line break,
    /// [`Problem::Io`]. After any of them the file is as before.
    pub fn append(&mut self, row: &R) -> Result<(), RecordError> {
        self.append_all(std::slice::from_ref(row))
    }

    /// Appends `rows`, in one write.
    ///
    /// # Errors
    ///
    /// As [`Journal::append`]; then none of them is there.
    pub fn append_all(&mut self, rows: &[R]) -> Result<(), RecordError> {
        let mut text = String::new();
        let mut new = HashSet::new();
        for row in rows {
            let key = row.key();
            if self.keys.contains(&key) || new.contains(&key) {
                return Err(RecordError::new(&self.path, Problem::Duplicate { key }));
            }
            new.insert(key);
            text +=
                &line(&row.fields()).map_err(|problem| RecordError::new(&self.path, problem))?;
        }
        self.push(&text)?;
        self.keys.extend(new);
        Ok(())
    }

    /// Whether a row with the key of `row` is there.
    pub fn contains(&self, row: &R) -> bool {
        self.keys.contains(&row.key())
    }

    /// Waits until everything appended is on the disk.
    ///
    /// # Errors
    ///
    /// [`Problem::Io`].
    pub fn sync(&self) -> Result<(), RecordError> {
        self.file
            .sync_data()
            .map_err(|error| RecordError::io(&self.path, error))
    }

    /// Appends whole lines; a failure on the way takes back what was written (1).
    fn push(&mut self, text: &str) -> Result<(), RecordError> {
        if let Err(error) = self.file.write_all(text.as_bytes()) {
            self.cut()?;
            return Err(RecordError::io(&self.path, error));
        }
        self.length += text.len() as u64;
        Ok(())
    }

    /// Drops what lies beyond the whole lines (1), and goes there.
    fn cut(&mut self) -> Result<(), RecordError> {
        self.file
            .set_len(self.length)
            .and_then(|()| self.file.seek(SeekFrom::Start(self.length)))
            .map(drop)
            .map_err(|error| RecordError::io(&self.path, error))
    }
}

impl<R> Drop for Journal<R> {
    /// Gives the lock back (3). Closing the file would not do while another thread is starting a process: until
    /// that process has begun, it holds a copy of the file, and the lock with it.
    fn drop(&mut self) {
        // Where it cannot be given back, it goes with the last copy.
        let _ = self.file.unlock();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::rows::{Case, Sample, Subject};
    use std::fs;
    use std::num::NonZeroU64;

    fn sample(round: u32, nanoseconds: u64) -> Sample {
        Sample {
            subject: Subject {
                case: Case {
                    definition: "d".into(),
                    set: "oblique:cols=2,rows=5".into(),
                    n: 10,
                },
                seed: 7,
                engine: "gs".into(),
            },
            round,
            inner: NonZeroU64::MIN,
            nanoseconds,
        }
    }

    #[test]
    fn a_killed_run_goes_on_at_every_byte_it_may_have_been_killed_at() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join(Sample::FILE);
        let (mut journal, _) = Journal::open(folder.path()).expect("open");
        let rows = [sample(0, 500), sample(1, 512), sample(2, 812_345)];
        journal.append_all(&rows).expect("appended");
        drop(journal);
        let whole = fs::read(&path).expect("a file");
        for length in 0..whole.len() {
            fs::write(&path, &whole[..length]).expect("cut");
            let (mut journal, recovered) = Journal::<Sample>::open(folder.path()).expect("open");
            assert!(rows.starts_with(&recovered.rows), "{length}");
            for row in &rows[recovered.rows.len()..] {
                assert!(!journal.contains(row), "{length}");
                journal.append(row).expect("appended");
            }
            drop(journal);
            assert_eq!(fs::read(&path).expect("a file"), whole, "cut at {length}");
        }
    }

    #[test]
    fn a_second_row_of_a_key_is_refused_and_leaves_the_file_as_it_was() {
        let folder = tempfile::tempdir().expect("a folder");
        let (mut journal, _) = Journal::open(folder.path()).expect("open");
        journal.append(&sample(0, 500)).expect("appended");
        let twice = journal.append_all(&[sample(1, 1), sample(0, 2)]);
        assert!(matches!(
            twice.expect_err("twice").problem,
            Problem::Duplicate { .. }
        ));
        journal.append(&sample(1, 3)).expect("appended");
        journal.sync().expect("synced");
        drop(journal);
        let (_, recovered) = Journal::<Sample>::open(folder.path()).expect("open");
        assert_eq!(recovered.rows, [sample(0, 500), sample(1, 3)]);
        assert!(recovered.torn.is_none());
    }

    #[test]
    fn two_writers_are_one_too_many() {
        let folder = tempfile::tempdir().expect("a folder");
        let first = Journal::<Sample>::open(folder.path()).expect("open");
        let second = Journal::<Sample>::open(folder.path());
        assert!(matches!(
            second.expect_err("locked").problem,
            Problem::Locked
        ));
        drop(first);
        assert!(Journal::<Sample>::open(folder.path()).is_ok());
    }
}
