//! The point sets of studies, each determined by (seed, distribution, n, replicate).

use anyhow::{Context, Result};
use point_sets::{Spec, SpecError};
use sha2::{Digest, Sha256};
use std::str::FromStr;

/// A generated set and what it was generated from.
#[derive(Clone, Debug)]
pub(crate) struct PointSet<const D: usize> {
    /// The name of the distribution, as in the study.
    pub(crate) distribution: String,
    /// Points asked for.
    pub(crate) n: usize,
    /// Number of the replicate, from 0.
    pub(crate) replicate: u64,
    /// The seed of this set alone.
    pub(crate) seed: u64,
    /// The points.
    pub(crate) points: Vec<[f64; D]>,
}

/// Points of the plane.
pub(crate) type PointSet2 = PointSet<2>;

/// Points of space.
pub(crate) type PointSet3 = PointSet<3>;

type Generate<const D: usize> = fn(&Spec, usize, u64) -> Result<Vec<[f64; D]>, SpecError>;

impl PointSet2 {
    /// Generates replicate `replicate` of the cell (`distribution`, `n`).
    pub(crate) fn generate(
        seed: u64,
        distribution: &str,
        n: usize,
        replicate: u64,
    ) -> Result<Self> {
        Self::by(Spec::generate, seed, distribution, n, replicate)
    }
}

impl PointSet3 {
    /// Generates replicate `replicate` of the cell (`distribution`, `n`).
    pub(crate) fn generate(
        seed: u64,
        distribution: &str,
        n: usize,
        replicate: u64,
    ) -> Result<Self> {
        Self::by(Spec::generate3, seed, distribution, n, replicate)
    }
}

impl<const D: usize> PointSet<D> {
    fn by(
        generate: Generate<D>,
        seed: u64,
        distribution: &str,
        n: usize,
        replicate: u64,
    ) -> Result<Self> {
        let spec = Spec::from_str(distribution)
            .with_context(|| format!("the distribution {distribution:?}"))?;
        let seed = point_sets::cell_seed(seed, &spec, n, replicate);
        let points = generate(&spec, n, seed)
            .with_context(|| format!("generating {n} points of {distribution:?}"))?;
        Ok(Self {
            distribution: distribution.to_owned(),
            n,
            replicate,
            seed,
            points,
        })
    }

    /// The same set with its points changed, under another name.
    pub(crate) fn changed(self, name: &str, change: impl FnOnce(&mut Vec<[f64; D]>)) -> Self {
        let mut set = Self {
            distribution: name.to_owned(),
            ..self
        };
        change(&mut set.points);
        set
    }

    /// The fingerprint of the coordinates.
    pub(crate) fn fingerprint(&self) -> String {
        point_sets::fingerprint(&self.points).to_string()
    }
}

/// SHA-256, shortened, over fingerprints in order: one name for all the sets of a cell.
pub(crate) fn digest<S: AsRef<str>>(fingerprints: impl IntoIterator<Item = S>) -> String {
    let mut digest = Sha256::new();
    for fingerprint in fingerprints {
        digest.update(fingerprint.as_ref());
    }
    let bytes = digest.finalize();
    bytes
        .iter()
        .take(8)
        .map(|byte| format!("{byte:02x}"))
        .collect()
}
