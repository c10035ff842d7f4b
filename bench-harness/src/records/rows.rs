//! The rows of a run.

use super::error::Problem;
use super::row::{Fields, Row, one_line};
use serde::Serialize;
use std::fmt;
use std::num::NonZeroU64;
use std::str::FromStr;

/// A point set of an experiment at one size; its seeds are its realisations.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
pub struct Case {
    /// The experiment's definition.
    pub definition: String,
    /// The point set, as the catalogue spells it: `disc`, `oblique:cols=10,rows=10`.
    pub set: String,
    /// The number of points.
    pub n: usize,
}

/// One engine on one realisation of a point set: what every row is about.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Subject {
    /// The point set and its size.
    pub case: Case,
    /// The seed of the realisation.
    pub seed: u64,
    /// A registered method, an outside program, or the twin of one.
    pub engine: String,
}

/// What became of an engine on a point set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Outcome {
    /// The checker proved its result right.
    Certified,
    /// The checker proved its result wrong.
    Wrong,
    /// It declined, with a reason.
    Refused,
    /// It took longer than it was given.
    Timeout,
    /// It ended before it answered.
    Crashed,
    /// It answered what is no answer.
    Garbled,
    /// It is not there.
    Absent,
}

/// What became of one engine on one point set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Which engine on which points.
    pub subject: Subject,
    /// The fingerprint of the points.
    pub fingerprint: String,
    /// What became of it.
    pub outcome: Outcome,
    /// Vertices of the hull.
    pub h: Option<u64>,
    /// Facets of the hull.
    pub facets: Option<u64>,
    /// What was found, in words; empty if there is nothing to say.
    pub finding: String,
}

/// One sample of time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sample {
    /// Which engine on which points.
    pub subject: Subject,
    /// The round: samples of the same round are neighbours in time.
    pub round: u32,
    /// Calls in a row: passes over the sets of a batch, times the sets.
    pub inner: NonZeroU64,
    /// The time of all of them together.
    pub nanoseconds: u64,
}

/// One exact integer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Count {
    /// Which engine on which points.
    pub subject: Subject,
    /// What was counted.
    pub counter: String,
    /// How many.
    pub value: u64,
}

/// Something to be careful about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Which engine on which points.
    pub subject: Subject,
    /// What is the matter.
    pub warning: String,
    /// What to do about it.
    pub remedy: String,
}

/// What the twin of an engine is called after it.
const TWIN: &str = "@twin";

impl Subject {
    /// The engine that this one is a second copy of, if it is one.
    pub fn twin_of(&self) -> Option<&str> {
        twin_of(&self.engine)
    }

    /// The same engine measured once more, as if it were another.
    #[must_use]
    pub fn twin(&self) -> Self {
        Self {
            engine: twin(&self.engine),
            ..self.clone()
        }
    }

    fn fields(&self) -> [String; 4] {
        let Case { definition, set, n } = &self.case;
        [
            definition.clone(),
            set.clone(),
            n.to_string(),
            self.seed.to_string(),
        ]
    }
}

/// The name of `engine` measured once more, as if it were another.
pub fn twin(engine: &str) -> String {
    format!("{engine}{TWIN}")
}

/// The engine that `engine` is the twin of, if it is one: `gs` of `gs@twin`.
///
/// ```
/// use bench_harness::records::rows::twin_of;
/// assert_eq!(twin_of("gs@twin"), Some("gs"));
/// assert_eq!(twin_of("gs"), None);
/// ```
pub fn twin_of(engine: &str) -> Option<&str> {
    engine.strip_suffix(TWIN)
}

impl Sample {
    /// Nanoseconds of one call.
    pub fn per_call(&self) -> f64 {
        self.nanoseconds as f64 / self.inner.get() as f64
    }
}

impl Row for Cell {
    const FILE: &'static str = "cells.csv";
    const HEADER: &'static [&'static str] = &[
        "definition",
        "set",
        "n",
        "seed",
        "fingerprint",
        "engine",
        "outcome",
        "h",
        "facets",
        "finding",
    ];

    fn key(&self) -> String {
        self.subject.to_string()
    }

    fn fields(&self) -> Vec<String> {
        let number = |value: Option<u64>| value.map_or_else(String::new, |value| value.to_string());
        let mut fields = self.subject.fields().to_vec();
        fields.extend([
            self.fingerprint.clone(),
            self.subject.engine.clone(),
            self.outcome.to_string(),
            number(self.h),
            number(self.facets),
            one_line(&self.finding),
        ]);
        fields
    }

    fn parse(fields: &mut Fields<'_>) -> Result<Self, Problem> {
        let (case, seed) = parse_realisation(fields)?;
        let fingerprint = fields.text();
        let engine = fields.name()?;
        Ok(Self {
            subject: Subject { case, seed, engine },
            fingerprint,
            outcome: fields.parse("an outcome (certified, wrong, refused, ...)")?,
            h: fields.optional("a number of vertices")?,
            facets: fields.optional("a number of facets")?,
            finding: fields.text(),
        })
    }
}

impl Row for Sample {
    const FILE: &'static str = "samples.csv";
    const HEADER: &'static [&'static str] = &[
        "definition",
        "set",
        "n",
        "seed",
        "engine",
        "round",
        "inner",
        "nanoseconds",
    ];

    fn key(&self) -> String {
        format!("{}, round {}", self.subject, self.round)
    }

    fn fields(&self) -> Vec<String> {
        let mut fields = self.subject.fields().to_vec();
        fields.extend([
            self.subject.engine.clone(),
            self.round.to_string(),
            self.inner.to_string(),
            self.nanoseconds.to_string(),
        ]);
        fields
    }

    fn parse(fields: &mut Fields<'_>) -> Result<Self, Problem> {
        Ok(Self {
            subject: parse_subject(fields)?,
            round: fields.parse("the number of a round")?,
            inner: fields.parse("a number of calls, 1 or more")?,
            nanoseconds: fields.parse("an integer number of nanoseconds")?,
        })
    }
}

impl Row for Count {
    const FILE: &'static str = "counts.csv";
    const HEADER: &'static [&'static str] = &[
        "definition",
        "set",
        "n",
        "seed",
        "engine",
        "counter",
        "value",
    ];

    fn key(&self) -> String {
        format!("{}, counter {}", self.subject, self.counter)
    }

    fn fields(&self) -> Vec<String> {
        let mut fields = self.subject.fields().to_vec();
        fields.extend([
            self.subject.engine.clone(),
            self.counter.clone(),
            self.value.to_string(),
        ]);
        fields
    }

    fn parse(fields: &mut Fields<'_>) -> Result<Self, Problem> {
        Ok(Self {
            subject: parse_subject(fields)?,
            counter: fields.name()?,
            value: fields.parse("an integer count")?,
        })
    }
}

impl Row for Warning {
    const FILE: &'static str = "warnings.csv";
    const HEADER: &'static [&'static str] = &[
        "definition",
        "set",
        "n",
        "seed",
        "engine",
        "warning",
        "remedy",
    ];

    fn key(&self) -> String {
        format!("{}, warning {:?}", self.subject, self.warning)
    }

    fn fields(&self) -> Vec<String> {
        let mut fields = self.subject.fields().to_vec();
        fields.extend([
            self.subject.engine.clone(),
            one_line(&self.warning),
            one_line(&self.remedy),
        ]);
        fields
    }

    fn parse(fields: &mut Fields<'_>) -> Result<Self, Problem> {
        Ok(Self {
            subject: parse_subject(fields)?,
            warning: fields.name()?,
            remedy: fields.text(),
        })
    }
}

fn parse_realisation(fields: &mut Fields<'_>) -> Result<(Case, u64), Problem> {
    let case = Case {
        definition: fields.name()?,
        set: fields.name()?,
        n: fields.parse("a number of points")?,
    };
    Ok((case, fields.parse("a seed")?))
}

fn parse_subject(fields: &mut Fields<'_>) -> Result<Subject, Problem> {
    let (case, seed) = parse_realisation(fields)?;
    let engine = fields.name()?;
    Ok(Subject { case, seed, engine })
}

/// Every outcome and its word.
const OUTCOMES: [(Outcome, &str); 7] = [
    (Outcome::Certified, "certified"),
    (Outcome::Wrong, "wrong"),
    (Outcome::Refused, "refused"),
    (Outcome::Timeout, "timeout"),
    (Outcome::Crashed, "crashed"),
    (Outcome::Garbled, "garbled"),
    (Outcome::Absent, "absent"),
];

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = OUTCOMES.iter().find(|(outcome, _)| outcome == self);
        f.pad(found.map_or("?", |(_, word)| word))
    }
}

impl FromStr for Outcome {
    type Err = ();

    fn from_str(text: &str) -> Result<Self, ()> {
        let found = OUTCOMES.iter().find(|(_, word)| *word == text);
        found.map(|(outcome, _)| *outcome).ok_or(())
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{} n={}", self.definition, self.set, self.n)
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} on {} seed {}", self.engine, self.case, self.seed)
    }
}
