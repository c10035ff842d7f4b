//! What is recorded, as it is recorded: nothing is done twice, nothing that was measured is lost.

use super::warnings;
use crate::definition::Definition;
use crate::engine::fault::Fault;
use crate::engine::protocol::Receipt;
use crate::failure::Failure;
use crate::output::atomic::{self, Existing};
use crate::provenance;
use crate::records::DEFINITIONS;
use crate::records::manifest::{DefinitionStamp, EngineStamp};
use crate::records::{
    Cell, Count, Journal, Manifest, Outcome, Row, Run, Sample, Subject, Warning, read, write,
};
use anyhow::Result;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::path::{Path, PathBuf};

/// A run folder that is being written.
pub(super) struct Ledger {
    folder: PathBuf,
    manifest: Manifest,
    cells: Journal<Cell>,
    samples: Journal<Sample>,
    counts: Journal<Count>,
    outcomes: HashMap<Subject, Outcome>,
    rounds: HashMap<Subject, BTreeSet<u32>>,
    counted: HashSet<Subject>,
    engines: BTreeMap<String, EngineStamp>,
    warnings: Vec<Warning>,
    notes: Vec<String>,
}

impl Ledger {
    /// Opens the run in `folder`, new or interrupted.
    ///
    /// # Errors
    ///
    /// A folder that holds a run of other definitions; one that another process writes to; one that cannot be written.
    pub(super) fn open(folder: &Path, definitions: &[Definition], command: &str) -> Result<Self> {
        std::fs::create_dir_all(folder)
            .map_err(|error| Failure::io(folder.display(), &error, "name another with --run"))?;
        let known = folder.join(Manifest::FILE).exists();
        let stamps = stamps(definitions);
        let manifest = if known {
            continued(Manifest::read(folder)?, folder, stamps, command)?
        } else {
            Manifest {
                definitions: stamps,
                ..provenance::manifest(command)
            }
        };
        manifest.write(folder)?;
        keep_texts(folder, definitions)?;
        forget_absent(folder)?;
        let (cells, found_cells) = Journal::<Cell>::open(folder)?;
        let (samples, found_samples) = Journal::<Sample>::open(folder)?;
        let (counts, found_counts) = Journal::<Count>::open(folder)?;
        let mut rounds: HashMap<Subject, BTreeSet<u32>> = HashMap::new();
        for sample in found_samples.rows {
            rounds
                .entry(sample.subject)
                .or_default()
                .insert(sample.round);
        }
        let engines = manifest
            .engines
            .iter()
            .map(|stamp| (stamp.name.clone(), stamp.clone()));
        Ok(Self {
            folder: folder.to_owned(),
            engines: engines.collect(),
            manifest,
            cells,
            samples,
            counts,
            outcomes: found_cells
                .rows
                .into_iter()
                .map(|cell| (cell.subject, cell.outcome))
                .collect(),
            rounds,
            counted: found_counts
                .rows
                .into_iter()
                .map(|count| count.subject)
                .collect(),
            warnings: read::rows::<Warning>(folder)?
                .rows
                .into_iter()
                .map(|row| row.row)
                .collect(),
            notes: Vec::new(),
        })
    }

    /// Whether nothing is left to do for `subject`.
    pub(super) fn is_done(&self, subject: &Subject, rounds: u32, counts: bool) -> bool {
        match self.outcomes.get(subject) {
            None => false,
            Some(Outcome::Certified) => {
                (0..rounds).all(|round| self.has_round(subject, round))
                    && (!counts || subject.twin_of().is_some() || self.is_counted(subject))
            }
            Some(_) => true,
        }
    }

    pub(super) fn has_round(&self, subject: &Subject, round: u32) -> bool {
        self.rounds
            .get(subject)
            .is_some_and(|rounds| rounds.contains(&round))
    }

    pub(super) fn is_counted(&self, subject: &Subject) -> bool {
        self.counted.contains(subject)
    }

    /// Why `subject` need not be tried: its engine ran out of time on as many points of the set, or fewer.
    pub(super) fn given_up(&self, subject: &Subject) -> Option<String> {
        let timed_out = |(other, outcome): &(&Subject, &Outcome)| {
            **outcome == Outcome::Timeout
                && other.engine == subject.engine
                && other.case.definition == subject.case.definition
                && other.case.set == subject.case.set
                && other.case.n <= subject.case.n
        };
        let (other, _) = self.outcomes.iter().find(timed_out)?;
        Some(format!(
            "not tried: it ran out of time on n = {}",
            other.case.n
        ))
    }

    /// Records what became of an engine; a cell that an interrupted run has recorded stays as it is.
    pub(super) fn cell(&mut self, cell: Cell) -> Result<()> {
        if !self.cells.contains(&cell) {
            self.cells.append(&cell)?;
        }
        self.outcomes.insert(cell.subject, cell.outcome);
        Ok(())
    }

    pub(super) fn sample(&mut self, sample: Sample) -> Result<()> {
        self.samples.append(&sample)?;
        self.rounds
            .entry(sample.subject)
            .or_default()
            .insert(sample.round);
        Ok(())
    }

    pub(super) fn counts(&mut self, subject: &Subject, counts: Vec<Count>) -> Result<()> {
        self.counts.append_all(&counts)?;
        self.counted.insert(subject.clone());
        Ok(())
    }

    /// An engine that was certified and failed afterwards.
    pub(super) fn failed_late(&mut self, subject: &Subject, fault: &Fault) {
        self.warnings.push(Warning {
            subject: subject.clone(),
            warning: format!("failed after it was certified: {fault}"),
            remedy: "its samples here are fewer than those of others: run it again alone"
                .to_owned(),
        });
    }

    /// An engine whose instructions could not be counted.
    pub(super) fn uncounted(&mut self, subject: &Subject, fault: &Fault) {
        self.warnings.push(Warning {
            subject: subject.clone(),
            warning: format!("instructions not counted: {fault}"),
            remedy: "compile the engine without AVX-512, which valgrind does not know".to_owned(),
        });
    }

    /// An engine introduced itself.
    pub(super) fn met(&mut self, name: &str, receipt: &Receipt) {
        let stamp = EngineStamp {
            name: name.to_owned(),
            version: receipt.version.clone(),
            clock_ns: receipt.clock_ns,
        };
        self.engines.insert(name.to_owned(), stamp);
    }

    pub(super) fn note(&mut self, note: &str) {
        self.notes.push(note.to_owned());
    }

    pub(super) fn notes(&self) -> &[String] {
        &self.notes
    }

    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    pub(super) fn outcomes(&self) -> impl Iterator<Item = Outcome> {
        self.outcomes.values().copied()
    }

    /// Completes the manifest, and writes what a reader should be careful about.
    pub(super) fn close(&mut self) -> Result<()> {
        self.samples.sync()?;
        self.manifest.load_after = provenance::load();
        self.manifest.engines = self.engines.values().cloned().collect();
        self.manifest.write(&self.folder)?;
        write::rows::<Warning>(&self.folder, &[])?;
        let mut all = warnings::of(&Run::load(&self.folder)?);
        all.append(&mut self.warnings);
        let mut keys = HashSet::new();
        all.retain(|warning| keys.insert(warning.key()));
        write::rows(&self.folder, &all)?;
        Ok(())
    }
}

/// Keeps the text of every definition with the run, so that its question goes where its numbers go.
fn keep_texts(folder: &Path, definitions: &[Definition]) -> Result<()> {
    let folder = folder.join(DEFINITIONS);
    let fail = |path: &Path, error| {
        Failure::io(path.display(), &error, "check the permissions of the run")
    };
    std::fs::create_dir_all(&folder).map_err(|error| fail(&folder, error))?;
    for definition in definitions {
        let path = folder.join(format!("{}.toml", definition.id));
        atomic::write(&path, Existing::Replace, |out| {
            out.write_all(definition.text.as_bytes())
        })
        .map_err(|error| fail(&path, error))?;
    }
    Ok(())
}

fn stamps(definitions: &[Definition]) -> Vec<DefinitionStamp> {
    let stamp = |definition: &Definition| DefinitionStamp {
        id: definition.id.clone(),
        sha256: definition.hash.clone(),
    };
    definitions.iter().map(stamp).collect()
}

/// The manifest of a run that goes on. Its definitions must be the same texts: their cells would mix otherwise.
fn continued(
    mut manifest: Manifest,
    folder: &Path,
    stamps: Vec<DefinitionStamp>,
    command: &str,
) -> Result<Manifest> {
    for stamp in &stamps {
        let before = manifest
            .definitions
            .iter()
            .find(|before| before.id == stamp.id);
        if before.is_some_and(|before| before.sha256 != stamp.sha256) {
            let message = format!(
                "{} holds a run of another text of the definition '{}'; name another folder with --run",
                folder.display(),
                stamp.id
            );
            return Err(Failure::Data(message).into());
        }
    }
    let new = stamps.into_iter().filter(|stamp| {
        manifest
            .definitions
            .iter()
            .all(|before| before.id != stamp.id)
    });
    let new: Vec<DefinitionStamp> = new.collect();
    manifest.definitions.extend(new);
    if !manifest.command.split("; ").any(|before| before == command) {
        manifest.command = format!("{}; {command}", manifest.command);
    }
    Ok(manifest)
}

/// Engines that were not there may be by now.
fn forget_absent(folder: &Path) -> Result<()> {
    if folder.join(Cell::FILE).exists() {
        let rows = read::rows::<Cell>(folder)?
            .rows
            .into_iter()
            .map(|row| row.row);
        let there: Vec<Cell> = rows
            .filter(|cell| cell.outcome != Outcome::Absent)
            .collect();
        write::rows(folder, &there)?;
    }
    Ok(())
}
