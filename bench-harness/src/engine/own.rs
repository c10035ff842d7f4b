//! Our registered methods as engines.
//!
//! What is timed is the `exact` instance of a method: points that are known to be finite in, the canonical value out.
//! Counts come from the `tallied` instance, in a run of their own.

use super::answer::Answer;
use super::meter::{Peak, clock_resolution};
use super::protocol::{Counters, Load, PROTOCOL, Problem, Receipt, Run};
use super::server::Engine;
use crate::counting::counters;
use geometry_core::{
    Boundary, Counted, Exact, HullError, Method, Point2, Point3, Points, Tally, Task,
};
use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

/// A registered method that answers the protocol.
#[derive(Debug)]
pub struct Own {
    method: &'static Method,
    problem: Problem,
    set: Option<Set>,
    answer: Option<Answer>,
    /// The rise of memory in the first run of all.
    peak: Option<Option<u64>>,
}

/// The points loaded.
#[derive(Debug)]
enum Set {
    Plane(Vec<Point2>, Boundary),
    Space(Vec<Point3>),
}

impl Own {
    /// `method` as an engine; `None` for a kind of method that the protocol has no word for.
    pub fn new(method: &'static Method) -> Option<Self> {
        Some(Self {
            method,
            problem: Problem::of(method)?,
            set: None,
            answer: None,
            peak: None,
        })
    }

    fn set(&self) -> Result<&Set, String> {
        self.set
            .as_ref()
            .ok_or_else(|| "no points were loaded".to_owned())
    }

    /// Takes samples of the method on the points loaded.
    fn sample(&self, run: &Run) -> Result<(Vec<u64>, Answer), String> {
        match (self.method.task, self.set()?) {
            (Task::PlanarHull(task), Set::Plane(points, boundary)) => {
                let points = checked(points)?;
                sample(run, || (task.exact)(points, *boundary))
            }
            (Task::PlanarLayers(task), Set::Plane(points, boundary)) => {
                let points = checked(points)?;
                sample(run, || (task.exact)(points, *boundary))
            }
            (Task::Delaunay(task), Set::Plane(points, _)) => {
                let points = checked(points)?;
                sample(run, || (task.exact)(points))
            }
            (Task::SpatialHull(task), Set::Space(points)) => {
                let points = checked(points)?;
                sample(run, || (task.exact)(points))
            }
            _ => Err("no such run".into()),
        }
    }

    /// Runs the method once more with every question and every step counted.
    fn count(&self) -> Result<BTreeMap<String, u64>, String> {
        let kernel = Counted::new(Exact);
        let mut tally = Tally::default();
        match (self.method.task, self.set()?) {
            (Task::PlanarHull(task), Set::Plane(points, boundary)) => {
                let done = (task.tallied)(checked(points)?, *boundary, &kernel, &mut tally);
                done.map(drop).map_err(refusal)?;
            }
            (Task::PlanarLayers(task), Set::Plane(points, boundary)) => {
                let done = (task.tallied)(checked(points)?, *boundary, &kernel, &mut tally);
                done.map(drop).map_err(refusal)?;
            }
            (Task::SpatialHull(task), Set::Space(points)) => {
                let done = (task.tallied)(checked(points)?, &kernel, &mut tally);
                done.map(drop).map_err(refusal)?;
            }
            // A triangulation has no counted instance.
            _ => return Ok(BTreeMap::new()),
        }
        let counted = counters(&kernel.counts(), &tally).into_iter();
        Ok(counted
            .map(|(name, count)| (name.to_owned(), count))
            .collect())
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
        self.set = None;
        self.answer = None;
        if load.task != self.problem {
            return Err(format!("{} computes {}", self.method.slug, self.problem));
        }
        self.set = Some(match load.dimension {
            2 => {
                let points = coordinates.as_chunks().0.to_vec();
                checked::<2>(&points)?;
                Set::Plane(points, load.boundary.into())
            }
            _ => {
                if Boundary::from(load.boundary) == Boundary::All {
                    return Err("in space only extreme points are vertices".into());
                }
                let points = coordinates.as_chunks().0.to_vec();
                checked::<3>(&points)?;
                Set::Space(points)
            }
        });
        Ok(())
    }

    fn run(&mut self, run: &Run) -> Result<Vec<u64>, String> {
        let (nanoseconds, answer) = if self.peak.is_some() {
            self.sample(run)?
        } else {
            let peak = Peak::begin();
            let sampled = self.sample(run)?;
            self.peak = Some(peak.and_then(|peak| peak.bytes()));
            sampled
        };
        self.answer = Some(answer);
        Ok(nanoseconds)
    }

    fn hull(&mut self) -> Result<Answer, String> {
        self.answer
            .clone()
            .ok_or_else(|| "nothing was run".to_owned())
    }

    fn counters(&mut self) -> Result<Counters, String> {
        let mut counters = self.count()?;
        if let Some(bytes) = self.peak.flatten() {
            counters.insert("peak_bytes".to_owned(), bytes);
        }
        Ok(Counters { counters })
    }
}

/// Samples of `call`, and its last result. Of several calls in a row each frees the result of the one before; the
/// last result is freed when the clock stands.
fn sample<T>(
    run: &Run,
    mut call: impl FnMut() -> Result<T, HullError>,
) -> Result<(Vec<u64>, Answer), String>
where
    for<'a> Answer: From<&'a T>,
{
    let mut nanoseconds = Vec::with_capacity(run.samples.get() as usize);
    let mut last = None;
    for _ in 0..run.samples.get() {
        last = None;
        let start = Instant::now();
        for _ in 0..run.inner.get() {
            last = Some(black_box(call().map_err(refusal)?));
        }
        nanoseconds.push(start.elapsed().as_nanos() as u64);
    }
    let last = last.ok_or("nothing was run")?;
    Ok((nanoseconds, Answer::from(&last)))
}

fn checked<const D: usize>(points: &[[f64; D]]) -> Result<Points<'_, D>, String> {
    Points::new(points).map_err(refusal)
}

fn refusal(error: HullError) -> String {
    error.to_string()
}
