//! Yardsticks: work that every reader knows the size of, done on as many points in the same rounds as the hulls.
//!
//! A hull that takes 0.3 sorts takes 0.3 sorts on any machine, within what caches and memory differ in.

use super::answer::Answer;
use super::meter::clock_resolution;
use super::protocol::{Counters, Load, PROTOCOL, Problem, Receipt, Run};
use super::server::Engine;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The seed of the numbers that are sorted.
const SEED: u64 = 2026;

/// So many shares a thread, where several work, as one may be held up.
const SHARES: usize = 4;

/// What a yardstick does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Yardstick {
    /// Sorts n random doubles: `sort_unstable_by(f64::total_cmp)`.
    Sort,
    /// Reads the n points once, for the least and the greatest value of each coordinate.
    Pass,
    /// The same on all threads: over the other, what several gain where memory is read.
    PassParallel,
    /// Multiplies and adds numbers that never leave the registers, 24 times for each point.
    Arithmetic,
    /// The same on all threads: over the other, about the most that several can gain.
    ArithmeticParallel,
}

/// Every yardstick, with what it does in words.
pub const YARDSTICKS: [(Yardstick, &str, &str); 5] = [
    (
        Yardstick::Sort,
        "sort",
        "a yardstick: sorts as many random doubles",
    ),
    (
        Yardstick::Pass,
        "pass",
        "a yardstick: reads the points once for their extremes",
    ),
    (
        Yardstick::PassParallel,
        "pass-parallel",
        "a yardstick: reads the points once for their extremes, on all threads",
    ),
    (
        Yardstick::Arithmetic,
        "arithmetic",
        "a yardstick: 24 multiplications and additions in registers for each point",
    ),
    (
        Yardstick::ArithmeticParallel,
        "arithmetic-parallel",
        "a yardstick: 24 multiplications and additions in registers for each point, on all threads",
    ),
];

impl Yardstick {
    /// The yardstick called `name`.
    pub fn find(name: &str) -> Option<Self> {
        let found = YARDSTICKS.iter().find(|(_, other, _)| *other == name);
        found.map(|(yardstick, ..)| *yardstick)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        let found = YARDSTICKS.iter().find(|(other, ..)| *other == self);
        found.map_or("", |(_, name, _)| *name)
    }

    /// What it does.
    pub fn about(self) -> &'static str {
        let found = YARDSTICKS.iter().find(|(other, ..)| *other == self);
        found.map_or("", |(.., about)| *about)
    }
}

/// A yardstick that answers the protocol.
#[derive(Debug)]
pub struct Measure {
    yardstick: Yardstick,
    dimension: usize,
    /// The coordinates of each set.
    points: Vec<Vec<f64>>,
    /// As many random numbers as each set has points.
    numbers: Vec<Vec<f64>>,
}

impl Measure {
    /// A yardstick without points.
    pub fn new(yardstick: Yardstick) -> Self {
        Self {
            yardstick,
            dimension: 2,
            points: Vec::new(),
            numbers: Vec::new(),
        }
    }

    /// The time of one pass over the sets; copies are made while the clock stands.
    fn pass(&self) -> Duration {
        match self.yardstick {
            Yardstick::Sort => {
                let mut copies = self.numbers.clone();
                let start = Instant::now();
                for numbers in &mut copies {
                    numbers.sort_unstable_by(f64::total_cmp);
                    black_box(numbers);
                }
                start.elapsed()
            }
            Yardstick::Pass => self.timed(|points| self.read(points)),
            Yardstick::PassParallel => self.timed(|points| {
                let count = points.len() / self.dimension;
                points
                    .par_chunks(share(count) * self.dimension)
                    .for_each(|share| self.read(share));
            }),
            Yardstick::Arithmetic => self.timed(|points| compute(points.len() / self.dimension)),
            Yardstick::ArithmeticParallel => self.timed(|points| {
                let count = points.len() / self.dimension;
                let starts = (0..count).into_par_iter().step_by(share(count));
                starts.for_each(|start| compute(share(count).min(count - start)));
            }),
        }
    }

    /// How long `work` takes on all sets.
    fn timed(&self, work: impl Fn(&[f64])) -> Duration {
        let start = Instant::now();
        for points in &self.points {
            work(points);
        }
        start.elapsed()
    }

    fn read(&self, points: &[f64]) {
        match self.dimension {
            2 => drop(black_box(extremes::<2>(points))),
            _ => drop(black_box(extremes::<3>(points))),
        }
    }
}

/// The length of a share of `count` points.
fn share(count: usize) -> usize {
    count.div_ceil(SHARES * rayon::current_num_threads()).max(1)
}

/// How many numbers [`Yardstick::Arithmetic`] holds in registers.
const TERMS: usize = 24;

/// The work of [`Yardstick::Arithmetic`] for `count` points.
fn compute(count: usize) {
    let (factor, step) = black_box((0.5, 1.0));
    let mut terms: [f64; TERMS] = std::array::from_fn(|term| term as f64);
    for _ in 0..count {
        for term in &mut terms {
            *term = *term * factor + step;
        }
    }
    black_box(terms);
}

/// The least and the greatest value of each coordinate.
fn extremes<const D: usize>(coordinates: &[f64]) -> Box<[[f64; D]; 2]> {
    let (points, _) = coordinates.as_chunks::<D>();
    let mut low = [f64::INFINITY; D];
    let mut high = [f64::NEG_INFINITY; D];
    for point in points {
        for axis in 0..D {
            low[axis] = if point[axis] < low[axis] {
                point[axis]
            } else {
                low[axis]
            };
            high[axis] = if point[axis] > high[axis] {
                point[axis]
            } else {
                high[axis]
            };
        }
    }
    Box::new([low, high])
}

impl Engine for Measure {
    fn receipt(&self) -> Receipt {
        Receipt {
            protocol: PROTOCOL,
            engine: self.yardstick.name().to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            clock_ns: clock_resolution(),
            tasks: Problem::ALL.to_vec(),
            build: String::new(),
        }
    }

    fn load(&mut self, load: &Load, coordinates: Vec<f64>) -> Result<(), String> {
        let mut random = ChaCha8Rng::seed_from_u64(SEED);
        self.dimension = load.dimension;
        let numbers = |_| (0..load.n).map(|_| random.random()).collect();
        self.numbers = (0..load.sets.get()).map(numbers).collect();
        // Sets of no points are none.
        let sets = coordinates.chunks_exact(load.coordinates().max(1));
        self.points = sets.map(<[f64]>::to_vec).collect();
        Ok(())
    }

    fn run(&mut self, run: &Run) -> Result<Vec<u64>, String> {
        let sample = |_| {
            let passes = (0..run.inner.get()).map(|_| self.pass());
            passes.sum::<Duration>().as_nanos() as u64
        };
        Ok((0..run.samples.get()).map(sample).collect())
    }

    fn hull(&mut self, _set: u32) -> Result<Answer, String> {
        Err("a yardstick computes no hull".to_owned())
    }

    fn counters(&mut self) -> Result<Counters, String> {
        Ok(Counters::default())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn yardsticks_have_names() {
        for (yardstick, name, _) in YARDSTICKS {
            assert_eq!(Yardstick::find(name), Some(yardstick));
            assert_eq!(yardstick.name(), name);
            assert!(hullkit::method(name).is_none());
        }
    }

    #[test]
    fn extremes_are_those_of_each_coordinate() {
        assert_eq!(
            *extremes::<2>(&[1.0, 5.0, -2.0, 7.0]),
            [[-2.0, 5.0], [1.0, 7.0]]
        );
    }
}
