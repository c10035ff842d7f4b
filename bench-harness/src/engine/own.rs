//! Our registered methods as engines.
//!
//! What is timed is what a user pays for `hullkit::convex_hull_2d(&points)` and its like: the check that every
//! coordinate is finite included, the `unseen` instance of the method; a slice in, the canonical value out.
//! Counts come from the `tallied` instance, in a run of their own, and are summed over the sets.

use super::answer::Answer;
use super::meter::{Peak, clock_resolution};
use super::protocol::{Counters, Load, PROTOCOL, Problem, Receipt, Run};
use super::server::Engine;
use crate::counting::{self, count_in_plane, count_in_space};
use geometry_core::{Boundary, HullError, Method, Point2, Point3, Points, Task};
use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

/// A registered method that answers the protocol.
#[derive(Debug)]
pub struct Own {
    method: &'static Method,
    problem: Problem,
    batch: Option<Batch>,
    /// The last result of each set; empty before the first run.
    answers: Vec<Answer>,
    /// The rise of memory in the first run of all.
    peak: Option<Option<u64>>,
}

/// The sets loaded.
#[derive(Debug)]
enum Batch {
    Plane(Vec<Vec<Point2>>, Boundary),
    Space(Vec<Vec<Point3>>),
}

impl Own {
    /// `method` as an engine; `None` for a kind of method that the protocol has no word for.
    pub fn new(method: &'static Method) -> Option<Self> {
        Some(Self {
            method,
            problem: Problem::of(method)?,
            batch: None,
            answers: Vec::new(),
            peak: None,
        })
    }

    fn batch(&self) -> Result<&Batch, String> {
        let batch = self.batch.as_ref();
        batch.ok_or_else(|| "no points were loaded".to_owned())
    }

    /// Takes samples of the method on the sets loaded; the clock sees all of a call, the check of the points included.
    fn sample(&self, run: &Run, meter: Option<Peak>) -> Result<Sampled, String> {
        match (self.method.task, self.batch()?) {
            (Task::PlanarHull(task), Batch::Plane(sets, boundary)) => {
                sample(run, meter, sets, |set| (task.unseen)(set, *boundary))
            }
            (Task::PlanarLayers(task), Batch::Plane(sets, boundary)) => {
                sample(run, meter, sets, |set| (task.unseen)(set, *boundary))
            }
            (Task::Delaunay(task), Batch::Plane(sets, _)) => {
                sample(run, meter, sets, |set| (task.unseen)(set))
            }
            (Task::SpatialHull(task), Batch::Space(sets)) => {
                sample(run, meter, sets, |set| (task.unseen)(set))
            }
            _ => Err("no such run".into()),
        }
    }

    /// Runs the method once more on each set with every question and every step counted.
    fn count(&self) -> Result<BTreeMap<String, u64>, String> {
        let task = self.method.task;
        match self.batch()? {
            Batch::Plane(sets, boundary) => {
                summed(sets, |set| count_in_plane(task, set, *boundary))
            }
            Batch::Space(sets) => summed(sets, |set| count_in_space(task, set)),
        }
    }
}

impl Engine for Own {
    fn receipt(&self) -> Receipt {
        Receipt {
            protocol: PROTOCOL,
            engine: self.method.slug.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            clock_ns: clock_resolution(),
            tasks: vec![self.problem],
            build: String::new(),
        }
    }

    fn load(&mut self, load: &Load, coordinates: Vec<f64>) -> Result<(), String> {
        self.batch = None;
        self.answers.clear();
        if load.task != self.problem {
            return Err(format!("{} computes {}", self.method.slug, self.problem));
        }
        self.batch = Some(match load.dimension {
            2 => Batch::Plane(cut(load, &coordinates)?, load.boundary.into()),
            _ => {
                if Boundary::from(load.boundary) == Boundary::All {
                    return Err("in space only extreme points are vertices".into());
                }
                Batch::Space(cut(load, &coordinates)?)
            }
        });
        Ok(())
    }

    fn run(&mut self, run: &Run) -> Result<Vec<u64>, String> {
        // Only the first run tells.
        let meter = match self.peak {
            None => Peak::begin(),
            Some(_) => None,
        };
        let sampled = self.sample(run, meter)?;
        self.peak.get_or_insert(sampled.peak);
        self.answers = sampled.answers;
        Ok(sampled.nanoseconds)
    }

    fn hull(&mut self, set: u32) -> Result<Answer, String> {
        if self.answers.is_empty() {
            return Err("nothing was run".to_owned());
        }
        let answer = self.answers.get(set as usize);
        let no_such = || format!("there is no set {set} of {}", self.answers.len());
        answer.cloned().ok_or_else(no_such)
    }

    fn counters(&mut self) -> Result<Counters, String> {
        let mut counters = self.count()?;
        if let Some(bytes) = self.peak.flatten() {
            counters.insert("peak_bytes".to_owned(), bytes);
        }
        Ok(Counters { counters })
    }
}

/// What was sampled.
struct Sampled {
    nanoseconds: Vec<u64>,
    /// The last result of each set.
    answers: Vec<Answer>,
    /// The rise of memory, if there was a meter.
    peak: Option<u64>,
}

/// Samples of `call`. A call frees the result of the call for the same set in the pass before; the results of the last pass
/// are freed when the clock stands.
fn sample<S, T>(
    run: &Run,
    meter: Option<Peak>,
    sets: &[S],
    call: impl Fn(&S) -> Result<T, HullError>,
) -> Result<Sampled, String>
where
    for<'a> Answer: From<&'a T>,
{
    let mut nanoseconds = Vec::with_capacity(run.samples.get() as usize);
    let mut last: Vec<Option<T>> = sets.iter().map(|_| None).collect();
    for _ in 0..run.samples.get() {
        last.fill_with(|| None);
        let start = Instant::now();
        for _ in 0..run.inner.get() {
            for (set, last) in sets.iter().zip(&mut last) {
                *last = Some(black_box(call(set).map_err(refusal)?));
            }
        }
        nanoseconds.push(start.elapsed().as_nanos() as u64);
    }
    let peak = meter.and_then(|meter| meter.bytes());
    Ok(Sampled {
        nanoseconds,
        answers: last.iter().flatten().map(Answer::from).collect(),
        peak,
    })
}

/// What is counted of each set, summed.
fn summed<const D: usize>(
    sets: &[Vec<[f64; D]>],
    count: impl Fn(&[[f64; D]]) -> Result<Option<counting::Counters>, HullError>,
) -> Result<BTreeMap<String, u64>, String> {
    let mut sums = BTreeMap::new();
    for set in sets {
        for (name, count) in count(set).map_err(refusal)?.unwrap_or_default() {
            *sums.entry(name.to_owned()).or_default() += count;
        }
    }
    Ok(sums)
}

/// The sets of `load`, each of finite points in memory of its own.
fn cut<const D: usize>(load: &Load, coordinates: &[f64]) -> Result<Vec<Vec<[f64; D]>>, String> {
    let mut rest = coordinates;
    let sets = (0..load.sets.get()).map(|_| {
        let (set, after) = rest.split_at(load.coordinates().min(rest.len()));
        rest = after;
        let points = set.as_chunks().0.to_vec();
        Points::<D>::new(&points).map_err(refusal)?;
        Ok(points)
    });
    sets.collect()
}

fn refusal(error: HullError) -> String {
    error.to_string()
}
