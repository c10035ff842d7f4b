//! The times of a run in formats that other tools read.
//!
//! A benchmark is an engine on a case, `definition/set/n/engine`; its value the typical time of a call in nanoseconds,
//! its range the 95 % interval of that time over realisations and rounds.
//!
//! - github-action-benchmark, `customSmallerIsBetter`: an array of name, unit, value, range, extra.
//! - Bencher Metric Format: an object of benchmarks, each an object of measures, each with value and bounds. Counts are
//!   measures too.
//! - critcmp: a baseline as `critcmp --export` writes it, so that `critcmp old.json new.json` compares two runs by the
//!   estimates that Criterion makes. It speaks of means; so does this file.

use super::{h_text, seed_of};
use crate::records::{Case, Run};
use crate::stats::bootstrap::{Bootstrapped, clustered_median};
use crate::stats::summary::{deviation, mean, median};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// A format that another tool reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Tool {
    /// github-action-benchmark, customSmallerIsBetter
    GithubActionBenchmark,
    /// Bencher Metric Format
    Bencher,
    /// A baseline of Criterion estimates, as critcmp reads it
    Criterion,
}

/// The times of `run` in the format of `tool`.
pub fn export(run: &Run, tool: Tool) -> Value {
    match tool {
        Tool::GithubActionBenchmark => github_action_benchmark(run),
        Tool::Bencher => bencher(run),
        Tool::Criterion => criterion(run),
    }
}

/// One engine on one case.
struct Benchmark<'a> {
    case: &'a Case,
    engine: &'a str,
    /// Nanoseconds of a call, every sample.
    samples: Vec<f64>,
    middle: Bootstrapped,
}

impl Benchmark<'_> {
    fn name(&self) -> String {
        let Case { definition, set, n } = self.case;
        format!("{definition}/{set}/{n}/{}", self.engine)
    }
}

fn benchmarks(run: &Run) -> Vec<Benchmark<'_>> {
    let mut found = Vec::new();
    for case in run.cases() {
        for engine in run.timed(case) {
            let clusters: Vec<Vec<f64>> = run
                .times(case, engine)
                .iter()
                .map(crate::records::Realisation::times)
                .collect();
            let seed = seed_of(&[&case.to_string(), engine]);
            if let Some(middle) = clustered_median(&clusters, seed) {
                found.push(Benchmark {
                    case,
                    engine,
                    samples: clusters.concat(),
                    middle,
                });
            }
        }
    }
    found
}

fn github_action_benchmark(run: &Run) -> Value {
    let entry = |benchmark: &Benchmark<'_>| {
        let (low, high) = benchmark.middle.interval(0.95);
        json!({
            "name": benchmark.name(),
            "unit": "ns",
            "value": benchmark.middle.median,
            "range": format!("± {:.0}", (high - low) / 2.0),
            "extra": format!("h = {}, commit {}", h_text(run.h(benchmark.case)), run.manifest.commit),
        })
    };
    Value::Array(benchmarks(run).iter().map(entry).collect())
}

fn bencher(run: &Run) -> Value {
    let mut all: BTreeMap<String, Map<String, Value>> = BTreeMap::new();
    for benchmark in benchmarks(run) {
        let (low, high) = benchmark.middle.interval(0.95);
        let latency = json!({
            "value": benchmark.middle.median,
            "lower_value": low,
            "upper_value": high,
        });
        let measures = all.entry(benchmark.name()).or_default();
        measures.insert("latency".into(), latency);
    }
    let mut counts: BTreeMap<(&Case, &str, &str), Vec<f64>> = BTreeMap::new();
    for count in &run.counts {
        let subject = &count.subject;
        let key = (
            &subject.case,
            subject.engine.as_str(),
            count.counter.as_str(),
        );
        counts.entry(key).or_default().push(count.value as f64);
    }
    for ((Case { definition, set, n }, engine, counter), values) in counts {
        let name = format!("{definition}/{set}/{n}/{engine}");
        let slug = counter.replace('_', "-");
        let measures = all.entry(name).or_default();
        measures.insert(slug, json!({"value": mean(&values)}));
    }
    json!(all)
}

fn criterion(run: &Run) -> Value {
    let baseline = run
        .folder
        .file_name()
        .map_or_else(|| "run".into(), |name| name.to_string_lossy().into_owned());
    let benchmarks: Map<String, Value> = benchmarks(run)
        .iter()
        .map(|benchmark| {
            let name = benchmark.name();
            let Case { definition, set, n } = benchmark.case;
            let entry = json!({
                "baseline": baseline,
                "fullname": format!("{baseline}/{name}"),
                "criterion_benchmark_v1": {
                    "group_id": format!("{definition}/{set}/{n}"),
                    "function_id": benchmark.engine,
                    "value_str": null,
                    "throughput": {"Elements": n},
                    "full_id": name,
                    "directory_name": name,
                },
                "criterion_estimates_v1": estimates(benchmark),
            });
            (name, entry)
        })
        .collect();
    json!({"name": baseline, "benchmarks": benchmarks})
}

/// Mean, median and spread as Criterion lays them out. The mean has the normal interval of its standard error.
fn estimates(benchmark: &Benchmark<'_>) -> Value {
    let samples = &benchmark.samples;
    let spread = match deviation(samples) {
        spread if spread.is_finite() => spread,
        _ => 0.0,
    };
    let estimate = |value: f64, error: f64, (low, high): (f64, f64)| {
        json!({
            "point_estimate": value,
            "standard_error": error,
            "confidence_interval": {"confidence_level": 0.95, "lower_bound": low, "upper_bound": high},
        })
    };
    let normal = |value: f64, error: f64| {
        estimate(value, error, (value - 1.96 * error, value + 1.96 * error))
    };
    let root = (samples.len() as f64).sqrt();
    let middle = benchmark.middle.median;
    let distances: Vec<f64> = samples.iter().map(|time| (time - middle).abs()).collect();
    json!({
        "mean": normal(mean(samples), spread / root),
        "median": estimate(
            middle,
            benchmark.middle.standard_error(),
            benchmark.middle.interval(0.95),
        ),
        // 1.4826 makes it the standard deviation of normal values, as Criterion has it.
        "median_abs_dev": normal(1.4826 * median(&distances), 0.0),
        "slope": null,
        "std_dev": normal(spread, spread / (2.0_f64.sqrt() * root)),
    })
}
