//! `fast-layers` beside sorting as many doubles on the same machine.
//!
//! The sort is a yardstick that moves with the machine: S(n) is the time of `sort_unstable_by(f64::total_cmp)` of n
//! random doubles. The machine may be shared and noisy, so the figure that counts is the ratio of the least times of
//! rounds in which both run in turn. Aims: 40 sorts for 10⁵ and for 10⁶ points in a disc, one thread.
//!
//! Each row is certified before it is timed, which takes O(n log h); the time of that is printed, too, and the
//! orientations asked, which are equal on every machine. The peak of memory is that of the process after the first
//! run, the points included, where the system tells it; a row shows only what exceeds earlier rows.

#![allow(clippy::print_stdout)] // the ratios are this program's result

use geometry_core::{Boundary, Counted, Exact, Layers, Points, Silent};
use hull_verify::families::{curves, grids, random};
use planar_peeling::fast_layers::fast_layers;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;
use std::time::{Duration, Instant};

const SEED: u64 = 1985;

fn main() {
    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let only_once = std::env::args().any(|argument| argument == "--test");
    let disc = |n| random::disc(SEED, n);
    row("disc", &disc(1_000), if only_once { 1 } else { 301 });
    row("disc", &disc(10_000), if only_once { 1 } else { 61 });
    if only_once {
        return;
    }
    if std::env::args().any(|a| a == "--quick") {
        row("disc", &disc(100_000), 7);
        return;
    }
    if std::env::args().any(|a| a == "--big") {
        row("disc", &disc(1_000_000), 5);
        return;
    }
    row("disc", &disc(100_000), 15);
    row("square", &random::square(SEED, 100_000), 15);
    row("normal", &normal(100_000), 15);
    row("lattice", &grids::lattice(316), 15);
    row("nested triangles", &curves::nested_triangles(33_333), 15);
    row("circle", &curves::circle(100_000), 15);
    row("disc", &disc(1_000_000), 5);
}

/// Certifies and times the layers of `points`, in turn with the sort, and prints the least times.
fn row(name: &str, points: &[[f64; 2]], rounds: usize) {
    let n = points.len();
    let numbers = random_numbers(n);
    let found = layers(points);
    let memory = peak_memory();
    let start = Instant::now();
    hull_verify::check::layers(points, Boundary::Extreme, &found)
        .expect("nothing is timed that is not proved");
    let certified = start.elapsed();
    let mut least = [Duration::MAX; 2];
    for _ in 0..rounds {
        let numbers = numbers.clone();
        let times = [elapsed(|| layers(points)), elapsed(|| sorted(numbers))];
        least = [0, 1].map(|i| least[i].min(times[i]));
    }
    let [time, sort] = least.map(|time| 1e3 * time.as_secs_f64());
    println!(
        "{name} {n}: {time:.2} ms, S = {sort:.3} ms, ratio {:.1}; {} layers, certified in {certified:.0?}; \
         {:.2} n log2 n orientations; peak memory {memory}",
        time / sort,
        found.len(),
        orientations(points) / (n as f64 * (n as f64).log2()),
    );
}

fn layers(points: &[[f64; 2]]) -> Layers {
    let points = Points::new(points).expect("the generators make finite points");
    fast_layers(points, Boundary::Extreme, &Exact, &mut Silent).expect("there are no errors")
}

/// How many orientations are asked.
fn orientations(points: &[[f64; 2]]) -> f64 {
    let kernel = Counted::new(Exact);
    let points = Points::new(points).expect("the generators make finite points");
    fast_layers(points, Boundary::Extreme, &kernel, &mut Silent).expect("there are no errors");
    kernel.counts().orientations.total() as f64
}

fn random_numbers(n: usize) -> Vec<f64> {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    (0..n).map(|_| rng.random()).collect()
}

fn sorted(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.sort_unstable_by(f64::total_cmp);
    numbers
}

/// Two independent normal coordinates, by the method of Box and Muller.
fn normal(n: usize) -> Vec<[f64; 2]> {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let mut point = || {
        let radius = (-2.0 * (1.0 - rng.random::<f64>()).ln()).sqrt();
        let (sine, cosine) = (std::f64::consts::TAU * rng.random::<f64>()).sin_cos();
        [radius * cosine, radius * sine]
    };
    (0..n).map(|_| point()).collect()
}

/// The most memory that this process ever held, from Linux's `/proc`.
fn peak_memory() -> String {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    peak.unwrap_or("unknown").trim().to_owned()
}

fn elapsed<T>(work: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    start.elapsed()
}
