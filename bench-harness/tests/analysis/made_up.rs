//! Run folders made up from a seed: what a machine might have recorded.
//!
//! A time is a law in n, times what the realisation makes of it, times what engine and realisation have of their own,
//! all of them the same in every run; times where the program happens to lie in memory in this run, times what else the
//! machine did in this round, times noise that only ever adds.

use bench_harness::records::manifest::{Cache, EngineStamp};
use bench_harness::records::{Case, Cell, Count, Manifest, Outcome, Run, Sample, Subject, write};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::num::NonZeroU64;
use std::path::Path;

/// What to make up.
#[derive(Clone, Debug)]
pub(crate) struct MadeUp {
    pub(crate) sets: Vec<&'static str>,
    pub(crate) sizes: Vec<usize>,
    pub(crate) seeds: u64,
    pub(crate) rounds: u32,
    /// Each engine, and how slow it is.
    pub(crate) engines: Vec<(&'static str, f64)>,
    /// Those with a twin.
    pub(crate) twins: Vec<&'static str>,
    /// Scatter of a sample.
    pub(crate) noise: f64,
    /// Scatter by place in memory, from run to run.
    pub(crate) placement: f64,
    /// Scatter of what engine and realisation have of their own.
    pub(crate) own: f64,
    /// What the realisations are; the same in runs to be compared.
    pub(crate) world: u64,
    /// The cost of a point set, as a function of n.
    pub(crate) law: fn(f64) -> f64,
    /// What differs from run to run.
    pub(crate) seed: u64,
}

/// The rows so far.
#[derive(Default)]
struct Rows {
    cells: Vec<Cell>,
    samples: Vec<Sample>,
    counts: Vec<Count>,
}

impl MadeUp {
    /// Four engines on two sets of three sizes.
    pub(crate) fn new(seed: u64) -> Self {
        Self {
            sets: vec!["disc", "oblique:cols=10,rows=10"],
            sizes: vec![100, 1_000, 10_000],
            seeds: 4,
            rounds: 8,
            engines: vec![("gs", 1.0), ("eddy", 1.4), ("graham", 2.0), ("qhull", 3.1)],
            twins: vec!["gs", "qhull"],
            noise: 0.02,
            placement: 0.004,
            own: 0.05,
            world: 0,
            law: |n| 8.0 * n * n.ln(),
            seed,
        }
    }

    /// The run.
    pub(crate) fn run(&self) -> Run {
        let mut rows = Rows::default();
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        for set in &self.sets {
            for &n in &self.sizes {
                let case = Case {
                    definition: "made-up".into(),
                    set: (*set).into(),
                    n,
                };
                self.add_case(&case, &mut random, &mut rows);
            }
        }
        let Rows {
            cells,
            samples,
            counts,
        } = rows;
        Run::from_rows(manifest(), cells, (samples, counts, Vec::new()))
    }

    /// Writes the run into `folder`.
    pub(crate) fn write(&self, folder: &Path) {
        let run = self.run();
        run.manifest.write(folder).expect("manifest");
        write::rows(folder, &run.cells).expect("cells");
        write::rows(folder, &run.samples).expect("samples");
        write::rows(folder, &run.counts).expect("counts");
        write::rows(folder, &run.warnings).expect("warnings");
    }

    fn add_case(&self, case: &Case, random: &mut ChaCha8Rng, rows: &mut Rows) {
        let contestants = self.contestants();
        let places: Vec<f64> = contestants
            .iter()
            .map(|_| (self.placement * normal(random)).exp())
            .collect();
        for seed in 0..self.seeds {
            let mut own =
                ChaCha8Rng::seed_from_u64(seed ^ (case.n as u64) << 20 ^ self.world << 50);
            let realisation = (0.1 * normal(&mut own)).exp();
            let h = (3.0 * (case.n as f64).cbrt() * (0.05 * normal(&mut own)).exp()).round();
            let cost = (self.law)(case.n as f64) * realisation;
            let subject = |engine: &str| Subject {
                case: case.clone(),
                seed,
                engine: engine.to_owned(),
            };
            let mut own_factors = Vec::new();
            for (engine, factor) in &self.engines {
                own_factors.push(factor * (self.own * normal(&mut own)).exp());
                rows.cells.push(Cell {
                    subject: subject(engine),
                    fingerprint: format!("{}-{seed}", case.n),
                    outcome: Outcome::Certified,
                    h: Some(h as u64),
                    facets: None,
                    finding: String::new(),
                });
                rows.counts.push(Count {
                    subject: subject(engine),
                    counter: "orient".into(),
                    value: (cost * factor).round() as u64,
                });
            }
            for round in 0..self.rounds {
                let burst = if random.random::<f64>() < 0.1 {
                    1.5
                } else {
                    1.0
                };
                for ((name, engine), place) in contestants.iter().zip(&places) {
                    let noise = (self.noise * normal(random).abs()).exp();
                    let time = cost * own_factors[*engine] * place * burst * noise;
                    rows.samples.push(Sample {
                        subject: subject(name),
                        round,
                        inner: NonZeroU64::new(4).expect("four"),
                        nanoseconds: (4.0 * time).round() as u64,
                    });
                }
            }
        }
    }

    /// Every name that is sampled, with the number of its engine.
    fn contestants(&self) -> Vec<(String, usize)> {
        let names = self.engines.iter().zip(0..);
        let with_twin = |((name, _), place): (&(&str, f64), usize)| {
            let twin = self.twins.contains(name);
            let names = [
                Some((*name).to_owned()),
                twin.then(|| format!("{name}@twin")),
            ];
            names.into_iter().flatten().map(move |name| (name, place))
        };
        names.flat_map(with_twin).collect()
    }
}

/// The sum of twelve uniform draws, less its mean: variance 1.
fn normal(random: &mut ChaCha8Rng) -> f64 {
    (0..12).map(|_| random.random::<f64>() - 0.5).sum()
}

fn manifest() -> Manifest {
    Manifest {
        commit: "0123abc".into(),
        processor: "made up".into(),
        caches: [(1, 1 << 15), (2, 1 << 20)]
            .map(|(level, bytes)| Cache { level, bytes })
            .to_vec(),
        engines: vec![EngineStamp {
            name: "qhull".into(),
            version: "2020.2".into(),
            clock_ns: 20,
        }],
        ..Manifest::default()
    }
}
