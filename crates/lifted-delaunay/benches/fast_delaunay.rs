//! `fast-delaunay` beside sorting as many doubles on the same machine.
//!
//! Points in memory to the canonical triangulation, the check that they are finite included. The sort is a yardstick
//! that moves with the machine, which may be shared and noisy: the figure that counts is the ratio, from rounds in which
//! both run in turn. Aim at a million points: 15 sorts in a disc, 13 on a circle, on one thread; that is 0.7 of what
//! CGAL 5.5 takes.

#![allow(clippy::print_stdout)] // the ratios are this program's result

use geometry_core::{Points, Triangulation};
use lifted_delaunay::fast_delaunay;
use point_sets::Spec;
use std::hint::black_box;
use std::time::{Duration, Instant};

const SEED: u64 = 1985;
const SETS: [&str; 5] = ["disc", "circle", "lattice", "square", "normal"];
const SIZES_AND_ROUNDS: [(usize, usize); 3] = [(10_000, 101), (100_000, 31), (1_000_000, 11)];

fn main() {
    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let only_once = std::env::args().any(|argument| argument == "--test");
    println!(
        "      n  set       triangles  certified     ms   ns a point   sort ms   / sort (95 %)"
    );
    for (n, rounds) in SIZES_AND_ROUNDS {
        for set in SETS {
            let spec: Spec = set.parse().expect("a set of the catalogue");
            let points = spec
                .generate(n, SEED)
                .expect("parameters at their defaults");
            print_row(set, &points, if only_once { 1 } else { rounds });
        }
        if only_once {
            break;
        }
    }
}

fn triangulated(points: &[[f64; 2]]) -> Triangulation {
    let points = Points::new(points).expect("the generators make finite points");
    fast_delaunay(points).expect("few points")
}

/// Certifies the triangulation, times it and a sort in turn, each first in every other round, and prints the medians, and that
/// of the ratio.
fn print_row(set: &str, points: &[[f64; 2]], rounds: usize) {
    let certificate = hull_verify::check::delaunay(points, &triangulated(points))
        .expect("nothing is timed that is not proved");
    let numbers: Vec<f64> = points.iter().map(|point| point[0]).collect();
    let time_sort = || {
        let mut numbers = numbers.clone();
        elapsed(|| {
            numbers.sort_unstable_by(f64::total_cmp);
            numbers
        })
    };
    let time = || elapsed(|| triangulated(points));
    let samples: Vec<[f64; 2]> = (0..rounds)
        .map(|round| {
            let (ours, sort) = if round % 2 == 0 {
                let ours = time();
                (ours, time_sort())
            } else {
                let sort = time_sort();
                (time(), sort)
            };
            [ours, sort].map(|time| 1e3 * time.as_secs_f64())
        })
        .collect();
    let sorted = |value: fn(&[f64; 2]) -> f64| {
        let mut values: Vec<f64> = samples.iter().map(value).collect();
        values.sort_by(f64::total_cmp);
        values
    };
    let [ours, sort] = [sorted(|s| s[0]), sorted(|s| s[1])].map(|values| values[rounds / 2]);
    let ratios = sorted(|s| s[0] / s[1]);
    // Order statistics around the median of a binomial: half the rounds, plus and minus 1.96 standard deviations.
    let margin = (0.98 * (rounds as f64).sqrt()).ceil() as usize;
    println!(
        "{:>7}  {set:<8} {:>10}        yes {ours:>7.1} {:>12.0} {sort:>9.2}   {:.2} ({:.2} to {:.2})",
        points.len(),
        certificate.triangles,
        1e6 * ours / points.len() as f64,
        ratios[rounds / 2],
        ratios[(rounds / 2).saturating_sub(margin)],
        ratios[(rounds / 2 + margin).min(rounds - 1)],
    );
}

/// What one triangulation adds to the memory in use at its peak, where the system tells it in a file. To be asked
/// before anything larger is done.
fn print_peak_memory() {
    let spec: Spec = "disc".parse().expect("a set of the catalogue");
    let points = spec
        .generate(1_000_000, SEED)
        .expect("parameters at their defaults");
    let kibibytes = |field: &str| -> Option<u64> {
        let status = std::fs::read_to_string("/proc/self/status").ok()?;
        let line = status.lines().find(|line| line.starts_with(field))?;
        line.split_whitespace().nth(1)?.parse().ok()
    };
    let before = kibibytes("VmRSS:");
    let triangulation = triangulated(&points);
    if let (Some(before), Some(peak)) = (before, kibibytes("VmHWM:")) {
        let bytes = 1024 * (peak - before) / points.len() as u64;
        let triangles = triangulation.len();
        println!("peak memory: {bytes} bytes a point, in a disc, for {triangles} triangles");
    }
}

fn elapsed<T>(work: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    start.elapsed()
}
