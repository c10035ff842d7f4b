//! A definition from its text: what is written, what must hold of it, what is meant.

use super::fault::Fault;
use super::{Block, Definition, Known, Measure};
use crate::engine::protocol::{Convention, Problem};
use serde::Deserialize;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, HashMap, HashSet};
use std::str::FromStr;
use toml::Spanned;

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
