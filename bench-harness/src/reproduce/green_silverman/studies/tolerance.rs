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
use crate::reproduce::green_silverman::definition::Studies;
use crate::reproduce::green_silverman::records::{Records, ToleranceRow};
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::FailureRow;
use crate::reproduce::sets::PointSet2;
use anyhow::{Result, bail};
use geometry_core::tolerance::formats::{Cdc7600, Double, Extended, IbmShort, Single};
use geometry_core::{Boundary, Kernel2, Layers, Points, Tally, Tolerance};

/// A lattice as it is presented to the methods. The paper prints no coordinates.
#[derive(Clone, Copy)]
struct Presentation {
    /// The name in the records.
    data: &'static str,
    fitted: bool,
    /// Decimals kept; `None` for all that a double holds.
    decimals: Option<u32>,
}

/// Runs the sweep of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let mut decimals = vec![None];
    decimals.extend(studies.tolerance.lattice.decimals.iter().copied().map(Some));
    let placed = |data, fitted| {
        decimals.iter().map(move |&decimals| Presentation {
            data,
            fitted,
            decimals,
        })
    };
    let presentations: Vec<Presentation> = placed("lattice", false)
        .chain(placed("lattice-fitted", true))
        .collect();
    let progress = Progress::start("tolerance", 1 + presentations.len());
    let numbers: Vec<u64> = (0..studies.tolerance.sets).collect();
    let rows = parallel::map(&numbers, |&replicate| random(studies, replicate))?;
    records.own.tolerance.extend(rows.into_iter().flatten());
    progress.finished("random");
    for presentation in presentations {
        let rows = parallel::map(&numbers, |&replicate| {
            lattice(studies, presentation, replicate)
        })?;
        for (rows, failure) in rows {
            records.own.tolerance.extend(rows);
            records.failures.extend(failure);
        }
        progress.finished(&match presentation.decimals {
            None => presentation.data.to_owned(),
            Some(decimals) => format!("{} to {decimals} decimals", presentation.data),
        });
    }
    Ok(())
}

/// The sweep over one random set.
fn random(studies: &Studies, replicate: u64) -> Result<Vec<ToleranceRow>> {
    let data = &studies.tolerance.random;
    let set = PointSet2::generate(studies.seed, &data.distribution, data.n, replicate)?;
    let points = Points::new(&set.points)?;
    let right = Answer::of(&(layers_method("gs-peel")?.exact)(points, Boundary::All)?);
    let sweep = Sweep {
        studies,
        set: &set,
        data: "random",
        decimals: None,
    };
    sweep.rows(|kernel| peels_to(points, kernel, &right))
}

/// The sweep over one turned lattice, and the control: exact answers are certified for the points as given.
fn lattice(
    studies: &Studies,
    presentation: Presentation,
    replicate: u64,
) -> Result<(Vec<ToleranceRow>, Option<FailureRow>)> {
    let data = &studies.tolerance.lattice;
    let gs_peel = layers_method("gs-peel")?;
    let plain = PointSet2::generate(studies.seed, &data.plain, data.n, 0)?;
    let intended = Answer::of(&(gs_peel.exact)(
        Points::new(&plain.points)?,
        Boundary::All,
    )?);
    let mut set = PointSet2::generate(studies.seed, &data.distribution, data.n, replicate)?;
    if presentation.fitted {
        fit_into_unit_square(&mut set.points);
    }
    if let Some(decimals) = presentation.decimals {
        round_to(&mut set.points, decimals);
    }
    let points = Points::new(&set.points)?;
    let sweep = Sweep {
        studies,
        set: &set,
        data: presentation.data,
        decimals: presentation.decimals,
    };
    let mut rows = sweep.rows(|kernel| peels_to(points, kernel, &intended))?;
    if !presentation.fitted && presentation.decimals.is_none() {
        rows.extend(eddy(
            Sweep {
                data: "lattice-eddy",
                ..sweep
            },
            points,
            &intended,
        )?);
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

/// The first hull by Eddy's method, against the first intended ring.
fn eddy(sweep: Sweep<'_>, points: Points<'_, 2>, intended: &Answer) -> Result<Vec<ToleranceRow>> {
    let method = hull_method("eddy")?;
    sweep.rows(|kernel| {
        match (method.tallied)(points, Boundary::All, kernel, &mut Tally::default()) {
            Ok(hull) if Some(&cycle(hull.vertices())) == intended.rings.first() => 'r',
            Ok(_) => 'w',
            Err(_) => 'c',
        }
    })
}

/// Moves and scales the points, both axes alike, so that their bounding box just fits into the unit square.
fn fit_into_unit_square(points: &mut [[f64; 2]]) {
    let least = |axis: usize| {
        points
            .iter()
            .map(|point| point[axis])
            .fold(f64::INFINITY, f64::min)
    };
    let most = |axis: usize| {
        points
            .iter()
            .map(|point| point[axis])
            .fold(f64::NEG_INFINITY, f64::max)
    };
    let from = [least(0), least(1)];
    let side = (most(0) - from[0]).max(most(1) - from[1]);
    for point in points {
        *point = [0, 1].map(|axis| (point[axis] - from[axis]) / side);
    }
}

/// Rounds the coordinates as printing and reading them again would.
fn round_to(points: &mut [[f64; 2]], decimals: u32) {
    for coordinate in points.as_flattened_mut() {
        let printed = format!("{coordinate:.*}", decimals as usize);
        *coordinate = printed.parse().expect("a printed number can be read");
    }
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
    studies: &'a Studies,
    set: &'a PointSet2,
    data: &'static str,
    decimals: Option<u32>,
}

impl Sweep<'_> {
    fn rows(&self, outcome: impl Fn(&dyn Kernel2) -> char) -> Result<Vec<ToleranceRow>> {
        let tolerance = &self.studies.tolerance;
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
