//! `fast-delaunay` beside sorting as many doubles on the same machine.
//!
//! Points in memory to the canonical triangulation, the check that they are finite included, on one thread, each
//! certified before. The sort is a yardstick that moves with the machine, which may be shared and noisy: so times are those
//! of the processor, least of many rounds in which both run in turn, and what counts is the ratio. Aims at a
//! million points: 15 sorts in a disc, 13 on a circle, 15 on a lattice, which is 0.7 of what CGAL 5.5 takes.
//!
//! The last row is ten million points on one thread and on all, by the clock.
//!
//! `cargo bench -p lifted-delaunay --bench fast_delaunay`, or with words that a row must contain: `-- disc`.

#![allow(clippy::print_stdout)] // the table is this program's result

use cpu_time::ProcessTime;
use geometry_core::{HullError, Points, Triangulation};
use lifted_delaunay::{fast_delaunay, fast_delaunay_parallel};
use peak_alloc::PeakAlloc;
use point_sets::Spec;
use std::hint::black_box;
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const SEED: u64 = 1985;
const SETS: [&str; 5] = ["disc", "circle", "lattice", "square", "normal"];
const SIZES_AND_ROUNDS: [(usize, usize); 3] = [(10_000, 201), (100_000, 51), (1_000_000, 15)];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let only_once = arguments.iter().any(|argument| argument == "--test");
    let is_wanted = |title: &str| {
        let mut words = arguments.iter().filter(|word| !word.starts_with("--"));
        words.all(|word| title.contains(word.as_str()))
    };
    println!("set                triangles      ms  ns/point  sort ms    / sort  peak bytes/point");
    for (n, rounds) in SIZES_AND_ROUNDS {
        for set in SETS {
            let title = format!("{set} {n}");
            if is_wanted(&title) && !(only_once && n > 10_000) {
                print_row(&title, &points(set, n), if only_once { 1 } else { rounds });
            }
        }
    }
    if is_wanted("threads") && !only_once {
        print_threads(&points("disc", 10_000_000));
    }
}

fn points(set: &str, n: usize) -> Vec<[f64; 2]> {
    let spec: Spec = set.parse().expect("a set of the catalogue");
    spec.generate(n, SEED)
        .expect("parameters at their defaults")
}

fn by(
    method: fn(Points<'_, 2>) -> Result<Triangulation, HullError>,
    points: &[[f64; 2]],
) -> Triangulation {
    let points = Points::new(points).expect("the generators make finite points");
    method(points).expect("few points")
}

fn print_row(title: &str, points: &[[f64; 2]], rounds: usize) {
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let triangulation = by(fast_delaunay, points);
    let peak = (MEMORY.peak_usage() - before) / points.len();
    hull_verify::check::delaunay(points, &triangulation)
        .expect("nothing is timed that is not proved");
    let numbers: Vec<f64> = points.iter().map(|point| point[0]).collect();
    let [mut ours, mut sort] = [f64::INFINITY; 2];
    for _ in 0..rounds {
        ours = ours.min(milliseconds(|| by(fast_delaunay, points)));
        let mut numbers = numbers.clone();
        sort = sort.min(milliseconds(|| numbers.sort_unstable_by(f64::total_cmp)));
    }
    println!(
        "{title:<17}{:>11}{ours:>8.2}{:>10.0}{sort:>9.2}{:>10.2}{peak:>18}",
        triangulation.len(),
        1e6 * ours / points.len() as f64,
        ours / sort,
    );
}

fn print_threads(points: &[[f64; 2]]) {
    let least = |method| {
        let times = (0..3).map(|_| {
            let start = Instant::now();
            black_box(by(method, points));
            start.elapsed()
        });
        times.min().unwrap_or(Duration::MAX).as_secs_f64()
    };
    let [one, all] = [least(fast_delaunay), least(fast_delaunay_parallel)];
    println!(
        "threads: disc {}, {one:.2} s on one, {all:.2} s on {}: {:.2} times as fast",
        points.len(),
        rayon::current_num_threads(),
        one / all
    );
}

fn milliseconds<T>(work: impl FnOnce() -> T) -> f64 {
    let start = ProcessTime::now();
    black_box(work());
    1e3 * start.elapsed().as_secs_f64()
}
