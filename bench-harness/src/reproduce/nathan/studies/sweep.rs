//! A box that moves, and point obstacles on its way: found by the hull of start and end, or by steps (N-8).
//!
//! Random obstacles are made of the box itself: a point of the box where it starts, carried a share of the way. All of
//! these numbers are multiples of 2⁻²⁰, so every obstacle is met in truth, not up to rounding.

use super::failure;
use crate::reproduce::nathan::definition::{Studies, Sweep};
use crate::reproduce::nathan::records::{Records, SweepRow};
use crate::reproduce::sets::PointSet3;
use anyhow::Result;
use geometry_core::Point3;
use geometry_core::hull3::Location;
use hullkit::sweep::swept_volume;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Checks the example's obstacle and the random ones, by the hull and by every number of steps.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let block = &studies.sweep;
    let volume = swept_volume(&corners(block.sides), block.by)?;
    if hull_verify::check::hull3(volume.points(), volume.hull()).is_err() {
        let set = PointSet3 {
            distribution: "box".to_owned(),
            n: volume.points().len(),
            replicate: 0,
            seed: 0,
            points: volume.points().to_vec(),
        };
        records
            .failures
            .push(failure("sweep", &set, "swept volume", "not certified"));
        return Ok(());
    }
    let random = obstacles(block, studies.seed);
    for (name, obstacles) in [("example", &[block.obstacle][..]), ("random", &random)] {
        let mut missed = 0;
        for &obstacle in obstacles {
            missed += usize::from(volume.locate(obstacle)? == Location::Outside);
        }
        let row = |steps, missed| SweepRow {
            obstacle: name.to_owned(),
            steps,
            obstacles: obstacles.len(),
            missed,
        };
        records.own.sweep.push(row(None, missed));
        for &steps in &block.steps {
            let is_missed = |obstacle: &&Point3| !is_met(block, **obstacle, steps);
            let missed = obstacles.iter().filter(is_missed).count();
            records.own.sweep.push(row(Some(steps), missed));
        }
    }
    Ok(())
}

fn corners(sides: Point3) -> Vec<Point3> {
    let corner = |i: u32| [0, 1, 2].map(|axis| f64::from(i >> axis & 1) * sides[axis]);
    (0..8).map(corner).collect()
}

/// Whether the box holds the obstacle at one of its stops, the start and the end among them.
fn is_met(block: &Sweep, obstacle: Point3, steps: u32) -> bool {
    (0..=steps).any(|step| {
        let share = f64::from(step) / f64::from(steps);
        (0..3).all(|axis| {
            let within = obstacle[axis] - share * block.by[axis];
            (0.0..=block.sides[axis]).contains(&within)
        })
    })
}

fn obstacles(block: &Sweep, seed: u64) -> Vec<Point3> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let unit = f64::from(1_u32 << 20);
    let mut share = || f64::from(random.random_range(0..=1_u32 << 20)) / unit;
    let mut obstacle = || {
        let way = share();
        [0, 1, 2].map(|axis| share() * block.sides[axis] + way * block.by[axis])
    };
    (0..block.obstacles).map(|_| obstacle()).collect()
}
