//! `quickhull-3d` on a million points in a ball and on a sphere, beside sorting a million doubles on the same machine.
//!
//! The sort is a yardstick that moves with the machine. The machine may be shared and noisy, so the figure that
//! counts is the ratio, from rounds in which both run in turn. Aims: 12 sorts in a ball, 80 on a sphere, one thread.

#![allow(clippy::print_stdout)] // the ratios are this program's result; Criterion has no place for them

use criterion::{BatchSize, Criterion, Throughput};
use geometry_core::{Exact, Hull3, Points, Silent};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;
use std::time::{Duration, Instant};

const N: usize = 1_000_000;
const SEED: u64 = 1996;

fn main() {
    let ball = uniform_in_ball();
    let sphere: Vec<[f64; 3]> = ball.iter().map(onto_sphere).collect();
    let numbers: Vec<f64> = ball.iter().map(|point| point[0]).collect();
    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let only_once = std::env::args().any(|argument| argument == "--test");
    for (name, points, rounds) in [("ball", &ball, 21), ("sphere", &sphere, 5)] {
        let vertices = certified(points);
        println!("{name}: n = {N}, h = {vertices}, seed {SEED}: hull certified");
        print_ratio(name, points, &numbers, if only_once { 1 } else { rounds });
    }

    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    let mut group = criterion.benchmark_group("quickhull-3d-1e6");
    group.throughput(Throughput::Elements(N as u64));
    group.bench_function("ball", |bencher| bencher.iter(|| hull(&ball)));
    group.bench_function("sort_unstable", |bencher| {
        bencher.iter_batched(|| numbers.clone(), sorted, BatchSize::LargeInput);
    });
    group.finish();
    criterion.final_summary();
}

/// `N` points uniform in the unit ball, by rejection from the cube.
fn uniform_in_ball() -> Vec<[f64; 3]> {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let cube = std::iter::repeat_with(|| [0, 1, 2].map(|_| rng.random_range(-1.0..1.0)));
    cube.filter(|&point| square(point) < 1.0).take(N).collect()
}

fn onto_sphere(point: &[f64; 3]) -> [f64; 3] {
    point.map(|x| x / square(*point).sqrt())
}

fn square([x, y, z]: [f64; 3]) -> f64 {
    x * x + y * y + z * z
}

/// The number of vertices, once the hull is proved right.
fn certified(points: &[[f64; 3]]) -> usize {
    let hull = hull(points);
    hull_verify::check::hull3(points, &hull).expect("nothing is timed that is not proved");
    hull.len()
}

fn hull(points: &[[f64; 3]]) -> Hull3 {
    let points = Points::new(points).expect("the generator makes finite points");
    quickhull::quickhull_3d(points, &Exact, &mut Silent).expect("the exact kernel is consistent")
}

fn sorted(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.sort_unstable_by(f64::total_cmp);
    numbers
}

/// Prints the median over rounds of the ratio of the hull to the sort, with the least and the greatest.
fn print_ratio(name: &str, points: &[[f64; 3]], numbers: &[f64], rounds: usize) {
    let mut samples: Vec<[f64; 3]> = (0..rounds)
        .map(|_| {
            // The sort before and after, as the machine's speed may drift while the hull is made.
            let before = elapsed(|| sorted(numbers.to_vec()));
            let hull = elapsed(|| hull(points)).as_secs_f64();
            let after = elapsed(|| sorted(numbers.to_vec()));
            let sort = (before + after).as_secs_f64() / 2.0;
            [hull / sort, hull, sort]
        })
        .collect();
    let [times, sorts] = [1, 2].map(|column| {
        samples.sort_by(|a, b| a[column].total_cmp(&b[column]));
        1e3 * samples[rounds / 2][column]
    });
    samples.sort_by(|a, b| a[0].total_cmp(&b[0]));
    println!(
        "{name}: {times:.1} ms, sort {sorts:.1} ms, ratio {:.2} (all {:.2}-{:.2}, {rounds} rounds)",
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
