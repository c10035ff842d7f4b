//! A gate without a clock: the exact counts of a fixed small suite must be those in `data/expected/counts.csv`.
//!
//! Counts are the same on every machine, so one more question an insertion shows anywhere, in seconds. `gate` compares and
//! fails on any difference, for better or for worse; `bless` writes what is counted now, to be committed with the
//! change that made it so.

mod suite;

use crate::failure::Failure;
use crate::output::atomic::{Existing, write};
use crate::output::sheet::Sheet;
use crate::output::target::to_stdout;
use anyhow::Result;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::path::PathBuf;
use suite::Counts;

/// The options of `hullbench gate` and `hullbench bless`.
#[derive(clap::Args, Clone, Debug)]
pub struct Args {
    /// The expected counts
    #[arg(long, value_name = "FILE", default_value = "data/expected/counts.csv")]
    expected: PathBuf,
}

/// Compares the counts of every method with the expected ones.
///
/// # Errors
///
/// A count that differs, is missing or is new; a file that cannot be read.
pub fn gate(args: &Args) -> Result<()> {
    let counted = table(&suite::counts(hullkit::methods())?);
    let expected = read(args)?;
    let changes = changes(&expected, &counted);
    if changes.is_empty() {
        to_stdout(|out| writeln!(out, "{} counts, all as expected", counted.len()))?;
        return Ok(());
    }
    let mut sheet = Sheet::new(&["method", "set", "counter", "expected", "now"]);
    for change in &changes {
        sheet.push(change.cells());
    }
    to_stdout(|out| write!(out, "{}", sheet.markdown()))?;
    let message = format!(
        "{} counts differ from {}; if they are meant to, `hullbench bless` and commit the file with the change",
        changes.len(),
        args.expected.display()
    );
    Err(Failure::Verification(message).into())
}

/// Writes the counts of every method as the expected ones.
///
/// # Errors
///
/// A file that cannot be written.
pub fn bless(args: &Args) -> Result<()> {
    let counted = table(&suite::counts(hullkit::methods())?);
    let text = text(&counted);
    write(&args.expected, Existing::Replace, |out| {
        out.write_all(text.as_bytes())
    })
    .map_err(|error| Failure::io(args.expected.display(), &error, "does its folder exist?"))?;
    to_stdout(|out| {
        writeln!(
            out,
            "{} counts in {}",
            counted.len(),
            args.expected.display()
        )
    })?;
    Ok(())
}

/// (method, set, counter) to value.
type Table = BTreeMap<(String, String, String), u64>;

fn table(counts: &Counts) -> Table {
    let rows = counts.iter().flat_map(|((method, set), counters)| {
        let row = |(counter, value): (&&str, &u64)| {
            ((method.clone(), set.clone(), (*counter).to_owned()), *value)
        };
        counters.iter().map(row)
    });
    rows.collect()
}

const HEADER: &str = "method,set,counter,value";

fn text(table: &Table) -> String {
    let mut text = format!("{HEADER}\n");
    for ((method, set, counter), value) in table {
        let quoted = if set.contains(',') {
            format!("\"{set}\"")
        } else {
            set.clone()
        };
        let _ = writeln!(text, "{method},{quoted},{counter},{value}");
    }
    text
}

fn read(args: &Args) -> Result<Table> {
    let path = args.expected.display();
    let text = std::fs::read_to_string(&args.expected)
        .map_err(|error| Failure::io(&path, &error, "`hullbench bless` writes it"))?;
    let mut table = Table::new();
    for (i, row) in csv::Reader::from_reader(text.as_bytes())
        .into_deserialize()
        .enumerate()
    {
        let (method, set, counter, value) = row.map_err(|error: csv::Error| {
            Failure::Data(format!("{path}:{}: {error}; expected {HEADER}", i + 2))
        })?;
        table.insert((method, set, counter), value);
    }
    Ok(table)
}

/// A count that is not what it was.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Change {
    key: (String, String, String),
    expected: Option<u64>,
    now: Option<u64>,
}

impl Change {
    fn cells(&self) -> Vec<String> {
        let (method, set, counter) = self.key.clone();
        let value = |value: Option<u64>| value.map_or("none".to_owned(), |value| value.to_string());
        vec![method, set, counter, value(self.expected), value(self.now)]
    }
}

fn changes(expected: &Table, counted: &Table) -> Vec<Change> {
    let keys: BTreeSet<_> = expected.keys().chain(counted.keys()).collect();
    let change = |key: &(String, String, String)| Change {
        key: key.clone(),
        expected: expected.get(key).copied(),
        now: counted.get(key).copied(),
    };
    let all = keys.into_iter().map(change);
    all.filter(|change| change.expected != change.now).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::counting::{PointSet, counters};
    use geometry_core::{Counted, Exact, Kernel3, Observer, Points, Step, Tally};

    /// Asks one more orientation with every point inserted.
    struct OneMore<'a> {
        kernel: &'a Counted<Exact>,
        tally: Tally,
    }

    impl Observer for OneMore<'_> {
        const ACTIVE: bool = true;
        fn record(&mut self, step: Step) {
            if matches!(step, Step::Insert(_)) {
                let [a, b, c, d] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
                self.kernel.orient3(a, b, c, d);
            }
            self.tally.record(step);
        }
    }

    #[test]
    fn one_more_orientation_an_insertion_is_caught() {
        let methods = || hullkit::methods().filter(|method| method.slug == "incremental-3d");
        let expected = suite::counts(methods()).expect("counts");
        let mut slower = expected.clone();
        for (name, points) in suite::sets().expect("sets") {
            let PointSet::Space(points) = points else {
                continue;
            };
            let kernel = Counted::new(Exact);
            let tally = Tally::default();
            let mut observer = OneMore {
                kernel: &kernel,
                tally,
            };
            let points = Points::new(&points).expect("finite");
            incremental::incremental_3d(points, &&kernel, &mut observer).expect("a hull");
            let counted = counters(&kernel.counts(), &observer.tally);
            slower.insert(("incremental-3d".to_owned(), name), counted);
        }
        let changes = changes(&table(&expected), &table(&slower));
        assert!(!changes.is_empty());
        for change in changes {
            assert_eq!(change.key.2, "orientations-in-space");
            assert!(change.now > change.expected);
        }
    }

    #[test]
    fn what_is_blessed_is_what_is_read() {
        let folder = tempfile::tempdir().expect("a folder");
        let args = Args {
            expected: folder.path().join("counts.csv"),
        };
        let one = hullkit::methods().filter(|method| method.slug == "gs");
        let table = table(&suite::counts(one).expect("counts"));
        std::fs::write(&args.expected, text(&table)).expect("written");
        assert_eq!(read(&args).expect("read"), table);
        std::fs::write(
            &args.expected,
            "method,set,counter,value\ngs,disc,orientations,many\n",
        )
        .expect("written");
        let fault = read(&args).expect_err("no number").to_string();
        assert!(fault.contains("counts.csv:2: "), "{fault}");
    }
}
