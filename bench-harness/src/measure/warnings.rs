//! What a reader of a run should be careful about, each with what to do about it.

use crate::records::{Case, Run, Sample, Subject, Warning};
use crate::stats::spearman;
use crate::stats::summary::median;
use std::collections::BTreeMap;

/// A sample shorter than so many grains of its engine's clock is told with the grain.
const GRAINS: u64 = 1_000;

/// Rounds below which a drift cannot be told from chance.
const ROUNDS: usize = 8;

/// A rank correlation of time with the round beyond this is a drift.
const DRIFT: f64 = 0.8;

/// A program that differs from itself by more is too noisy to compare by less.
const NOISE: f64 = 0.05;

/// Every warning about `run`.
pub(super) fn of(run: &Run) -> Vec<Warning> {
    let mut warnings = short(run);
    for case in run.cases() {
        warnings.extend(drifting(run, case));
        warnings.extend(noisy(run, case));
    }
    warnings.extend(busy(run));
    warnings
}

/// Samples that the clock can hardly resolve.
fn short(run: &Run) -> Vec<Warning> {
    let grains: BTreeMap<&str, u64> = run
        .manifest
        .engines
        .iter()
        .map(|engine| (engine.name.as_str(), engine.clock_ns))
        .collect();
    let mut shortest: BTreeMap<&Subject, &Sample> = BTreeMap::new();
    for sample in &run.samples {
        let least = shortest.entry(&sample.subject).or_insert(sample);
        if sample.nanoseconds < least.nanoseconds {
            *least = sample;
        }
    }
    let told = |(subject, sample): (&Subject, &Sample)| {
        let grain = grains.get(subject.engine.as_str()).copied().unwrap_or(0);
        (sample.nanoseconds < GRAINS * grain).then(|| Warning {
            subject: subject.clone(),
            warning: format!(
                "too short: a sample of {} ns with a clock of {grain} ns",
                sample.nanoseconds
            ),
            remedy: "more calls a sample, or more points a batch".to_owned(),
        })
    };
    shortest.into_iter().filter_map(told).collect()
}

/// Engines that became slower or faster from round to round.
fn drifting(run: &Run, case: &Case) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for engine in run.timed(case) {
        for realisation in run.times(case, engine) {
            let rounds = realisation
                .rounds
                .iter()
                .map(|(round, time)| (f64::from(*round), *time));
            let rounds: Vec<(f64, f64)> = rounds.collect();
            let correlation = spearman::correlation(&rounds).map_or(0.0, |found| found.rho);
            if rounds.len() >= ROUNDS && correlation.abs() > DRIFT {
                warnings.push(Warning {
                    subject: subject(case, realisation.seed, engine),
                    warning: format!(
                        "drifting: rank correlation {correlation:.2} of time with the round"
                    ),
                    remedy: "let the machine warm up or cool down, and measure again".to_owned(),
                });
            }
        }
    }
    warnings
}

/// Programs that differ from themselves.
fn noisy(run: &Run, case: &Case) -> Vec<Warning> {
    let mut warnings = Vec::new();
    for pair in run.twins(case) {
        let both = run
            .times(case, &pair.engine)
            .iter()
            .zip(run.times(case, &pair.twin));
        for (one, other) in both.filter(|(one, other)| one.seed == other.seed) {
            let ratio = median(&other.times()) / median(&one.times());
            if ratio.ln().abs() > NOISE {
                warnings.push(Warning {
                    subject: subject(case, one.seed, &pair.engine),
                    warning: format!("noisy: {ratio:.3} times itself"),
                    remedy: "believe no difference that is smaller; more rounds, a quieter machine"
                        .to_owned(),
                });
            }
        }
    }
    warnings
}

/// A machine that had other things to do, told once.
fn busy(run: &Run) -> Option<Warning> {
    let load = run.manifest.load_before?[0];
    let first = run.samples.first()?;
    (load > 0.5 * run.manifest.cores as f64).then(|| Warning {
        subject: first.subject.clone(),
        warning: format!(
            "busy machine: load {load} on {} cores before the run",
            run.manifest.cores
        ),
        remedy: "end what else is running; trust ratios, not times".to_owned(),
    })
}

fn subject(case: &Case, seed: u64, engine: &str) -> Subject {
    Subject {
        case: case.clone(),
        seed,
        engine: engine.to_owned(),
    }
}
