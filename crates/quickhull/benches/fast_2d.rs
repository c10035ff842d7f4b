//! `fast-2d` on the usual sets, beside sorting as many doubles and beside reading as many points.
//!
//! S is `sort_unstable_by(f64::total_cmp)` of n random doubles, P one pass that finds the least and greatest coordinates of
//! the n points. Both move with the machine, so the figures that count are the ratios; each time is the least of
//! several rounds in which all run in turn, as noise only ever adds. Points are in memory, nobody has looked at them,
//! and the time ends with the canonical hull. Aims:
//!
//! | row | aim |
//! |---|---|
//! | disc, 10⁶ | 0.25 S |
//! | disc, 10⁷ | 4 P; on two threads 1.7 times faster |
//! | square, normal, Cauchy, lattice, 10⁶ | 0.15 S |
//! | circle, parabola, 10⁶ | 3 S |
//!
//! `peak` is the most memory allocated at once besides the points, in bytes a point.

#![allow(clippy::print_stdout)] // the table is this program's result

use geometry_core::{Boundary, Hull2, HullError, Point2};
use peak_alloc::PeakAlloc;
use point_sets::Spec;
use quickhull::{convex_hull, convex_hull_parallel};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;
use std::time::Instant;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const SEED: u64 = 1978;

const ROWS: [(&str, usize, usize); 15] = [
    ("disc", 100, 51),
    ("circle", 100, 51),
    ("disc", 1_000, 51),
    ("circle", 1_000, 51),
    ("disc", 1_000_000, 15),
    ("square", 1_000_000, 15),
    ("normal", 1_000_000, 15),
    ("cauchy", 1_000_000, 15),
    ("lattice", 1_000_000, 15),
    ("circle", 1_000_000, 7),
    ("parabola", 1_000_000, 7),
    ("oblique", 1_000_000, 7),
    ("collinear", 1_000_000, 5),
    ("disc", 10_000_000, 5),
    ("square", 10_000_000, 5),
];

fn main() {
    // `cargo test --benches` runs benchmarks with `--test`, to see that they work.
    let only_once = std::env::args().any(|argument| argument == "--test");
    println!("      set        n        h     least time      / S      / P    peak   two threads");
    for (set, n, rounds) in ROWS {
        if only_once {
            Row::measure(set, n.min(10_000), 1).print();
        } else {
            Row::measure(set, n, rounds).print();
        }
    }
}

/// A point set, the least times in milliseconds, and the most memory used in bytes.
struct Row {
    set: &'static str,
    n: usize,
    h: usize,
    hull: f64,
    parallel: f64,
    sort: f64,
    pass: f64,
    peak: usize,
}

impl Row {
    fn measure(set: &'static str, n: usize, rounds: usize) -> Self {
        let spec: Spec = set.parse().expect("a set of the catalogue");
        let points = spec.generate(n, SEED).expect("the set has any size");
        let n = points.len();
        let mut rng = ChaCha8Rng::seed_from_u64(SEED);
        let numbers: Vec<f64> = (0..n).map(|_| rng.random()).collect();
        let two = rayon::ThreadPoolBuilder::new().num_threads(2).build();
        let two = two.expect("two threads can be had");

        let mut row = Self {
            set,
            n,
            h: certified(&points),
            hull: f64::INFINITY,
            parallel: f64::INFINITY,
            sort: f64::INFINITY,
            pass: f64::INFINITY,
            peak: peak(&points),
        };
        // Short runs are repeated, so that the clock's grain does not matter.
        let repeats = (100_000 / n).max(1);
        for _ in 0..rounds {
            let mut lists = vec![numbers.clone(); repeats];
            let sort = || {
                lists
                    .iter_mut()
                    .for_each(|list| list.sort_unstable_by(f64::total_cmp))
            };
            row.sort = row.sort.min(milliseconds(sort) / repeats as f64);
            let least = |old: f64, work: &(dyn Fn() + Sync)| {
                old.min(milliseconds(|| (0..repeats).for_each(|_| work())) / repeats as f64)
            };
            row.pass = least(row.pass, &|| drop(black_box(bounds(black_box(&points)))));
            row.hull = least(row.hull, &|| drop(black_box(hull(black_box(&points)))));
            let parallel = || drop(black_box(convex_hull_parallel(&points, Boundary::Extreme)));
            row.parallel = row
                .parallel
                .min(two.install(|| least(row.parallel, &parallel)));
        }
        row
    }

    fn print(&self) {
        println!(
            "{:>9} {:>8} {:>8} {:>11.4} ms {:>8.3} {:>8.2} {:>7.2} {:>6.2} times faster",
            self.set,
            self.n,
            self.h,
            self.hull,
            self.hull / self.sort,
            self.hull / self.pass,
            self.peak as f64 / self.n as f64,
            self.hull / self.parallel,
        );
    }
}

fn hull(points: &[Point2]) -> Result<Hull2, HullError> {
    convex_hull(points, Boundary::Extreme)
}

/// The number of vertices, once the hull is proved right.
fn certified(points: &[Point2]) -> usize {
    let hull = hull(points).expect("the generator makes finite points");
    let certificate = hull_verify::check::hull2(points, Boundary::Extreme, &hull);
    certificate.expect("nothing is timed that is not proved").h
}

/// The most memory that one run allocates at once.
fn peak(points: &[Point2]) -> usize {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let hull = hull(points);
    let peak = MEMORY.peak_usage().saturating_sub(before);
    drop(hull);
    peak
}

/// The least and the greatest x and y: what no method can do without.
fn bounds(points: &[Point2]) -> [f64; 8] {
    let mut bounds = [f64::INFINITY; 8];
    let (pairs, _) = points.as_flattened().as_chunks::<4>();
    for pair in pairs {
        for (lane, &x) in pair.iter().enumerate() {
            bounds[lane] = if x < bounds[lane] { x } else { bounds[lane] };
            bounds[4 + lane] = if -x < bounds[4 + lane] {
                -x
            } else {
                bounds[4 + lane]
            };
        }
    }
    bounds
}

fn milliseconds(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e3
}
