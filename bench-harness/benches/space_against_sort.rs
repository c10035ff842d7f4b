//! Hulls in space beside sorting as many doubles on the same machine: `quickhull-3d` on a million points in a ball and
//! on a sphere, Day's divide and conquer on a hundred thousand on a sphere, there also beside `quickhull-3d`.
//!
//! The sort is a yardstick that moves with the machine. The machine may be shared and noisy, so the figure that
//! counts is the ratio, from rounds in which both run in turn. Aims, on one thread: 12 sorts in a ball, 80 on a
//! sphere; divide and conquer within 10 times quickhull.

#![allow(clippy::print_stdout)] // the ratios are this program's result; Criterion has no place for them

use criterion::{BenchmarkId, Criterion, Throughput};
use hullkit::{Hull3, Points, Task};
use point_sets::Spec;
use std::hint::black_box;
use std::time::{Duration, Instant};

const SEED: u64 = 1996;

/// A method and the set that it is tried on.
struct Row {
    slug: &'static str,
    set: &'static str,
    n: usize,
    rounds: usize,
}

const ROWS: [Row; 4] = [
    Row {
        slug: "quickhull-3d",
        set: "ball",
        n: 1_000_000,
        rounds: 21,
    },
    Row {
        slug: "quickhull-3d",
        set: "sphere",
        n: 1_000_000,
        rounds: 5,
    },
    Row {
        slug: "quickhull-3d",
        set: "sphere",
        n: 100_000,
        rounds: 21,
    },
    Row {
        slug: "preparata-hong-3d",
        set: "sphere",
        n: 100_000,
        rounds: 21,
    },
];

fn main() {
    // `cargo test` runs benchmarks once with `--test`, to see that they work.
    let only_once = std::env::args().any(|argument| argument == "--test");
    for row in &ROWS {
        let points = points(row);
        println!(
            "{}: {} vertices, certified",
            name(row),
            certified(row, &points)
        );
        let rounds = if only_once { 1 } else { row.rounds };
        print_ratio(
            &format!("{} / sort", name(row)),
            rounds,
            || hull(row, &points),
            || sorted(&points),
        );
    }
    let [.., quickhull, divide] = &ROWS;
    let points = points(divide);
    let rounds = if only_once { 1 } else { divide.rounds };
    let name = format!("{} / {}", name(divide), quickhull.slug);
    print_ratio(
        &name,
        rounds,
        || hull(divide, &points),
        || hull(quickhull, &points),
    );
    criterion_alone();
}

/// Each row by itself, for comparisons with earlier runs.
fn criterion_alone() {
    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    let mut group = criterion.benchmark_group("space");
    for row in &ROWS {
        let points = points(row);
        group.throughput(Throughput::Elements(row.n as u64));
        let id = BenchmarkId::new(row.slug, format!("{}-{}", row.set, row.n));
        group.bench_function(id, |bencher| bencher.iter(|| hull(row, &points)));
    }
    group.finish();
    criterion.final_summary();
}

fn name(row: &Row) -> String {
    format!("{} on {} {}", row.slug, row.n, row.set)
}

fn points(row: &Row) -> Vec<[f64; 3]> {
    let spec: Spec = row.set.parse().expect("a set of the catalogue");
    spec.generate3(row.n, SEED).expect("a set of space")
}

/// The number of vertices, once the hull is proved right.
fn certified(row: &Row, points: &[[f64; 3]]) -> usize {
    let hull = hull(row, points);
    hull_verify::check::hull3(points, &hull).expect("nothing is timed that is not proved");
    hull.len()
}

fn hull(row: &Row, points: &[[f64; 3]]) -> Hull3 {
    let method = hullkit::method(row.slug).expect("a registered method");
    let Task::SpatialHull(instances) = method.task else {
        panic!("{} is no method of space", row.slug);
    };
    let points = Points::new(points).expect("the generator makes finite points");
    (instances.exact)(points).expect("the exact kernel is consistent")
}

/// As many doubles as there are points, sorted: the copy is part of the time, as is a hull's own memory of its.
fn sorted(points: &[[f64; 3]]) -> Vec<f64> {
    let mut numbers: Vec<f64> = points.iter().map(|point| point[0]).collect();
    numbers.sort_unstable_by(f64::total_cmp);
    numbers
}

/// Prints the median over rounds of the ratio of one to the other, with the least and the greatest.
fn print_ratio<A, B>(name: &str, rounds: usize, one: impl Fn() -> A, other: impl Fn() -> B) {
    let mut samples: Vec<[f64; 3]> = (0..rounds)
        .map(|_| {
            // The other before and after, as the machine's speed may drift in between.
            let before = elapsed(&other);
            let time = elapsed(&one).as_secs_f64();
            let after = elapsed(&other);
            let yardstick = (before + after).as_secs_f64() / 2.0;
            [time / yardstick, time, yardstick]
        })
        .collect();
    let [times, yardsticks] = [1, 2].map(|column| {
        samples.sort_by(|a, b| a[column].total_cmp(&b[column]));
        1e3 * samples[rounds / 2][column]
    });
    samples.sort_by(|a, b| a[0].total_cmp(&b[0]));
    println!(
        "{name}: {times:.1} ms to {yardsticks:.1} ms, ratio {:.2} (all {:.2}-{:.2}, {rounds} rounds)",
        samples[rounds / 2][0],
        samples[0][0],
        samples[rounds - 1][0],
    );
}

fn elapsed<T>(work: impl Fn() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    start.elapsed()
}
