//! `incremental-brio` on sets whose points are all extreme, beside sorting as many doubles on the same machine.
//!
//! The sort, S, is a yardstick that moves with the machine. The machine may be shared and noisy, so the figure that
//! counts is the ratio, from rounds in which both run in turn. Timed from points in memory to the canonical hull, the
//! check for finite coordinates included. Aims at a million points of a sphere, a paraboloid and a moment curve, one
//! thread: 16 S and 200 MB.

#![allow(clippy::print_stdout)] // the ratios are this program's result

use geometry_core::{Exact, Hull3, Points, Silent};
use peak_alloc::PeakAlloc;
use std::hint::black_box;
use std::time::{Duration, Instant};

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

const SEED: u64 = 1996;

/// Set, size, rounds.
const ROWS: &[(&str, usize, usize)] = &[
    ("sphere", 1_000, 301),
    ("sphere", 10_000, 51),
    ("sphere", 100_000, 15),
    ("sphere", 1_000_000, 5),
    ("paraboloid", 1_000_000, 5),
    ("moment-curve:spacing=random", 1_000_000, 5),
    ("ball", 1_000_000, 5),
];

fn main() {
    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let only_once = std::env::args().any(|argument| argument == "--test");
    let uncertified = std::env::args().any(|argument| argument == "--uncertified");
    for &(set, n, rounds) in ROWS {
        if only_once && n > 10_000 {
            continue;
        }
        let spec: point_sets::Spec = set.parse().expect("a set of the catalogue");
        let points = spec.generate3(n, SEED).expect("any number of points");
        if !uncertified {
            certify(&points);
        }
        print_row(set, &points, if only_once { 1 } else { rounds });
    }
}

/// Nothing is timed that is not proved.
fn certify(points: &[[f64; 3]]) {
    let hull = hull(points);
    let time = elapsed(|| hull_verify::check::hull3(points, &hull).expect("the hull is right"));
    println!("certified in {:.1} s", time.as_secs_f64());
}

fn hull(points: &[[f64; 3]]) -> Hull3 {
    let points = Points::new(points).expect("the sets are finite");
    incremental::incremental_brio(points, &Exact, &mut Silent).expect("the kernel is exact")
}

fn sorted(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.sort_unstable_by(f64::total_cmp);
    numbers
}

/// Prints medians over rounds, with the least and the greatest ratio, and the most memory above what was there before.
fn print_row(set: &str, points: &[[f64; 3]], rounds: usize) {
    let n = points.len();
    let square: point_sets::Spec = "square".parse().expect("a set of the catalogue");
    let numbers = square.generate(n, SEED).expect("any number of points");
    let numbers: Vec<f64> = numbers.iter().map(|point| point[0]).collect();
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let corners = hull(points).len();
    let megabytes = (MEMORY.peak_usage() - before) as f64 / 1e6;

    let mut samples: Vec<[f64; 3]> = (0..rounds)
        .map(|_| {
            // The sort before and after, as the machine's speed may drift while the hull is made.
            let before = elapsed(|| sorted(numbers.clone()));
            let hull = elapsed(|| hull(points)).as_secs_f64();
            let after = elapsed(|| sorted(numbers.clone()));
            let sort = (before + after).as_secs_f64() / 2.0;
            [hull / sort, hull, sort]
        })
        .collect();
    let [time, sort] = [1, 2].map(|column| {
        samples.sort_by(|a, b| a[column].total_cmp(&b[column]));
        1e3 * samples[rounds / 2][column]
    });
    samples.sort_by(|a, b| a[0].total_cmp(&b[0]));
    println!(
        "{set}: n = {n}, h = {corners}: {time:.3} ms, S = {sort:.3} ms, {:.2} S ({:.2}-{:.2}, {rounds} rounds), {megabytes:.0} MB",
        samples[rounds / 2][0],
        samples[0][0],
        samples[rounds - 1][0],
    );
}

fn elapsed<T>(work: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    start.elapsed()
}
