//! The fixed small suite whose counts are expected to stay as they are.

use crate::counting::{self, Counters, PointSet};
use anyhow::{Context, Result};
use hullkit::Method;
use point_sets::Spec;
use std::collections::BTreeMap;
use std::str::FromStr;

/// The seed of every set.
const SEED: u64 = 2026;

/// Random, all extreme, and degenerate; small enough for methods that take n² or more. Seconds in all.
const SETS: &[(&str, usize)] = &[
    ("disc", 200),
    ("disc", 1_000),
    ("cauchy", 1_000),
    ("circle", 200),
    ("lattice:cols=20,rows=20", 400),
    ("duplicated:of=square", 300),
    ("ball", 60),
    ("ball", 300),
    ("normal3", 300),
    ("sphere", 120),
    ("cubic-lattice", 216),
    ("fan", 66),
    ("cube-faces", 200),
];

/// The counters of each method on each set: (method, set with n) to counters.
pub(crate) type Counts = BTreeMap<(String, String), Counters>;

/// A set of the suite, by name and points.
pub(crate) fn sets() -> Result<Vec<(String, PointSet)>> {
    let made = |&(spec, n): &(&str, usize)| {
        let spec = Spec::from_str(spec).with_context(|| format!("the set {spec:?}"))?;
        let points = match spec.dimension() {
            2 => PointSet::Plane(spec.generate(n, SEED)?),
            _ => PointSet::Space(spec.generate3(n, SEED)?),
        };
        Ok((format!("{spec} n={n}"), points))
    };
    SETS.iter().map(made).collect()
}

/// Counts every method on every set of its dimension.
pub(crate) fn counts(methods: impl Iterator<Item = &'static Method>) -> Result<Counts> {
    let sets = sets()?;
    let mut counts = Counts::new();
    for method in methods {
        for (name, points) in &sets {
            let counted = counting::count(method.task, points)
                .with_context(|| format!("{} on {name}", method.slug))?;
            if let Some(counters) = counted {
                counts.insert((method.slug.to_owned(), name.clone()), counters);
            }
        }
    }
    Ok(counts)
}
