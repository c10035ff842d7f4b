//! The pipe protocol, version 1: commands, replies, and how they look in the pipe.
//!
//! A command is a line of text: its word, and for `load` and `run` a JSON object. A reply is a line with one JSON
//! object: what was asked for, or `{"refused":"why"}`. Points after `load` and the arrays after `hull` are raw and
//! little-endian. `bench-harness/PROTOCOL.md` is written for those who write the other end.

use geometry_core::Boundary;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;
use std::num::NonZeroU32;
use std::str::FromStr;

/// The version that this program speaks.
pub const PROTOCOL: u32 = 1;

/// What can be asked of an engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Problem {
    /// The convex hull of points of the plane
    Hull2,
    /// The convex hull of points of space
    Hull3,
    /// The convex layers of points of the plane
    Layers,
    /// The Delaunay triangulation of points of the plane
    Delaunay,
}

impl Problem {
    /// Every problem.
    pub const ALL: [Problem; 4] = [
        Problem::Hull2,
        Problem::Hull3,
        Problem::Layers,
        Problem::Delaunay,
    ];

    /// The number of coordinates of a point.
    pub fn dimension(self) -> usize {
        match self {
            Problem::Hull3 => 3,
            Problem::Hull2 | Problem::Layers | Problem::Delaunay => 2,
        }
    }

    /// Its name in the protocol.
    pub fn word(self) -> &'static str {
        match self {
            Problem::Hull2 => "hull2",
            Problem::Hull3 => "hull3",
            Problem::Layers => "layers",
            Problem::Delaunay => "delaunay",
        }
    }

    /// What a registered method computes; `None` for a kind of method that no engine runs.
    pub fn of(method: &geometry_core::Method) -> Option<Self> {
        match method.task {
            geometry_core::Task::PlanarHull(_) => Some(Problem::Hull2),
            geometry_core::Task::SpatialHull(_) => Some(Problem::Hull3),
            geometry_core::Task::PlanarLayers(_) => Some(Problem::Layers),
            geometry_core::Task::Delaunay(_) => Some(Problem::Delaunay),
            _ => None,
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Which boundary points are vertices, as the protocol names it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Convention {
    /// [`Boundary::Extreme`].
    #[default]
    Extreme,
    /// [`Boundary::All`].
    All,
}

impl From<Boundary> for Convention {
    fn from(boundary: Boundary) -> Self {
        match boundary {
            Boundary::Extreme => Convention::Extreme,
            Boundary::All => Convention::All,
        }
    }
}

impl From<Convention> for Boundary {
    fn from(convention: Convention) -> Self {
        match convention {
            Convention::Extreme => Boundary::Extreme,
            Convention::All => Boundary::All,
        }
    }
}

/// What to load: the points follow, `sets * n * dimension` raw `f64`, set by set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Load {
    /// What will be asked about the points.
    pub task: Problem,
    /// How many points each set has.
    pub n: u32,
    /// How many sets follow.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub sets: NonZeroU32,
    /// How many coordinates each has.
    pub dimension: usize,
    /// Which boundary points are vertices.
    #[serde(default)]
    pub boundary: Convention,
}

impl Load {
    /// How many bytes follow, if the dimension is that of the problem and there can be so many.
    pub fn bytes(&self) -> Option<usize> {
        let fits = self.dimension == self.task.dimension();
        let points = (self.n as usize).checked_mul(self.sets.get() as usize)?;
        let bytes = points.checked_mul(self.dimension * size_of::<f64>())?;
        fits.then_some(bytes)
    }

    /// How many coordinates a set has.
    pub fn coordinates(&self) -> usize {
        self.n as usize * self.dimension
    }
}

/// What to time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Run {
    /// How many samples to take.
    pub samples: NonZeroU32,
    /// How many passes over the sets make one sample; with one set these are calls in a row.
    pub inner: NonZeroU32,
}

impl Run {
    /// One pass.
    pub const ONCE: Run = Run {
        samples: NonZeroU32::MIN,
        inner: NonZeroU32::MIN,
    };
}

/// Whose hull to hand over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Which {
    /// The number of the set, from 0.
    pub set: u32,
}

/// A command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Who are you?
    Version,
    /// Take these sets of points.
    Load(Load),
    /// Compute, and tell how long it took.
    Run(Run),
    /// Hand over the hull of a set, of the last run.
    Hull(Which),
    /// Tell whatever was counted.
    Counters,
    /// End.
    Quit,
}

impl Command {
    /// Its first word.
    pub fn word(&self) -> &'static str {
        match self {
            Command::Version => "version",
            Command::Load(_) => "load",
            Command::Run(_) => "run",
            Command::Hull(_) => "hull",
            Command::Counters => "counters",
            Command::Quit => "quit",
        }
    }
}

impl fmt::Display for Command {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())?;
        match self {
            Command::Load(load) => write!(f, " {}", line(load)),
            Command::Run(run) => write!(f, " {}", line(run)),
            Command::Hull(which) if *which != Which::default() => write!(f, " {}", line(which)),
            Command::Version | Command::Hull(_) | Command::Counters | Command::Quit => Ok(()),
        }
    }
}

impl FromStr for Command {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let (word, rest) = text.split_once(' ').unwrap_or((text, ""));
        match word {
            "version" => Ok(Command::Version),
            "load" => parse(rest).map(Command::Load),
            "run" => parse(rest).map(Command::Run),
            "hull" if rest.is_empty() => Ok(Command::Hull(Which::default())),
            "hull" => parse(rest).map(Command::Hull),
            "counters" => Ok(Command::Counters),
            "quit" => Ok(Command::Quit),
            _ => Err(format!("there is no command {word:?}")),
        }
    }
}

/// The reply to `version`: the receipt of what is about to be measured.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Receipt {
    /// The version of the protocol.
    pub protocol: u32,
    /// The name of the engine, as the harness knows it.
    pub engine: String,
    /// The version of what computes.
    pub version: String,
    /// The measured resolution of its clock, in nanoseconds.
    pub clock_ns: u64,
    /// What it can be asked.
    pub tasks: Vec<Problem>,
    /// How it was built: compiler and options, if it knows.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub build: String,
}

/// The reply to `load`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Loaded {
    /// How many points of each set were taken.
    pub loaded: u32,
    /// How many sets were taken: who does not know of sets takes one.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub sets: NonZeroU32,
}

/// The reply to `run`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Samples {
    /// The wall time of each sample.
    pub nanoseconds: Vec<u64>,
}

/// How the parts of a hull are to be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// One part: the vertices of a planar hull, anticlockwise; for collinear points along the line.
    Cycle,
    /// The facets of a spatial hull, each a cycle seen from outside; one part of one, two or more points for a hull of
    /// lower dimension.
    Facets,
    /// Triangles, anticlockwise, of a spatial hull or of a triangulation.
    Triangles,
    /// One part: the set of vertices, in any order.
    Vertices,
    /// The layers, outermost first, each a cycle.
    Layers,
}

/// The reply to `hull`: the arrays follow, first `lengths`, then `indices`, raw `u32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct HullHeader {
    /// How to read the parts.
    pub kind: Kind,
    /// How many parts there are.
    pub lengths: usize,
    /// How many indices all parts have together.
    pub indices: usize,
}

/// The reply to `counters`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counters {
    /// Exact integers by name.
    pub counters: BTreeMap<String, u64>,
}

/// A reply: what was asked for, or why not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Reply<T> {
    /// No, and why.
    Refused {
        /// The reason, in words.
        refused: String,
    },
    /// What was asked for.
    Done(T),
}

/// `value` as one line of JSON, without its end.
pub fn line(value: &impl Serialize) -> String {
    // Maps with keys of text and plain structures: there is nothing here that JSON cannot say.
    serde_json::to_string(value).unwrap_or_default()
}

fn one() -> NonZeroU32 {
    NonZeroU32::MIN
}

// Its form is that which serde asks for.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_one(number: &NonZeroU32) -> bool {
    *number == NonZeroU32::MIN
}

fn parse<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    serde_json::from_str(text).map_err(|error| format!("{text:?} is not understood: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn some(number: u32) -> NonZeroU32 {
        NonZeroU32::new(number).unwrap()
    }

    #[test]
    fn every_command_is_read_as_it_was_written() {
        let load = |boundary, sets| Load {
            task: Problem::Hull2,
            n: 1000,
            sets: some(sets),
            dimension: 2,
            boundary,
        };
        for command in [
            Command::Version,
            Command::Load(load(Convention::Extreme, 1)),
            Command::Load(load(Convention::All, 200)),
            Command::Run(Run {
                samples: some(3),
                inner: some(16),
            }),
            Command::Hull(Which { set: 0 }),
            Command::Hull(Which { set: 7 }),
            Command::Counters,
            Command::Quit,
        ] {
            assert_eq!(command.to_string().parse(), Ok(command));
        }
    }

    #[test]
    fn commands_look_as_they_are_written_down() {
        for text in [
            r#"load {"task":"hull3","n":1000,"dimension":3,"boundary":"extreme"}"#,
            r#"load {"task":"hull2","n":100,"sets":200,"dimension":2,"boundary":"extreme"}"#,
            r#"run {"samples":3,"inner":16}"#,
            "hull",
            r#"hull {"set":7}"#,
        ] {
            let command: Command = text.parse().unwrap();
            assert_eq!(command.to_string(), text);
        }
        let first: Command = r#"hull {"set":0}"#.parse().unwrap();
        assert_eq!(first, Command::Hull(Which::default()));
    }

    #[test]
    fn nonsense_is_no_command() {
        for text in [
            "",
            "haul",
            "run",
            "run {\"samples\":0,\"inner\":1}",
            "run {\"samples\":1}",
            "load {\"task\":\"hull4\",\"n\":1,\"dimension\":4}",
            "load {\"task\":\"hull2\",\"n\":-1,\"dimension\":2}",
            "load {\"task\":\"hull2\",\"n\":1,\"sets\":0,\"dimension\":2}",
            "hull {\"set\":-1}",
            "hull 1",
        ] {
            assert!(text.parse::<Command>().is_err(), "{text:?}");
        }
    }

    #[test]
    fn a_dimension_that_is_not_the_problems_has_no_size() {
        let mut load = Load {
            task: Problem::Hull3,
            n: 7,
            sets: some(5),
            dimension: 3,
            boundary: Convention::Extreme,
        };
        assert_eq!(load.bytes(), Some(5 * 7 * 3 * 8));
        load.dimension = 2;
        assert_eq!(load.bytes(), None);
    }

    #[test]
    fn a_reply_is_what_was_asked_for_or_a_refusal() {
        let read = |text| serde_json::from_str::<Reply<Loaded>>(text).ok();
        let loaded = |loaded, sets| {
            let sets = some(sets);
            Some(Reply::Done(Loaded { loaded, sets }))
        };
        assert_eq!(read(r#"{"loaded":5}"#), loaded(5, 1));
        assert_eq!(read(r#"{"loaded":5,"sets":3}"#), loaded(5, 3));
        let refused = "no room".to_owned();
        assert_eq!(
            read(r#"{"refused":"no room"}"#),
            Some(Reply::Refused { refused })
        );
        assert_eq!(read(r#"{"nanoseconds":[1]}"#), None);
        assert_eq!(read("loaded"), None);
    }
}
