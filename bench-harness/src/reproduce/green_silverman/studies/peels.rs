//! Complete peelings with exact answers (GS-7, GS-8, GS-9).

use super::layers_method;
use crate::reproduce::data::product;
use crate::reproduce::green_silverman::definition::Studies;
use crate::reproduce::green_silverman::records::{PeelRow, Records, RingRow};
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::{FailureRow, SetRow};
use crate::reproduce::sets::PointSet2;
use anyhow::Result;
use geometry_core::{Boundary, Counted, Exact, Hull2, Layers, Points, Tally};

/// The method whose peelings are counted: Green and Silverman's.
const METHOD: &str = "gs-peel";

/// Peels every cell of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let blocks = studies.peels.iter();
    let cells: Vec<(String, usize, u64)> = blocks
        .flat_map(|block| {
            let cells = product(&block.distributions, &block.n).into_iter();
            cells.map(|(distribution, n)| (distribution, n, block.replicates))
        })
        .collect();
    let progress = Progress::start("peels", cells.len());
    for (distribution, n, replicates) in cells {
        let numbers: Vec<u64> = (0..replicates).collect();
        let peeled = parallel::map(&numbers, |&replicate| {
            peel(&PointSet2::generate(
                studies.seed,
                &distribution,
                n,
                replicate,
            )?)
        })?;
        for (set, outcome) in peeled {
            records.sets.push(set);
            match outcome {
                Ok(row) => records.own.peels.push(row),
                Err(failure) => records.failures.push(failure),
            }
        }
        progress.finished(&format!("{distribution} {n}"));
    }
    Ok(())
}

/// One counted and certified peeling.
fn peel(set: &PointSet2) -> Result<(SetRow, Result<PeelRow, FailureRow>)> {
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let points = Points::new(&set.points)?;
    let layers = (layers_method(METHOD)?.tallied)(points, Boundary::All, &kernel, &mut tally)?;
    let proof = hull_verify::check::layers(&set.points, Boundary::All, &layers);
    let row = SetRow {
        stage: "peels".to_owned(),
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        seed: set.seed,
        fingerprint: set.fingerprint(),
        vertices: layers.rings().first().map_or(0, Hull2::len),
        facets: None,
        certified: usize::from(proof.is_ok()),
        methods: 1,
    };
    let outcome = match proof {
        Err(findings) => Err(FailureRow {
            stage: "peels".to_owned(),
            distribution: set.distribution.clone(),
            n: set.n,
            replicate: set.replicate,
            method: METHOD.to_owned(),
            what: findings
                .first()
                .map(ToString::to_string)
                .unwrap_or_default(),
        }),
        Ok(_) => Ok(PeelRow {
            distribution: set.distribution.clone(),
            n: set.n,
            replicate: set.replicate,
            layers: layers.len(),
            largest: layers.rings().iter().map(Hull2::len).max().unwrap_or(0),
            remaining: layers.c_ranks().iter().map(|&stage| u64::from(stage)).sum(),
            visits: tally.visits,
            orientations: kernel.counts().orientations.total(),
            questions: kernel.counts().total(),
            storage: tally.storage,
        }),
    };
    Ok((row, outcome))
}

/// Peels the exact lattices under both conventions, by every method that computes layers.
pub(crate) fn lattices(studies: &Studies, records: &mut Records) -> Result<()> {
    let tolerance = &studies.tolerance;
    let lattices = [
        (&tolerance.lattice.plain, tolerance.lattice.n),
        (
            &tolerance.exact_lattice.distribution,
            tolerance.exact_lattice.n,
        ),
    ];
    for (distribution, n) in lattices {
        let set = PointSet2::generate(studies.seed, distribution, n, 0)?;
        for (boundary, name) in [(Boundary::All, "all"), (Boundary::Extreme, "extreme")] {
            for method in ["gs-peel", "chain-peel"] {
                let layers = (layers_method(method)?.exact)(Points::new(&set.points)?, boundary)?;
                records.own.rings.push(RingRow {
                    distribution: distribution.clone(),
                    n,
                    boundary: name.to_owned(),
                    method: method.to_owned(),
                    rings: ring_sizes(&layers),
                    certified: hull_verify::check::layers(&set.points, boundary, &layers).is_ok(),
                });
            }
        }
    }
    Ok(())
}

/// Points on each ring, from the outside in.
fn ring_sizes(layers: &Layers) -> String {
    let sizes: Vec<String> = layers
        .rings()
        .iter()
        .map(|ring| ring.len().to_string())
        .collect();
    sizes.join(" ")
}
