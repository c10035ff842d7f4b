//! A loaded run folder, and views of it: cases, times by engine and realisation, twins, counts, hull sizes.

use super::error::{Problem, RecordError};
use super::manifest::Manifest;
use super::read::{self, Content, Numbered};
use super::row::Row;
use super::rows::{Case, Cell, Count, Outcome, Sample, Subject, Warning, twin_of};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::{Path, PathBuf};

/// A run, as it lies in its folder.
#[derive(Clone, Debug)]
pub struct Run {
    /// Where it lies.
    pub folder: PathBuf,
    /// Where it comes from.
    pub manifest: Manifest,
    /// What became of each engine on each point set.
    pub cells: Vec<Cell>,
    /// Every sample.
    pub samples: Vec<Sample>,
    /// Every count.
    pub counts: Vec<Count>,
    /// Every warning.
    pub warnings: Vec<Warning>,
    /// What a reader of the folder should know: last lines that were torn.
    pub notes: Vec<String>,
    times: BTreeMap<Case, BTreeMap<String, Vec<Realisation>>>,
    hull_sizes: BTreeMap<Case, BTreeMap<u64, u64>>,
}

/// The times of one engine on one realisation of a point set.
#[derive(Clone, Debug, PartialEq)]
pub struct Realisation {
    /// Its seed.
    pub seed: u64,
    /// The round and the nanoseconds of one call, by round.
    pub rounds: Vec<(u32, f64)>,
}

impl Realisation {
    /// The nanoseconds alone.
    pub fn times(&self) -> Vec<f64> {
        self.rounds.iter().map(|(_, time)| *time).collect()
    }
}

/// An engine and its twin, which is the same program measured as if it were another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TwinPair {
    /// The engine.
    pub engine: String,
    /// Its twin.
    pub twin: String,
}

/// The least, the median and the most of some integers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Spread {
    /// The least.
    pub least: u64,
    /// The one in the middle, the lower of two.
    pub middle: u64,
    /// The most.
    pub most: u64,
}

impl Spread {
    /// That of `values`; `None` of none.
    pub fn of(mut values: Vec<u64>) -> Option<Self> {
        values.sort_unstable();
        Some(Self {
            least: *values.first()?,
            middle: *values.get((values.len() - 1) / 2)?,
            most: *values.last()?,
        })
    }
}

impl std::fmt::Display for Spread {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.least == self.most {
            f.pad(&self.middle.to_string())
        } else {
            f.pad(&format!("{} ({}–{})", self.middle, self.least, self.most))
        }
    }
}

impl Run {
    /// Loads the run in `folder`. Files that are not there are empty, but for the manifest and the cells.
    ///
    /// # Errors
    ///
    /// [`RecordError`]: a file that cannot be read, a row that is wrong, or a sample of a cell that is not
    /// certified.
    pub fn load(folder: &Path) -> Result<Self, RecordError> {
        let manifest = Manifest::read(folder)?;
        let cells_path = folder.join(Cell::FILE);
        if !cells_path.exists() {
            return Err(RecordError::io(
                cells_path,
                std::io::ErrorKind::NotFound.into(),
            ));
        }
        let mut notes = Vec::new();
        let cells = taken(read::rows::<Cell>(folder)?, &mut notes);
        let samples = taken(read::rows::<Sample>(folder)?, &mut notes);
        let counts = taken(read::rows::<Count>(folder)?, &mut notes);
        let warnings = taken(read::rows::<Warning>(folder)?, &mut notes);
        let cells = bare(cells);
        check_certified(folder, &cells, &samples)?;
        let rows = (bare(samples), bare(counts), bare(warnings));
        Ok(Self {
            folder: folder.to_owned(),
            notes,
            ..Self::from_rows(manifest, cells, rows)
        })
    }

    /// The run with these rows, which lies in no folder. Samples must be those of certified cells.
    pub fn from_rows(
        manifest: Manifest,
        cells: Vec<Cell>,
        (samples, counts, warnings): (Vec<Sample>, Vec<Count>, Vec<Warning>),
    ) -> Self {
        Self {
            folder: PathBuf::new(),
            manifest,
            times: by_case(&samples),
            hull_sizes: hull_sizes(&cells),
            cells,
            samples,
            counts,
            warnings,
            notes: Vec::new(),
        }
    }

    /// Every case that was measured or counted, in order.
    pub fn cases(&self) -> Vec<&Case> {
        let cells = self.cells.iter().map(|cell| &cell.subject.case);
        let counts = self.counts.iter().map(|count| &count.subject.case);
        let cases: BTreeSet<&Case> = cells.chain(counts).chain(self.times.keys()).collect();
        cases.into_iter().collect()
    }

    /// The engines that were timed on `case`, in order, without twins.
    pub fn timed(&self, case: &Case) -> Vec<&str> {
        let engines = self.times.get(case).into_iter().flat_map(BTreeMap::keys);
        let names = engines.map(String::as_str);
        names.filter(|engine| twin_of(engine).is_none()).collect()
    }

    /// The times of `engine` on `case`, a realisation after the other by seed; none if it was not timed.
    pub fn times(&self, case: &Case, engine: &str) -> &[Realisation] {
        let engines = self.times.get(case);
        let found = engines.and_then(|engines| engines.get(engine));
        found.map_or(&[], Vec::as_slice)
    }

    /// The engines on `case` of which a twin was timed.
    pub fn twins(&self, case: &Case) -> Vec<TwinPair> {
        let engines = self.times.get(case).into_iter().flat_map(BTreeMap::keys);
        let pair = |twin: &String| {
            let engine = twin_of(twin)?.to_owned();
            let twin = twin.clone();
            (!self.times(case, &engine).is_empty()).then_some(TwinPair { engine, twin })
        };
        engines.filter_map(pair).collect()
    }

    /// The engines with counts on `case`, in order.
    pub fn counted(&self, case: &Case) -> Vec<&str> {
        let engines = self
            .counts
            .iter()
            .filter(|count| count.subject.case == *case);
        let names: BTreeSet<&str> = engines.map(|count| count.subject.engine.as_str()).collect();
        names.into_iter().collect()
    }

    /// Everything that was counted, in order.
    pub fn counters(&self) -> Vec<&str> {
        let names: BTreeSet<&str> = self.counts.iter().map(|c| c.counter.as_str()).collect();
        names.into_iter().collect()
    }

    /// How many vertices the certified hulls of `case` have, over its realisations.
    pub fn h(&self, case: &Case) -> Option<Spread> {
        Spread::of(self.hull_sizes.get(case)?.values().copied().collect())
    }

    /// How many vertices the certified hull of one realisation of `case` has.
    pub fn h_of(&self, case: &Case, seed: u64) -> Option<u64> {
        self.hull_sizes.get(case)?.get(&seed).copied()
    }
}

/// The rows of a file, its torn last line noted.
fn taken<R: Row>(content: Content<R>, notes: &mut Vec<String>) -> Vec<Numbered<R>> {
    if let Some(torn) = &content.torn {
        notes.push(format!(
            "{}: the last line has no end and is left out: {torn:?}",
            R::FILE
        ));
    }
    content.rows
}

fn bare<R>(rows: Vec<Numbered<R>>) -> Vec<R> {
    rows.into_iter().map(|numbered| numbered.row).collect()
}

/// Every sample must belong to a certified cell; a twin's to a cell of its own or of its engine.
fn check_certified(
    folder: &Path,
    cells: &[Cell],
    samples: &[Numbered<Sample>],
) -> Result<(), RecordError> {
    let certified: HashSet<&Subject> = cells
        .iter()
        .filter(|cell| cell.outcome == Outcome::Certified)
        .map(|cell| &cell.subject)
        .collect();
    for Numbered { line, row } in samples {
        let of_engine = || {
            row.subject.twin_of().is_some_and(|engine| {
                certified.contains(&Subject {
                    engine: engine.to_owned(),
                    ..row.subject.clone()
                })
            })
        };
        if !certified.contains(&row.subject) && !of_engine() {
            let cell = row.subject.to_string();
            let error = RecordError::new(folder.join(Sample::FILE), Problem::Uncertified { cell });
            return Err(error.at(*line));
        }
    }
    Ok(())
}

/// The numbers of vertices of certified hulls, by case and seed.
fn hull_sizes(cells: &[Cell]) -> BTreeMap<Case, BTreeMap<u64, u64>> {
    let mut sizes: BTreeMap<Case, BTreeMap<u64, u64>> = BTreeMap::new();
    for cell in cells {
        if let (Outcome::Certified, Some(h)) = (cell.outcome, cell.h) {
            let case = sizes.entry(cell.subject.case.clone()).or_default();
            case.insert(cell.subject.seed, h);
        }
    }
    sizes
}

fn by_case(samples: &[Sample]) -> BTreeMap<Case, BTreeMap<String, Vec<Realisation>>> {
    type BySeed = BTreeMap<u64, Vec<(u32, f64)>>;
    let mut found: BTreeMap<&Case, BTreeMap<&str, BySeed>> = BTreeMap::new();
    for sample in samples {
        let Subject { case, seed, engine } = &sample.subject;
        let engines = found.entry(case).or_default();
        let rounds = engines.entry(engine).or_default().entry(*seed).or_default();
        rounds.push((sample.round, sample.per_call()));
    }
    let realisations = |by_seed: BySeed| {
        let sorted = by_seed.into_iter().map(|(seed, mut rounds)| {
            rounds.sort_unstable_by_key(|(round, _)| *round);
            Realisation { seed, rounds }
        });
        sorted.collect()
    };
    let engines = |engines: BTreeMap<&str, BySeed>| {
        let named = engines.into_iter();
        named
            .map(|(engine, by_seed)| (engine.to_owned(), realisations(by_seed)))
            .collect()
    };
    found
        .into_iter()
        .map(|(case, by_engine)| (case.clone(), engines(by_engine)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::write;
    use std::num::NonZeroU64;

    fn subject(seed: u64, engine: &str) -> Subject {
        let case = Case {
            definition: "d".into(),
            set: "disc".into(),
            n: 100,
        };
        Subject {
            case,
            seed,
            engine: engine.into(),
        }
    }

    fn cell(seed: u64, engine: &str, outcome: Outcome, h: u64) -> Cell {
        Cell {
            subject: subject(seed, engine),
            fingerprint: "ab".into(),
            outcome,
            h: Some(h),
            facets: None,
            finding: String::new(),
        }
    }

    fn sample(seed: u64, engine: &str, round: u32, nanoseconds: u64) -> Sample {
        Sample {
            subject: subject(seed, engine),
            round,
            inner: NonZeroU64::new(2).expect("two"),
            nanoseconds,
        }
    }

    fn folder(cells: &[Cell], samples: &[Sample]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().expect("a folder");
        Manifest::default().write(folder.path()).expect("manifest");
        write::rows(folder.path(), cells).expect("cells");
        write::rows(folder.path(), samples).expect("samples");
        folder
    }

    #[test]
    fn views_of_a_run() {
        let cells = [
            cell(1, "gs", Outcome::Certified, 20),
            cell(2, "gs", Outcome::Certified, 24),
            cell(1, "eddy", Outcome::Wrong, 7),
        ];
        let samples = [
            sample(2, "gs", 1, 30),
            sample(2, "gs", 0, 20),
            sample(1, "gs", 0, 10),
            sample(1, "gs@twin", 0, 12),
        ];
        let folder = folder(&cells, &samples);
        let run = Run::load(folder.path()).expect("a run");
        let case = run.cases()[0].clone();
        assert_eq!(run.cases().len(), 1);
        assert_eq!(run.timed(&case), ["gs"]);
        let times: Vec<Vec<f64>> = run
            .times(&case, "gs")
            .iter()
            .map(Realisation::times)
            .collect();
        assert_eq!(times, [vec![5.0], vec![10.0, 15.0]]);
        assert!(run.times(&case, "eddy").is_empty());
        assert_eq!(run.twins(&case)[0].twin, "gs@twin");
        assert_eq!(run.h(&case).expect("h").to_string(), "20 (20–24)");
        assert!(run.notes.is_empty());
    }

    #[test]
    fn a_sample_of_an_uncertified_cell_is_an_error_with_its_line() {
        let cells = [
            cell(1, "gs", Outcome::Certified, 20),
            cell(1, "eddy", Outcome::Wrong, 7),
        ];
        for engine in ["eddy", "eddy@twin", "unknown"] {
            let folder = folder(&cells, &[sample(1, "gs", 0, 1), sample(1, engine, 0, 1)]);
            let error = Run::load(folder.path())
                .expect_err("uncertified")
                .to_string();
            assert!(error.contains("samples.csv:3: a sample of"), "{error}");
        }
    }

    #[test]
    fn a_torn_line_is_noted_and_a_missing_manifest_is_an_error() {
        let folder = folder(&[cell(1, "gs", Outcome::Certified, 3)], &[]);
        let path = folder.path().join(Sample::FILE);
        let text = std::fs::read_to_string(&path).expect("text") + "d,disc,100,1,gs,0,1,9";
        std::fs::write(&path, text).expect("torn");
        let run = Run::load(folder.path()).expect("a run");
        assert!(run.samples.is_empty() && run.notes[0].starts_with("samples.csv: "));
        std::fs::remove_file(folder.path().join(Manifest::FILE)).expect("removed");
        let error = Run::load(folder.path())
            .expect_err("no manifest")
            .to_string();
        assert!(error.contains("manifest.json: no such file"), "{error}");
    }
}
