//! The engine's end of the pipe protocol, version 1 (see bench-harness/PROTOCOL.md).

use serde_json::{Value, json};
use std::collections::HashMap;
use std::fs;
use std::io::{self, BufRead, Write};
use std::time::{Duration, Instant};

/// Points as they came: coordinate by coordinate.
pub struct Points {
    pub task: String,
    pub n: usize,
    pub dimension: usize,
    pub coordinates: Vec<f64>,
}

impl Points {
    pub fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.coordinates.chunks(self.dimension)
    }
}

/// A vertex of a result: a point of the input by its index, or by its coordinates.
pub enum Vertex {
    Index(usize),
    /// The third coordinate is zero in the plane.
    At([f64; 3]),
}

/// A result: its kind, as the protocol names it, and its parts.
pub struct Hull {
    pub kind: &'static str,
    pub parts: Vec<Vec<Vertex>>,
}

/// What computes.
pub trait Engine {
    fn version(&self) -> String;
    fn tasks(&self) -> &'static [&'static str];
    /// Converts sets to the engine's own type of points: not timed.
    fn load(&mut self, sets: &[Points]) -> Result<(), String>;
    /// The time of `passes` passes over the sets; the last result of each is kept.
    fn sample(&mut self, passes: u64) -> Result<Duration, String>;
    /// The last result of set number `set`: not timed.
    fn hull(&self, set: usize) -> Result<Hull, String>;
}

/// A function that computes from its input in memory.
pub struct Call<I, R> {
    pub versions: &'static [&'static str],
    pub tasks: &'static [&'static str],
    pub convert: fn(&Points) -> I,
    pub way: Way<I, R>,
    pub read: fn(&R, &str) -> Hull,
    task: String,
    /// The sets, converted.
    inputs: Vec<I>,
    /// The last result of each.
    results: Vec<Option<R>>,
}

/// How a function takes its input.
pub enum Way<I, R> {
    /// Reads it.
    Reads(fn(&I) -> Result<R, String>),
    /// Reorders it or uses it up: every call gets a copy; those of a pass are made before it, while the clock stands.
    Consumes(fn(I) -> Result<R, String>),
}

impl<I: Clone, R> Call<I, R> {
    pub fn new(
        versions: &'static [&'static str],
        tasks: &'static [&'static str],
        convert: fn(&Points) -> I,
        way: Way<I, R>,
        read: fn(&R, &str) -> Hull,
    ) -> Self {
        Self {
            versions,
            tasks,
            convert,
            way,
            read,
            task: String::new(),
            inputs: Vec::new(),
            results: Vec::new(),
        }
    }
}

impl<I: Clone, R> Engine for Call<I, R> {
    fn version(&self) -> String {
        let versions = self.versions.iter().map(|name| locked_version(name));
        versions.collect::<Vec<_>>().join(", ")
    }

    fn tasks(&self) -> &'static [&'static str] {
        self.tasks
    }

    fn load(&mut self, sets: &[Points]) -> Result<(), String> {
        self.task = sets.first().map(|set| set.task.clone()).unwrap_or_default();
        self.inputs = sets.iter().map(self.convert).collect();
        self.results.clear();
        Ok(())
    }

    fn sample(&mut self, passes: u64) -> Result<Duration, String> {
        if self.inputs.is_empty() {
            return Err("no points were loaded".into());
        }
        self.results.clear();
        self.results.resize_with(self.inputs.len(), || None);
        let mut total = Duration::ZERO;
        match self.way {
            Way::Reads(function) => {
                let start = Instant::now();
                for _ in 0..passes {
                    for (input, result) in self.inputs.iter().zip(&mut self.results) {
                        *result = Some(function(input)?);
                    }
                }
                total = start.elapsed();
            }
            Way::Consumes(function) => {
                for _ in 0..passes {
                    let mut copies = Vec::with_capacity(self.inputs.len());
                    copies.extend(self.inputs.iter().cloned());
                    let start = Instant::now();
                    for (copy, result) in copies.drain(..).zip(&mut self.results) {
                        *result = Some(function(copy)?);
                    }
                    total += start.elapsed();
                }
            }
        }
        Ok(total)
    }

    fn hull(&self, set: usize) -> Result<Hull, String> {
        let result = self.results.get(set).and_then(Option::as_ref);
        let result = result.ok_or("nothing was run, or there is no such set")?;
        Ok((self.read)(result, &self.task))
    }
}

/// Answers commands until `quit` or the end of the input.
pub fn serve(name: &str, engine: &mut dyn Engine) -> io::Result<()> {
    let (mut input, mut output) = (io::stdin().lock(), io::BufWriter::new(io::stdout().lock()));
    let mut sets = Vec::new();
    let mut peak = None;
    let mut line = String::new();
    while input.read_line(&mut line)? > 0 {
        let (word, rest) = line.trim().split_once(' ').unwrap_or((line.trim(), ""));
        let mut arrays = Vec::new();
        let reply = match word {
            "version" => Ok(receipt(name, engine)),
            "load" => {
                sets = read_sets(rest, &mut input)?;
                load(rest, &sets, engine)
            }
            "run" => {
                let before = if peak.is_none() { reset_peak() } else { None };
                let samples = run(rest, engine);
                if let Some(before) = before {
                    peak = without_files("VmHWM:").map(|after| after.saturating_sub(before));
                }
                samples.map(|nanoseconds| json!({ "nanoseconds": nanoseconds }))
            }
            "hull" => hull(rest, &sets, engine, &mut arrays),
            "counters" => Ok(match peak {
                Some(bytes) => json!({ "counters": { "peak_bytes": bytes } }),
                None => json!({ "counters": {} }),
            }),
            "quit" => return Ok(()),
            _ => Err(format!("there is no command {word}")),
        };
        let reply = reply.unwrap_or_else(|reason| json!({ "refused": reason }));
        writeln!(output, "{reply}")?;
        let bytes: Vec<u8> = arrays
            .iter()
            .flat_map(|number: &u32| number.to_le_bytes())
            .collect();
        output.write_all(&bytes)?;
        output.flush()?;
        line.clear();
    }
    Ok(())
}

fn receipt(name: &str, engine: &dyn Engine) -> Value {
    json!({
        "protocol": 1,
        "engine": name,
        "version": engine.version(),
        "clock_ns": clock_resolution(),
        "tasks": engine.tasks(),
        "build": concat!("cargo --release, lto, ", env!("HULLBENCH_OPTIONS")),
    })
}

fn read_sets(header: &str, input: &mut impl BufRead) -> io::Result<Vec<Points>> {
    let header: Value = serde_json::from_str(header)?;
    let sets = header["sets"].as_u64().unwrap_or(1);
    (0..sets).map(|_| read_points(&header, input)).collect()
}

fn read_points(header: &Value, input: &mut impl BufRead) -> io::Result<Points> {
    let number = |name: &str| header[name].as_u64().unwrap_or(0) as usize;
    let (n, dimension) = (number("n"), number("dimension"));
    let mut bytes = vec![0; n * dimension * 8];
    input.read_exact(&mut bytes)?;
    let coordinates = bytes
        .as_chunks()
        .0
        .iter()
        .map(|x| f64::from_le_bytes(*x))
        .collect();
    let task = header["task"].as_str().unwrap_or_default().to_owned();
    Ok(Points {
        task,
        n,
        dimension: dimension.max(1),
        coordinates,
    })
}

fn load(header: &str, sets: &[Points], engine: &mut dyn Engine) -> Result<Value, String> {
    engine.load(&[])?;
    let first = sets.first().ok_or("no sets")?;
    if !engine.tasks().contains(&first.task.as_str()) {
        return Err(format!("does not do {}", first.task));
    }
    if header.contains(r#""boundary":"all""#) {
        return Err("finds extreme points only".into());
    }
    engine.load(sets)?;
    Ok(json!({ "loaded": first.n, "sets": sets.len() }))
}

fn run(header: &str, engine: &mut dyn Engine) -> Result<Vec<u64>, String> {
    let header: Value = serde_json::from_str(header).map_err(|error| error.to_string())?;
    let number = |name: &str| header[name].as_u64().filter(|&number| number > 0);
    let (Some(samples), Some(inner)) = (number("samples"), number("inner")) else {
        return Err("nothing to run".into());
    };
    let sample = |_| engine.sample(inner).map(|time| time.as_nanos() as u64);
    (0..samples).map(sample).collect()
}

/// The header of the last result of a set; its arrays go to `arrays`.
fn hull(
    header: &str,
    sets: &[Points],
    engine: &dyn Engine,
    arrays: &mut Vec<u32>,
) -> Result<Value, String> {
    let header: Value = serde_json::from_str(header).unwrap_or_default();
    let set = header["set"].as_u64().unwrap_or(0) as usize;
    let points = sets.get(set).ok_or("there is no such set")?;
    let hull = engine.hull(set)?;
    arrays.extend(hull.parts.iter().map(|part| part.len() as u32));
    let lengths = arrays.len();
    // Of the copies of a point the smallest index stands for all; the two zeros are alike.
    let mut smallest = HashMap::with_capacity(points.n);
    for (id, row) in (0..).zip(points.rows()) {
        smallest.entry(key(row)).or_insert(id);
    }
    for vertex in hull.parts.iter().flatten() {
        let found = match vertex {
            Vertex::Index(id) => points.rows().nth(*id).map(key),
            Vertex::At(coordinates) => Some(key(coordinates)),
        };
        let id = found.and_then(|key| smallest.get(&key));
        arrays.push(*id.ok_or("a vertex of the result is none of the points")?);
    }
    Ok(json!({ "kind": hull.kind, "lengths": lengths, "indices": arrays.len() - lengths }))
}

/// The bits of coordinates, the two zeros alike.
fn key(coordinates: &[f64]) -> [u64; 3] {
    std::array::from_fn(|axis| coordinates.get(axis).map_or(0, |x| (x + 0.0).to_bits()))
}

/// The version of a crate in our lock file.
fn locked_version(name: &str) -> String {
    let lock = include_str!("../Cargo.lock");
    let after = lock
        .split_once(&format!("name = \"{name}\"\nversion = \""))
        .map(|found| found.1);
    let version = after
        .and_then(|after| after.split('"').next())
        .unwrap_or("unknown");
    version.to_owned()
}

/// The smallest step of the clock that was seen, in nanoseconds.
fn clock_resolution() -> u64 {
    let step = |_| {
        let start = Instant::now();
        loop {
            let step = start.elapsed();
            if !step.is_zero() {
                return step.as_nanos() as u64;
            }
        }
    };
    (0..1000).map(step).min().unwrap_or(0)
}

/// Sets the peak of resident memory back, and tells what is resident, without the pages of files.
fn reset_peak() -> Option<u64> {
    fs::write("/proc/self/clear_refs", "5").ok()?;
    without_files("VmRSS:")
}

/// A size of resident memory without the pages of files, such as code, that are resident now.
fn without_files(label: &str) -> Option<u64> {
    Some(status(label)?.saturating_sub(status("RssFile:")?))
}

/// A size from `/proc/self/status`, in bytes.
fn status(label: &str) -> Option<u64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(label))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024)
}
