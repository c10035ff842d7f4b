//! Times of Day's merge in each number format, on the same sets, interleaved (D-2).
//!
//! A set takes part if it ends right in every format.

use super::proved_in;
use crate::reproduce::day::definition::Studies;
use crate::reproduce::day::formats::{self, Machine};
use crate::reproduce::day::records::{Records, SpeedRow};
use crate::reproduce::day::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::timing::{Contestant, interleave};
use anyhow::Result;
use divide_and_conquer::preparata_hong_3d::cotangent::Outcome;
use geometry_core::{Point3, Points};
use std::hint::black_box;

/// The name of this study in the records.
const STAGE: &str = "speed";

/// Times the formats of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let speed = &studies.speed;
    let progress = Progress::start(STAGE, 1);
    let mut machines = Vec::new();
    for format in &studies.precision.formats {
        machines.push((format, formats::find(&format.name)?));
    }
    let numbers: Vec<u64> = (0..speed.sets).collect();
    let usable = parallel::map(&numbers, |&replicate| {
        let set = sets::generate(studies.seed, &speed.distribution, speed.n, replicate)?;
        for (_, machine) in &machines {
            let (rounded, hull) = proved_in(STAGE, set.clone(), machine)?;
            let end = hull.map(|hull| machine.end(&rounded.points, &hull, speed.power));
            if !matches!(end, Ok(Outcome::Right)) {
                return Ok(None);
            }
        }
        Ok(Some(vec![set.points]))
    })?;
    let realisations: Vec<Vec<Vec<Point3>>> = usable.into_iter().flatten().collect();
    let eps2 = 10_f64.powi(speed.power);
    let calls: Vec<_> = machines
        .iter()
        .map(|(_, machine)| call(*machine, eps2))
        .collect();
    let Some(first) = realisations.first() else {
        return Ok(());
    };
    let contestants = machines.iter().zip(&calls);
    let contestants = contestants
        .map(|((format, _), call)| Contestant::warm(format.name.clone(), call, first))
        .collect();
    for sample in interleave(contestants, &realisations, speed.rounds, studies.seed) {
        let arithmetic = machines
            .iter()
            .find(|(format, _)| format.name == sample.name)
            .map(|(format, _)| format.arithmetic);
        records
            .own
            .speed
            .extend(arithmetic.map(|arithmetic| SpeedRow {
                format: sample.name,
                arithmetic,
                n: speed.n,
                realisation: sample.realisation,
                round: sample.round,
                calls: sample.calls,
                nanoseconds: sample.nanoseconds,
            }));
    }
    progress.finished(&speed.distribution);
    Ok(())
}

fn call(machine: Machine, eps2: f64) -> impl Fn(&Vec<Point3>) {
    move |points: &Vec<Point3>| {
        if let Ok(points) = Points::new(black_box(points)) {
            let _ = black_box((machine.facets)(points, eps2));
        }
    }
}
