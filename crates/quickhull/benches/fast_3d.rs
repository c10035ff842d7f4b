//! `fast-3d` beside sorting a million doubles and reading the points once, in the same run.
//!
//! S is `sort_unstable` of a million random doubles, P a pass that finds the least and the greatest coordinates. Both move
//! with the machine, so what counts is the ratio. Each figure is the least of many rounds: the work is the same every
//! time, so what a shared machine adds is only noise. A time is from points in memory to the canonical hull, the check for finite coordinates
//! included, one thread unless the row says two. A row is printed only once its hull is certified. Times are of the processor, but for the row on two threads.
//!
//! `cargo bench -p quickhull --bench fast_3d`, or with words that a row must contain: `-- ball 1000.`.

#![allow(clippy::print_stdout)] // the table is this program's result

use cpu_time::ProcessTime;
use geometry_core::{Exact, Hull3, Point3, Points, Silent};
use peak_alloc::PeakAlloc;
use point_sets::Spec;
use std::hint::black_box;
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const SEED: u64 = 1996;

/// The set, its size, and the rounds.
const ROWS: &[(&str, usize, usize)] = &[
    ("ball", 1_000, 5_001),
    ("sphere", 1_000, 1_001),
    ("ball", 10_000, 501),
    ("ball", 100_000, 101),
    ("ball", 1_000_000, 31),
    ("cube", 1_000_000, 21),
    ("normal3", 1_000_000, 21),
    ("cauchy3", 1_000_000, 21),
    ("cubic-lattice", 1_000_000, 21),
    ("cube-faces", 1_000_000, 21),
    ("ball", 10_000_000, 7),
    ("sphere", 100_000, 5),
];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let only_once = arguments.iter().any(|argument| argument == "--test");
    let words: Vec<&String> = arguments
        .iter()
        .filter(|argument| !argument.starts_with("--"))
        .collect();
    let numbers: Vec<f64> = points("cube", 1_000_000)
        .iter()
        .map(|point| point[0])
        .collect();
    println!(
        "{:24}{:>9}{:>11}{:>9}{:>9}{:>9}{:>10}",
        "set", "h", "ms", "S", "P", "S(n)", "peak MB"
    );
    for &(name, n, rounds) in ROWS {
        let title = format!("{name} {n}.");
        if (only_once && n > 100_000) || !words.iter().all(|word| title.contains(word.as_str())) {
            continue;
        }
        let points = points(name, n);
        let vertices = certified(&points);
        let row = Row::measured(&points, &numbers, if only_once { 1 } else { rounds });
        println!(
            "{title:24}{vertices:9}{:11.4}{:9.3}{:9.2}{:9.3}{:10.1}",
            1e3 * row.hull,
            row.hull / row.sort,
            row.hull / row.pass,
            row.hull / row.own_sort,
            row.peak
        );
    }
    if !only_once && words.is_empty() || words.iter().any(|word| *word == "threads") {
        print_two_threads("ball", 10_000_000);
    }
}

/// The two-thread row: wall clock against wall clock, on pools of one and of two threads.
fn print_two_threads(name: &str, n: usize) {
    let points = points(name, n);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("a pool of threads");
        let times = (0..9).map(|_| {
            let start = Instant::now();
            black_box(pool.install(|| quickhull::fast_3d_parallel(&points, &Exact)))
                .expect("a hull");
            start.elapsed()
        });
        1e3 * least(times.collect())
    };
    let [one, two] = [1, 2].map(on);
    println!(
        "{name} {n}: one thread {one:.1} ms, two {two:.1} ms, ratio {:.2}",
        one / two
    );
}

fn points(name: &str, n: usize) -> Vec<Point3> {
    let spec: Spec = name.parse().expect("a set of the catalogue");
    spec.generate3(n, SEED).expect("a set of space")
}

/// The number of vertices, once the hull is proved right.
fn certified(points: &[Point3]) -> usize {
    let hull = hull(points);
    hull_verify::check::hull3(points, &hull).expect("nothing is timed that is not proved");
    hull.len()
}

fn hull(points: &[Point3]) -> Hull3 {
    let points = Points::new(points).expect("the generator makes finite points");
    quickhull::fast_3d(points, &Exact, &mut Silent).expect("the exact kernel is consistent")
}

/// The least times, in seconds, and the peak of memory allocated by the hull, in megabytes.
struct Row {
    hull: f64,
    sort: f64,
    own_sort: f64,
    pass: f64,
    peak: f64,
}

impl Row {
    fn measured(points: &[Point3], numbers: &[f64], rounds: usize) -> Self {
        let before = MEMORY.current_usage_as_mb();
        MEMORY.reset_peak_usage();
        black_box(hull(points));
        let peak = f64::from(MEMORY.peak_usage_as_mb() - before);
        let mut hulls = Vec::new();
        let mut passes = Vec::new();
        for _ in 0..rounds {
            passes.push(elapsed(|| extremes(points)));
            hulls.push(elapsed(|| hull(points)));
        }
        let sorts = (0..rounds.clamp(7, 21)).map(|_| sorting(numbers)).collect();
        let own: Vec<f64> = points.iter().map(|point| point[0]).collect();
        let own_sorts = (0..rounds.clamp(7, 21)).map(|_| sorting(&own)).collect();
        Self {
            hull: least(hulls),
            sort: least(sorts),
            own_sort: least(own_sorts),
            pass: least(passes),
            peak,
        }
    }
}

fn sorting(numbers: &[f64]) -> Duration {
    let mut numbers = numbers.to_vec();
    elapsed(|| numbers.sort_unstable_by(f64::total_cmp))
}

fn extremes(points: &[Point3]) -> [Point3; 2] {
    points.iter().fold(
        [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]],
        |[low, high], p| {
            [
                [0, 1, 2].map(|i| if p[i] < low[i] { p[i] } else { low[i] }),
                [0, 1, 2].map(|i| if p[i] > high[i] { p[i] } else { high[i] }),
            ]
        },
    )
}

fn elapsed<T>(work: impl FnOnce() -> T) -> Duration {
    let start = ProcessTime::now();
    black_box(work());
    start.elapsed()
}

fn least(samples: Vec<Duration>) -> f64 {
    samples.into_iter().min().unwrap_or_default().as_secs_f64()
}
