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
//! [`find`] says where definitions lie, `read` turns a text into one, [`fault`] what is wrong with one, by file, line and field.

pub(crate) mod fault;
pub(crate) mod find;
mod read;

use crate::engine::catalogue;
use crate::engine::protocol::{Convention, Problem};
use crate::failure::Failure;
use find::Source;
use serde::Deserialize;
use std::collections::BTreeMap;

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
