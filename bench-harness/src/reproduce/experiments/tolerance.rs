//! The sweep of the tolerance (Table 1, GS-5).
//!
//! A data set is peeled completely with areas below ε counted as zero, for every power of ten, in every
//! number format, and the result is right or wrong as a whole:
//!
//! - **random data**: right is what the exact kernel gives;
//! - **lattice data**: right is what the lattice gives before it is turned and its coordinates are rounded.
//!   For the points as given, rounded as they are, that is not the exact answer: it is the intended one,
//!   which a tolerance is there to recover;
//! - **Eddy's method** on the lattice: its first hull against the first intended ring.

use super::{hull_method, layers_method};
use crate::reproduce::definition::Definition;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::records::{FailureRow, Records, ToleranceRow};
use crate::reproduce::sets::PointSet;
use anyhow::{Context, Result, bail};
use geometry_core::tolerance::formats::{Cdc7600, Double, Extended, IbmShort, Single};
use geometry_core::{Boundary, Kernel2, Layers, Points, Tally, Tolerance};

/// Runs the sweep of the definition.
pub(crate) fn run(definition: &Definition, records: &mut Records) -> Result<()> {
    let decimals = definition
        .tolerance
        .lattice
        .decimals
        .iter()
        .map(|&decimals| Some(decimals));
    let lattices: Vec<Option<u32>> = std::iter::once(None).chain(decimals).collect();
    let progress = Progress::start("tolerance", 1 + lattices.len());
    let numbers: Vec<u64> = (0..definition.tolerance.sets).collect();
    let rows = parallel::map(&numbers, |&replicate| random(definition, replicate))?;
    records.tolerance.extend(rows.into_iter().flatten());
    progress.finished("random");
    for decimals in lattices {
        let rows = parallel::map(&numbers, |&replicate| {
            lattice(definition, decimals, replicate)
        })?;
        for (rows, failure) in rows {
            records.tolerance.extend(rows);
            records.failures.extend(failure);
        }
        progress.finished(&decimals.map_or_else(
            || "lattice".to_owned(),
            |decimals| format!("lattice to {decimals} decimals"),
        ));
    }
    Ok(())
}

/// The sweep over one random set.
fn random(definition: &Definition, replicate: u64) -> Result<Vec<ToleranceRow>> {
    let data = &definition.tolerance.random;
    let set = PointSet::generate(definition.seed, &data.distribution, data.n, replicate)?;
    let points = Points::new(&set.points)?;
    let right = Answer::of(&(layers_method("gs-peel")?.exact)(points, Boundary::All)?);
    let sweep = Sweep {
        definition,
        set: &set,
        data: "random",
        decimals: None,
    };
    sweep.rows(|kernel| peels_to(points, kernel, &right))
}

/// The sweep over one turned lattice, and the control: exact answers are certified for the points as given.
fn lattice(
    definition: &Definition,
    decimals: Option<u32>,
    replicate: u64,
) -> Result<(Vec<ToleranceRow>, Option<FailureRow>)> {
    let data = &definition.tolerance.lattice;
    let plain = PointSet::generate(definition.seed, &data.plain, data.n, 0)?;
    let gs_peel = layers_method("gs-peel")?;
    let intended = Answer::of(&(gs_peel.exact)(
        Points::new(&plain.points)?,
        Boundary::All,
    )?);
    let mut set = PointSet::generate(definition.seed, &data.distribution, data.n, replicate)?;
    if let Some(decimals) = decimals {
        // The same angle, so that the lattices differ by the rounding only.
        let spec: point_sets::Spec = format!("{}:decimals={decimals}", data.distribution)
            .parse()
            .context("the rounded lattice")?;
        set.points = spec.generate(data.n, set.seed)?;
    }
    let points = Points::new(&set.points)?;
    let sweep = Sweep {
        definition,
        set: &set,
        data: "lattice",
        decimals,
    };
    let mut rows = sweep.rows(|kernel| peels_to(points, kernel, &intended))?;
    if decimals.is_none() {
        let eddy = hull_method("eddy")?;
        let sweep = Sweep {
            data: "lattice-eddy",
            ..sweep
        };
        rows.extend(sweep.rows(|kernel| {
            match (eddy.tallied)(points, Boundary::All, kernel, &mut Tally::default()) {
                Ok(hull) if Some(&cycle(hull.vertices())) == intended.rings.first() => 'r',
                Ok(_) => 'w',
                Err(_) => 'c',
            }
        })?);
    }
    let exact = (gs_peel.exact)(points, Boundary::All)?;
    let failure = hull_verify::check::layers(&set.points, Boundary::All, &exact).err();
    let failure = failure.map(|findings| FailureRow {
        stage: "tolerance".to_owned(),
        distribution: data.distribution.clone(),
        n: data.n,
        replicate,
        method: "gs-peel".to_owned(),
        what: findings
            .first()
            .map(ToString::to_string)
            .unwrap_or_default(),
    });
    Ok((rows, failure))
}

/// The rings of a peeling and the ring of every point.
struct Answer {
    rings: Vec<Vec<u32>>,
    stages: Vec<u32>,
}

impl Answer {
    fn of(layers: &Layers) -> Self {
        let rings = layers
            .rings()
            .iter()
            .map(|ring| cycle(ring.vertices()))
            .collect();
        Self {
            rings,
            stages: layers.c_ranks().to_vec(),
        }
    }
}

/// The cycle from its smallest index: where a ring starts depends on how the lattice is turned.
fn cycle(ids: &[u32]) -> Vec<u32> {
    let mut ids = ids.to_vec();
    let smallest = (0..ids.len()).min_by_key(|&i| ids[i]).unwrap_or(0);
    ids.rotate_left(smallest);
    ids
}

/// How the complete peeling with `kernel` compares with the right one.
fn peels_to(points: Points<'_, 2>, kernel: &dyn Kernel2, right: &Answer) -> char {
    let Ok(method) = layers_method("gs-peel") else {
        return 'c';
    };
    match (method.tallied)(points, Boundary::All, kernel, &mut Tally::default()) {
        Err(_) => 'c',
        Ok(layers) => {
            let here = Answer::of(&layers);
            if here.stages == right.stages && here.rings == right.rings {
                'r'
            } else {
                'w'
            }
        }
    }
}

/// One data set on which every format and every ε is tried.
#[derive(Clone, Copy)]
struct Sweep<'a> {
    definition: &'a Definition,
    set: &'a PointSet,
    data: &'static str,
    decimals: Option<u32>,
}

impl Sweep<'_> {
    fn rows(&self, outcome: impl Fn(&dyn Kernel2) -> char) -> Result<Vec<ToleranceRow>> {
        let tolerance = &self.definition.tolerance;
        let mut rows = Vec::new();
        for format in &tolerance.formats {
            let mut outcomes = String::new();
            for exponent in 1..=tolerance.smallest_exponent {
                outcomes.push(outcome(&*kernel(format, power_of_ten(exponent))?));
            }
            rows.push(ToleranceRow {
                data: self.data.to_owned(),
                format: format.clone(),
                decimals: self.decimals,
                replicate: self.set.replicate,
                fingerprint: self.set.fingerprint(),
                outcomes,
            });
        }
        Ok(rows)
    }
}

/// The double nearest to ten to the minus `exponent`.
fn power_of_ten(exponent: u32) -> f64 {
    format!("1e-{exponent}")
        .parse()
        .expect("a number as the reader writes it")
}

/// The kernel with tolerance `epsilon` in the format of that name.
fn kernel(format: &str, epsilon: f64) -> Result<Box<dyn Kernel2>> {
    Ok(match format {
        "f32" => Box::new(Tolerance::<Single>::new(epsilon)),
        "f64" => Box::new(Tolerance::<Double>::new(epsilon)),
        "extended" => Box::new(Tolerance::<Extended>::new(epsilon)),
        "ibm370" => Box::new(Tolerance::<IbmShort>::new(epsilon)),
        "cdc7600" => Box::new(Tolerance::<Cdc7600>::new(epsilon)),
        _ => bail!("no number format is called {format:?}"),
    })
}
