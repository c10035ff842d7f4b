//! The points of a stop: one set, or a batch of sets where n is small.

use super::plan::Stop;
use crate::counting::PointSet;
use anyhow::Result;
use point_sets::fingerprint;

/// The sets that an engine is run on in turn.
#[derive(Clone, Debug)]
pub(crate) struct Realisation {
    pub(crate) sets: Vec<PointSet>,
    /// That of all points, in order.
    pub(crate) fingerprint: String,
}

impl Realisation {
    /// Generates the points of `stop`.
    pub(crate) fn generate(stop: &Stop<'_>) -> Result<Self> {
        let seed = stop.seed();
        // The first set is that of the realisation's own seed, so that anyone can make it from the record.
        let seeds = (0..stop.block.batch(stop.n)).map(|number| match number {
            0 => seed,
            _ => point_sets::cell_seed(seed, stop.spec, stop.n, number),
        });
        let (spec, n) = (stop.spec, stop.n);
        match stop.definition.problem.dimension() {
            2 => {
                let sets: Result<Vec<_>, _> = seeds.map(|seed| spec.generate(n, seed)).collect();
                let sets = sets?;
                let fingerprint = fingerprint(&sets.concat()).to_string();
                let sets = sets.into_iter().map(PointSet::Plane).collect();
                Ok(Self { sets, fingerprint })
            }
            _ => {
                let sets: Result<Vec<_>, _> = seeds.map(|seed| spec.generate3(n, seed)).collect();
                let sets = sets?;
                let fingerprint = fingerprint(&sets.concat()).to_string();
                let sets = sets.into_iter().map(PointSet::Space).collect();
                Ok(Self { sets, fingerprint })
            }
        }
    }
}
