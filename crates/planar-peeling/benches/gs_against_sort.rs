//! Method GS on a million points uniform in a disc, beside sorting a million doubles on the same machine.
//!
//! A hull of points that are mostly interior should cost about as much as one sort of as many numbers. The machine
//! may be shared and noisy, so the figure that counts is the ratio, from rounds in which both run in turn.

#![allow(clippy::print_stdout)] // the ratio is this program's result; Criterion has no place for it

use criterion::{BatchSize, Criterion, Throughput};
use geometry_core::{Boundary, Exact, Hull2, Points, Silent};
use planar_peeling::gs::{gs, gs_bare};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::hint::black_box;
use std::time::{Duration, Instant};

const N: usize = 1_000_000;
const SEED: u64 = 1979;
const ROUNDS: usize = 31;

fn main() {
    let points = uniform_in_disc();
    let numbers: Vec<f64> = points.iter().map(|point| point[0]).collect();
    let vertices = certified(&points);
    println!("n = {N}, h = {vertices}, seed {SEED}: hull certified");

    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let rounds = if std::env::args().any(|argument| argument == "--test") {
        1
    } else {
        ROUNDS
    };
    let time = |method: fn(&[[f64; 2]]) -> Hull2| {
        let points = points.clone();
        elapsed(|| method(&points))
    };
    let time_sort = || {
        let numbers = numbers.clone();
        elapsed(|| sorted(numbers))
    };
    print_ratio("gs / sort", rounds, || time(hull), time_sort);
    // The paper: the cost of enabling successive peels is negligible.
    print_ratio("gs / gs-bare", rounds, || time(hull), || time(hull_bare));
    print_ratio("gs / gs (noise)", rounds, || time(hull), || time(hull));

    let mut criterion = Criterion::default().configure_from_args().sample_size(20);
    let mut group = criterion.benchmark_group("disc-1e6");
    group.throughput(Throughput::Elements(N as u64));
    group.bench_function("gs", |bencher| {
        bencher.iter_batched(
            || points.clone(),
            |points| hull(&points),
            BatchSize::LargeInput,
        );
    });
    group.bench_function("sort_unstable", |bencher| {
        bencher.iter_batched(|| numbers.clone(), sorted, BatchSize::LargeInput);
    });
    group.finish();
    criterion.final_summary();
}

/// `N` points uniform in the unit disc, by rejection from the square.
fn uniform_in_disc() -> Vec<[f64; 2]> {
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let square = std::iter::repeat_with(|| [0, 1].map(|_| rng.random_range(-1.0..1.0)));
    square
        .filter(|[x, y]| x * x + y * y < 1.0)
        .take(N)
        .collect()
}

/// The number of vertices, once the hull is proved right.
fn certified(points: &[[f64; 2]]) -> usize {
    let hull = hull(points);
    let certificate = hull_verify::check::hull2(points, Boundary::Extreme, &hull);
    certificate.expect("nothing is timed that is not proved").h
}

fn hull(points: &[[f64; 2]]) -> Hull2 {
    let points = Points::new(points).expect("the generator makes finite points");
    gs(points, Boundary::Extreme, &Exact, &mut Silent).expect("the exact kernel is consistent")
}

fn hull_bare(points: &[[f64; 2]]) -> Hull2 {
    let points = Points::new(points).expect("the generator makes finite points");
    gs_bare(points, Boundary::Extreme, &Exact, &mut Silent).expect("the exact kernel is consistent")
}

fn sorted(mut numbers: Vec<f64>) -> Vec<f64> {
    numbers.sort_unstable_by(f64::total_cmp);
    numbers
}

/// Prints the median over rounds of the ratio of two times, its 95 % confidence interval, and the least and the
/// greatest ratio. The two are timed in turn, and each goes first in every other round.
fn print_ratio(
    name: &str,
    rounds: usize,
    first: impl Fn() -> Duration,
    second: impl Fn() -> Duration,
) {
    let mut samples: Vec<[f64; 3]> = (0..rounds)
        .map(|round| {
            let (first, second) = if round % 2 == 0 {
                let time = first();
                (time, second())
            } else {
                let time = second();
                (first(), time)
            };
            let [first, second] = [first, second].map(|time| time.as_secs_f64());
            [first / second, first, second]
        })
        .collect();
    let [first, second] = [1, 2].map(|column| {
        samples.sort_by(|a, b| a[column].total_cmp(&b[column]));
        1e3 * samples[rounds / 2][column]
    });
    samples.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let ratio = |rank: usize| samples[rank.min(rounds - 1)][0];
    // Order statistics around the median of a binomial: half the rounds, plus and minus 1.96 standard deviations.
    let margin = (0.98 * (rounds as f64).sqrt()).ceil() as usize;
    println!(
        "{name}: {first:.1} ms / {second:.1} ms, ratio {:.3} (95 % {:.3} to {:.3}, all {:.3} to {:.3}, {rounds} rounds)",
        ratio(rounds / 2),
        ratio((rounds / 2).saturating_sub(margin)),
        ratio(rounds / 2 + margin),
        ratio(0),
        ratio(rounds - 1),
    );
}

fn elapsed<T>(work: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    start.elapsed()
}
