//! An experiment as data: a TOML file that says which engines meet which point sets, and what is measured.
//!
//! ```toml
//! id = "small-discs"                    # the file's name
//! group = "curated"                     # asked for together by this name
//! task = "hull2"
//! boundary = "extreme"                  # or "all": which points of the boundary are vertices
//! seed = 2026                           # every point set's seed is derived from it
//! question = "Which hull is fastest on few points?"
//!
//! [[cells]]
//! sets = ["disc", "circle"]             # specs of the catalogue
//! n = [100, 1_000]
//! engines = ["gs", "qhull"]             # registered methods and peers, by name
//! measure = ["time", "counts"]
//! realisations = 3                      # sets drawn for each cell
//! rounds = 7                            # samples of each realisation
//! points_a_batch = 10_000               # a realisation of small n is timed as a batch of sets
//! twin = "gs"                           # measured twice, under two names: the noise of a program against itself
//!
//! [left_out]
//! jarvis-j1 = "O(n h): minutes on the circle"
//! ```
//!
//! [`find`] says where definitions lie, [`fault`] what is wrong with one, by file, line and field.

pub(crate) mod fault;
pub(crate) mod find;

use crate::engine::catalogue;
use crate::engine::protocol::{Convention, Problem};
use crate::failure::Failure;
use fault::Fault;
use find::Source;
use serde::Deserialize;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::str::FromStr;
use toml::Spanned;

/// What is measured in a cell that every engine has been certified in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Measure {
    /// Interleaved samples of time.
    Time,
    /// Exact integers, from runs of their own.
    Counts,
    /// Instructions of a call, where valgrind is installed.
    Instructions,
    /// Nothing beside what every cell says: that the hull is certified, and how many vertices it has.
    Sizes,
}

/// How much of a paper is to be run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extent {
    /// All of it.
    Full,
    /// As much as takes a minute.
    Quick,
}

/// Whether an engine of that name computes this; if not, why.
pub(crate) type Known<'a> = &'a dyn Fn(&str, Problem) -> Result<(), String>;

/// The folders of definitions that anyone may run.
const FOLDERS: [&str; 8] = [
    "curated",
    "fast",
    "growth",
    "published",
    "green-silverman-1979/full",
    "day-1990/full",
    "nathan-2015/full",
    "balan-munjal-rao/full",
];

/// An experiment.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    /// Its name, which is its file's.
    pub(crate) id: String,
    pub(crate) group: String,
    pub(crate) problem: Problem,
    /// Which points of the boundary are vertices.
    pub(crate) boundary: Convention,
    pub(crate) seed: u64,
    /// What it is to find out, in words.
    pub(crate) question: String,
    pub(crate) cells: Vec<Block>,
    /// Engines that do not take part, each with the reason.
    pub(crate) left_out: BTreeMap<String, String>,
    /// The whole file, as it was written.
    pub(crate) text: String,
    /// SHA-256 of the text.
    pub(crate) hash: String,
}

/// Cells that are measured alike: every set with every n.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    pub(crate) sets: Vec<point_sets::Spec>,
    pub(crate) n: Vec<usize>,
    pub(crate) engines: Vec<String>,
    pub(crate) measure: Vec<Measure>,
    pub(crate) realisations: u64,
    pub(crate) rounds: u32,
    pub(crate) points_a_batch: usize,
    pub(crate) twin: Option<String>,
    pub(crate) timeout_seconds: u64,
}

impl Block {
    /// How many sets of `n` points a realisation is timed on in turn: called on one small set again and again, a
    /// processor learns its branches by heart.
    pub(crate) fn batch(&self, n: usize) -> u64 {
        self.points_a_batch.div_ceil(n.max(1)).max(1) as u64
    }
}

/// The file as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    id: Spanned<String>,
    group: Spanned<String>,
    task: Problem,
    #[serde(default)]
    boundary: Convention,
    seed: u64,
    question: Spanned<String>,
    cells: Vec<WrittenBlock>,
    #[serde(default)]
    left_out: BTreeMap<Spanned<String>, Spanned<String>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WrittenBlock {
    sets: Vec<Spanned<String>>,
    n: Vec<Spanned<usize>>,
    engines: Vec<Spanned<String>>,
    measure: Vec<Spanned<Measure>>,
    #[serde(default = "one")]
    realisations: Spanned<u64>,
    #[serde(default = "no_rounds")]
    rounds: Spanned<u32>,
    #[serde(default)]
    points_a_batch: usize,
    twin: Option<Spanned<String>>,
    #[serde(default = "a_minute")]
    timeout_seconds: Spanned<u64>,
}

fn one() -> Spanned<u64> {
    Spanned::new(0..0, 1)
}

fn no_rounds() -> Spanned<u32> {
    Spanned::new(0..0, 5)
}

fn a_minute() -> Spanned<u64> {
    Spanned::new(0..0, 60)
}

impl Definition {
    /// Every definition there is.
    ///
    /// # Errors
    ///
    /// As [`Definition::at`].
    pub(crate) fn all(known: Known<'_>) -> Result<Vec<Self>, Failure> {
        let mut all = Vec::new();
        for folder in FOLDERS {
            for source in find::all(folder)? {
                all.push(Self::read(&source, known)?);
            }
        }
        Ok(all)
    }

    /// The definitions of the paper whose folder is `slug`.
    ///
    /// # Errors
    ///
    /// As [`Definition::at`].
    pub(crate) fn of_paper(slug: &str, extent: Extent) -> Result<Vec<Self>, Failure> {
        let folder = match extent {
            Extent::Full => "full",
            Extent::Quick => "quick",
        };
        let sources = find::all(&format!("{slug}/{folder}"))?;
        let read = |source| Self::read(source, &catalogue::knows);
        sources.iter().map(read).collect()
    }

    /// The definition in the file at `path`.
    ///
    /// # Errors
    ///
    /// A file that cannot be read; the first fault in it.
    pub(crate) fn at(path: &str, known: Known<'_>) -> Result<Self, Failure> {
        Self::read(&find::at(path)?, known)
    }

    fn read(source: &Source, known: Known<'_>) -> Result<Self, Failure> {
        Self::parse(&source.path, &source.text, known)
            .map_err(|fault| Failure::Data(fault.to_string()))
    }

    /// Reads the definition `text`, which lies at `path`; `known` says whether an engine of that name computes this.
    ///
    /// # Errors
    ///
    /// The first fault by file, line and field: an unknown key, set or engine, an empty list, a number out of range.
    pub(crate) fn parse(path: &str, text: &str, known: Known<'_>) -> Result<Self, Fault> {
        let written: Written =
            toml::from_str(text).map_err(|error| Fault::of_toml(path, text, &error))?;
        let reader = Reader {
            path,
            text,
            problem: written.task,
            known,
        };
        let stem = path.rsplit('/').next().unwrap_or(path);
        reader.hold(&written.id, "id", "is not the file's name", |id| {
            stem.strip_suffix(".toml") == Some(id)
        })?;
        let blank = |text: &String| text.trim().is_empty();
        reader.hold(&written.question, "question", "is empty", |q| !blank(q))?;
        reader.hold(&written.group, "group", "is empty", |group| !blank(group))?;
        if written.cells.is_empty() {
            return Err(reader.fault(0..0, "cells", "there are none"));
        }
        let cells: Result<Vec<Block>, Fault> = written
            .cells
            .iter()
            .map(|block| reader.block(block))
            .collect();
        reader.distinct(&written.cells)?;
        for (engine, reason) in &written.left_out {
            reader.engine(engine, "left_out")?;
            reader.hold(reason, "left_out", "gives no reason", |text| !blank(text))?;
        }
        let left_out = written.left_out.into_iter();
        Ok(Self {
            id: written.id.into_inner(),
            group: written.group.into_inner(),
            problem: written.task,
            boundary: written.boundary,
            seed: written.seed,
            question: written.question.into_inner(),
            cells: cells?,
            left_out: left_out
                .map(|(e, r)| (e.into_inner(), r.into_inner()))
                .collect(),
            text: text.to_owned(),
            hash: Sha256::digest(text)
                .iter()
                .map(|byte| format!("{byte:02x}"))
                .collect(),
        })
    }
}

/// Turns what is written into what is meant.
struct Reader<'a> {
    path: &'a str,
    text: &'a str,
    problem: Problem,
    known: Known<'a>,
}

impl Reader<'_> {
    fn block(&self, written: &WrittenBlock) -> Result<Block, Fault> {
        let sets: Result<Vec<_>, Fault> = written.sets.iter().map(|set| self.set(set)).collect();
        for engine in written.engines.iter().chain(&written.twin) {
            self.engine(engine, "engines")?;
        }
        let engines: Vec<String> = written.engines.iter().map(plain).collect();
        if let Some(twin) = &written.twin {
            self.hold(twin, "twin", "is none of the engines", |t| {
                engines.contains(t)
            })?;
        }
        for n in &written.n {
            self.hold(n, "n", "must be at least 1", |&n| n >= 1)?;
        }
        self.hold(
            &written.realisations,
            "realisations",
            "must be at least 1",
            |&n| n >= 1,
        )?;
        self.hold(&written.rounds, "rounds", "must be at least 1", |&n| n >= 1)?;
        self.hold(
            &written.timeout_seconds,
            "timeout_seconds",
            "must be at least 1",
            |&n| n >= 1,
        )?;
        let empty = [
            ("sets", written.sets.is_empty()),
            ("n", written.n.is_empty()),
            ("engines", engines.is_empty()),
            ("measure", written.measure.is_empty()),
        ];
        if let Some((field, _)) = empty.iter().find(|(_, empty)| *empty) {
            return Err(self.fault(0..0, field, "is an empty list"));
        }
        Ok(Block {
            sets: sets?,
            n: written.n.iter().map(plain).collect(),
            engines,
            measure: written.measure.iter().map(plain).collect(),
            realisations: plain(&written.realisations),
            rounds: plain(&written.rounds),
            points_a_batch: written.points_a_batch,
            twin: written.twin.as_ref().map(plain),
            timeout_seconds: plain(&written.timeout_seconds),
        })
    }

    /// No engine may meet a set with the same n twice: the records could not tell the two apart. Where times are taken
    /// no set may: those in one block only are taken side by side.
    fn distinct(&self, blocks: &[WrittenBlock]) -> Result<(), Fault> {
        let mut met = HashSet::new();
        let mut cells: HashMap<(&String, usize), bool> = HashMap::new();
        for block in blocks {
            let is_timed = block.measure.iter().any(|m| *m.as_ref() == Measure::Time);
            let sets = block.sets.iter();
            for (set, n) in sets.flat_map(|set| block.n.iter().map(move |n| (set, n))) {
                let cell = (set.as_ref(), *n.as_ref());
                let before = cells.get(&cell).copied();
                let side_by_side = before.is_none_or(|was_timed| !was_timed && !is_timed);
                cells.insert(cell, is_timed);
                let engines = block.engines.iter();
                let mut new = engines.map(|engine| met.insert((cell, engine.as_ref())));
                if !side_by_side || !new.all(|new| new) {
                    let what = format!(
                        "'{}' with n = {} stands here twice",
                        set.as_ref(),
                        n.as_ref()
                    );
                    return Err(self.fault(set.span(), "sets", &what));
                }
            }
        }
        Ok(())
    }

    fn set(&self, name: &Spanned<String>) -> Result<point_sets::Spec, Fault> {
        let spec = point_sets::Spec::from_str(name.as_ref())
            .map_err(|error| self.fault(name.span(), "sets", &error.to_string()))?;
        let dimension = self.problem.dimension();
        let fits = spec.dimension() == dimension;
        fits.then_some(spec).ok_or_else(|| {
            let what = format!("'{}' has no points of dimension {dimension}", name.as_ref());
            self.fault(name.span(), "sets", &what)
        })
    }

    fn engine(&self, name: &Spanned<String>, field: &str) -> Result<(), Fault> {
        (self.known)(name.as_ref(), self.problem)
            .map_err(|what| self.fault(name.span(), field, &what))
    }

    fn hold<T: std::fmt::Debug>(
        &self,
        value: &Spanned<T>,
        field: &str,
        otherwise: &str,
        holds: impl Fn(&T) -> bool,
    ) -> Result<(), Fault> {
        if holds(value.as_ref()) {
            return Ok(());
        }
        let what = format!("{:?} {otherwise}", value.as_ref());
        Err(self.fault(value.span(), field, &what))
    }

    fn fault(&self, span: std::ops::Range<usize>, field: &str, what: &str) -> Fault {
        Fault::new(
            self.path,
            self.text,
            span.start,
            &format!("{field}: {what}"),
        )
    }
}

fn plain<T: Clone>(spanned: &Spanned<T>) -> T {
    spanned.as_ref().clone()
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = r#"id = "small"
group = "tests"
task = "hull2"
seed = 1
question = "Does it parse?"

[[cells]]
sets = ["disc"]
n = [100]
engines = ["gs", "eddy"]
measure = ["time"]
twin = "gs"

[left_out]
jarvis-j1 = "slow"
"#;

    fn parse(text: &str) -> Result<Definition, String> {
        let known = |name: &str, _: Problem| match hullkit::method(name) {
            Some(_) => Ok(()),
            None => Err(format!("no engine is called '{name}'")),
        };
        Definition::parse("data/small.toml", text, &known).map_err(|fault| fault.to_string())
    }

    #[test]
    fn a_definition_is_read_whole() {
        let definition = parse(GOOD).expect("valid");
        let block = &definition.cells[0];
        assert_eq!(
            (block.realisations, block.rounds, block.batch(30)),
            (1, 5, 1)
        );
        assert_eq!(definition.left_out["jarvis-j1"], "slow");
        assert_eq!(definition.hash.len(), 64);
    }

    #[test]
    fn only_untimed_cells_of_different_engines_may_be_repeated() {
        let more = |engine: &str, measure: &str| {
            let block = format!(
                "[[cells]]\nsets = [\"disc\"]\nn = [100]\nengines = [\"{engine}\"]\nmeasure = [\"{measure}\"]\n\n[left_out]"
            );
            let counted = GOOD.replace("[\"time\"]", "[\"counts\"]");
            parse(&counted.replace("[left_out]", &block))
        };
        assert!(more("graham", "sizes").is_ok());
        assert!(more("graham", "time").is_err(), "not side by side");
        assert!(more("eddy", "counts").is_err(), "twice");
    }

    #[test]
    fn a_fault_is_named_by_line_and_field() {
        let faults = [
            (
                "sets = [\"disc\"]",
                "sets = [\"disk\"]",
                "data/small.toml:8:9: sets: ",
            ),
            (
                "sets = [\"disc\"]",
                "sets = [\"ball\"]",
                "8:9: sets: 'ball' has no points of dimension 2",
            ),
            (
                "\"eddy\"]",
                "\"eddi\"]",
                "10:18: engines: no engine is called 'eddi'",
            ),
            (
                "twin = \"gs\"",
                "twin = \"graham\"",
                "12:8: twin: \"graham\" is none of the engines",
            ),
            (
                "n = [100]",
                "n = [100, 100]",
                "8:9: sets: 'disc' with n = 100 stands here twice",
            ),
            ("n = [100]", "n = [0]", "9:6: n: 0 must be at least 1"),
            ("n = [100]", "n = []", "n: is an empty list"),
            ("seed = 1", "sedd = 1", "4:1: "),
            ("[\"time\"]", "[\"tune\"]", "11:12: "),
            (
                "\"small\"",
                "\"large\"",
                "1:6: id: \"large\" is not the file's name",
            ),
            ("\"slow\"", "\"\"", "15:13: left_out: \"\" gives no reason"),
        ];
        for (good, bad, expected) in faults {
            let fault = parse(&GOOD.replace(good, bad)).expect_err(bad);
            assert!(fault.contains(expected), "{bad}: {fault}");
        }
    }
}
