//! Day's cotangents in several number formats, over powers of ten of eps2, in several ranges and at several offsets
//! (D-1).
//!
//! The points are rounded to the format first. The control is the exact method on the same rounded points; a run is right
//! if its faces are the surface of the hull so certified.

use super::proved_in;
use crate::reproduce::day::definition::{PrecisionCells, Studies};
use crate::reproduce::day::formats::{self, Machine};
use crate::reproduce::day::records::{ControlRow, PrecisionRow, Records};
use crate::reproduce::day::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::FailureRow;
use crate::reproduce::sets::digest;
use anyhow::{Context, Result};
use divide_and_conquer::preparata_hong_3d::cotangent::Outcome;
use geometry_core::Hull3;

/// The name of this study in the records.
const STAGE: &str = "precision";

/// Runs every cell of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let blocks = &studies.precision.cells;
    let progress = Progress::start(STAGE, blocks.len());
    for block in blocks {
        for &range in &block.ranges {
            for &offset in &block.offsets {
                for name in &block.formats {
                    let cell = Cell {
                        studies,
                        block,
                        range,
                        offset,
                        machine: formats::find(name)?,
                    };
                    cell.run(records)?;
                }
            }
        }
        let PrecisionCells { n, formats, .. } = block;
        progress.finished(&format!("n = {n}, {}", formats.join(" ")));
    }
    Ok(())
}

/// One format on one kind of sets.
struct Cell<'a> {
    studies: &'a Studies,
    block: &'a PrecisionCells,
    range: f64,
    offset: f64,
    machine: Machine,
}

/// What one set gave: its fingerprint as rounded, whether it is in general position, and the end at each power.
struct Tried {
    fingerprint: String,
    general: bool,
    ends: Vec<Outcome>,
    failures: Vec<FailureRow>,
}

impl Cell<'_> {
    fn run(&self, records: &mut Records) -> Result<()> {
        let numbers: Vec<u64> = (0..self.block.sets).collect();
        let tried = parallel::map(&numbers, |&replicate| self.set(replicate))?;
        let digest = digest(tried.iter().map(|tried| &tried.fingerprint));
        let certified = || tried.iter().filter(|tried| !tried.ends.is_empty());
        let format = self.machine.name;
        let bits = self.studies.format(format);
        let bits = bits.with_context(|| format!("{format} has no bits"))?.bits;
        for (place, power) in self.powers().enumerate() {
            let count = |end| certified().filter(|tried| tried.ends[place] == end).count();
            records.own.precision.push(PrecisionRow {
                distribution: self.block.distribution.clone(),
                n: self.block.n,
                range: self.range,
                offset: self.offset,
                format: format.to_owned(),
                bits,
                power,
                sets: certified().count(),
                right: count(Outcome::Right),
                wrong: count(Outcome::WrongHull),
                endless: count(Outcome::NotTerminating),
                dangling: count(Outcome::Dangling),
                digest: digest.clone(),
            });
        }
        records.own.controls.push(ControlRow {
            distribution: self.block.distribution.clone(),
            n: self.block.n,
            range: self.range,
            offset: self.offset,
            format: format.to_owned(),
            sets: tried.len(),
            right: certified().count(),
            general: certified().filter(|tried| tried.general).count(),
        });
        let failures = tried.into_iter().flat_map(|tried| tried.failures);
        records.failures.extend(failures);
        Ok(())
    }

    fn powers(&self) -> impl Iterator<Item = i32> + use<> {
        let [first, last] = self.block.powers;
        first..=last
    }

    fn set(&self, replicate: u64) -> Result<Tried> {
        let PrecisionCells {
            distribution, n, ..
        } = self.block;
        let set = sets::generate(self.studies.seed, distribution, *n, replicate)?;
        let set = sets::placed(set, self.range, self.offset);
        let (set, hull) = proved_in(STAGE, set, &self.machine)?;
        let fingerprint = set.fingerprint();
        Ok(match hull {
            Ok(hull) => Tried {
                fingerprint,
                general: matches!(hull, Hull3::Solid(_))
                    && hull.facets().all(|facet| facet.len() == 3),
                ends: self
                    .powers()
                    .map(|power| self.machine.end(&set.points, &hull, power))
                    .collect(),
                failures: Vec::new(),
            },
            Err(failures) => Tried {
                fingerprint,
                general: false,
                ends: Vec::new(),
                failures,
            },
        })
    }
}
