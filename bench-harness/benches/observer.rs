//! Does an observer that is off cost anything?
//!
//! Method GS runs with each observer. The runs are interleaved, in an order drawn anew each round, and a round
//! gives one ratio to [`Silent`], so that a machine that slows down slows both sides of a ratio. `Silent`
//! against itself, the same function called twice a round, shows what this machine makes of no difference at
//! all: an observer whose interval overlaps that band costs nothing that can be seen here.
//!
//! `&mut Silent` is another instance of the same source, also without hooks: a difference to `Silent` comes from
//! where its code lies in memory, and tells how small a difference between two instances can mean anything.
//! `Tally` and `Recorder` do work, and show what an observer that is on costs: that of `Silent`, whose hooks are
//! gone, cannot be more.
//!
//! After the ratios, Criterion measures each observer by itself, for comparisons with earlier runs.
//! `cargo bench -p bench-harness --bench observer`

use criterion::{BenchmarkId, Criterion};
use geometry_core::{Boundary, Exact, Hull2, Observer, Points, Recorder, Silent, Tally};
use planar_peeling::gs::gs;
use point_sets::Spec;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use std::hint::black_box;
use std::io::{self, Write};
use std::time::{Duration, Instant};

const SEED: u64 = 1979;
const ROUNDS: usize = 201;
/// One sample runs at least this long, so that the clock's grain does not show.
const SAMPLE: Duration = Duration::from_millis(1);

/// Method GS with one observer.
struct Arm {
    name: &'static str,
    run: fn(Points<'_, 2>) -> Hull2,
}

/// The first is what the others are compared with; the second is the first again.
const ARMS: [Arm; 5] = [
    Arm {
        name: "Silent",
        run: silent,
    },
    Arm {
        name: "Silent again",
        run: silent,
    },
    Arm {
        name: "&mut Silent",
        run: |points| hull(points, &mut &mut Silent),
    },
    Arm {
        name: "Tally",
        run: |points| hull(points, black_box(&mut Tally::default())),
    },
    Arm {
        name: "Recorder",
        run: |points| hull(points, black_box(&mut Recorder::default())),
    },
];

fn silent(points: Points<'_, 2>) -> Hull2 {
    hull(points, &mut Silent)
}

fn hull<O: Observer>(points: Points<'_, 2>, observer: &mut O) -> Hull2 {
    gs(points, Boundary::Extreme, &Exact, observer)
        .expect("the exact kernel does not contradict itself")
}

fn main() -> io::Result<()> {
    let measuring = std::env::args().any(|argument| argument == "--bench");
    let mut criterion = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .configure_from_args();
    for n in [1_000, 100_000] {
        let disc: Spec = "disc".parse().expect("a set of the catalogue");
        let slice = disc.generate(n, SEED).expect("a size the disc has");
        let points = Points::new(&slice).expect("finite points");
        certify(points);
        if measuring {
            print_ratios(points)?;
        }
        one_by_one(&mut criterion, points);
    }
    criterion.final_summary();
    Ok(())
}

/// What is timed below is right.
fn certify(points: Points<'_, 2>) {
    for arm in ARMS {
        hull_verify::check::hull2(points.as_slice(), Boundary::Extreme, &(arm.run)(points))
            .unwrap_or_else(|findings| panic!("{}: {}", arm.name, findings[0]));
    }
}

fn print_ratios(points: Points<'_, 2>) -> io::Result<()> {
    let samples = interleaved(points);
    let mut out = io::stdout().lock();
    writeln!(
        out,
        "\ngs, disc, n = {}, seed {SEED}: {ROUNDS} rounds",
        points.len()
    )?;
    writeln!(
        out,
        "observer      time / Silent   95 % interval of the median"
    )?;
    for (arm, times) in ARMS.iter().zip(&samples).skip(1) {
        let ratios = std::iter::zip(times, &samples[0]).map(|(time, silent)| time / silent);
        let [low, median, high] = median_interval(ratios.collect());
        let band = if arm.name == "Silent again" {
            "   the band of no difference"
        } else {
            ""
        };
        writeln!(
            out,
            "{:<13} {median:>13.4}   {low:.4} .. {high:.4}{band}",
            arm.name
        )?;
    }
    Ok(())
}

/// Seconds of one sample, for each arm and round.
fn interleaved(points: Points<'_, 2>) -> [Vec<f64>; ARMS.len()] {
    let calls = calls_a_sample(points);
    let mut rng = ChaCha8Rng::seed_from_u64(SEED);
    let mut order: Vec<usize> = (0..ARMS.len()).collect();
    let mut samples = [const { Vec::new() }; ARMS.len()];
    for _ in 0..ROUNDS {
        order.shuffle(&mut rng);
        for &arm in &order {
            samples[arm].push(sample(&ARMS[arm], points, calls).as_secs_f64());
        }
    }
    samples
}

fn sample(arm: &Arm, points: Points<'_, 2>, calls: u32) -> Duration {
    let start = Instant::now();
    for _ in 0..calls {
        black_box((arm.run)(black_box(points)));
    }
    start.elapsed()
}

/// How many calls make a sample long enough, found on a warm cache.
fn calls_a_sample(points: Points<'_, 2>) -> u32 {
    let mut calls = 1;
    while sample(&ARMS[0], points, calls) < SAMPLE {
        calls *= 2;
    }
    calls
}

/// The median with the two order statistics that enclose the true one in 95 of 100 cases, whatever the
/// distribution: the number of values below the true median is binomial.
fn median_interval(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    let middle = (values.len() - 1) as f64 / 2.0;
    let reach = 1.96 * (values.len() as f64).sqrt() / 2.0;
    [middle - reach, middle, middle + reach].map(|place| values[place.round() as usize])
}

fn one_by_one(criterion: &mut Criterion, points: Points<'_, 2>) {
    let mut group = criterion.benchmark_group("observer");
    for arm in ARMS.iter().filter(|arm| arm.name != "Silent again") {
        group.bench_function(BenchmarkId::new(arm.name, points.len()), |bencher| {
            bencher.iter(|| (arm.run)(black_box(points)));
        });
    }
    group.finish();
}
