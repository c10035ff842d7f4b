//! What wrapping asks: as printed, corrected, and by pivoting (N-1, N-2, N-3).
//!
//! The kernel is exact and perturbed, so that the counts are those of the method and not of its epsilon. A wrap whose
//! triangles are not the certified hull is a failure and is not counted.

use super::failure;
use crate::reproduce::data::product;
use crate::reproduce::nathan::definition::{Studies, Variant, Wraps};
use crate::reproduce::nathan::records::{Records, WrapRow};
use crate::reproduce::nathan::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::rows::FailureRow;
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::{Certified3, certify};
use crate::reproduce::space::spatial_method;
use crate::reproduce::space::surface::is_hull;
use anyhow::Result;
use geometry_core::dimension::AffineBasis;
use geometry_core::{Counted, Exact, Hull3, Perturbed, Points, Silent, Tally};
use gift_wrap::nathan::{NathanOptions, study};

const STAGE: &str = "wraps";

/// Wraps every cell of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let cells = |block: &Wraps| product(&block.distributions, &block.n);
    let all = studies.wraps.iter().map(|block| cells(block).len()).sum();
    let progress = Progress::start(STAGE, all);
    for block in &studies.wraps {
        for (distribution, n) in cells(block) {
            let replicates: Vec<u64> = (0..block.replicates).collect();
            let done = parallel::map(&replicates, |&replicate| {
                let set = sets::generate(studies.seed, &distribution, n, replicate)?;
                wrap(&sets::ordered(set, block.order), block)
            })?;
            for (certified, rows) in done {
                records.sets.push(certified.set);
                records.failures.extend(certified.failures);
                for row in rows {
                    match row {
                        Ok(row) => records.own.wraps.push(row),
                        Err(failure) => records.failures.push(failure),
                    }
                }
            }
            progress.finished(&format!("{distribution} {n}, {}", block.order.name()));
        }
    }
    Ok(())
}

/// Every variant of the block on one set.
fn wrap(set: &PointSet3, block: &Wraps) -> Result<(Certified3, Vec<Result<WrapRow, FailureRow>>)> {
    let certified = certify(
        STAGE,
        set,
        &["quickhull-3d", "pivot-wrap"].map(str::to_owned),
    )?;
    let mut rows = Vec::new();
    if let Some(hull) = &certified.hull {
        for &variant in &block.variants {
            let base = WrapRow {
                distribution: set.distribution.clone(),
                order: block.order.name().to_owned(),
                n: set.n,
                replicate: set.replicate,
                variant: variant.name().to_owned(),
                h: hull.len(),
                ..WrapRow::default()
            };
            rows.push(match variant {
                Variant::Printed => by_trial(set, hull, NathanOptions::PRINTED, base)?,
                Variant::Corrected => by_trial(set, hull, NathanOptions::CORRECTED, base)?,
                Variant::PivotWrap => by_pivoting(set, hull, base)?,
            });
        }
    }
    Ok((certified, rows))
}

fn by_trial(
    set: &PointSet3,
    hull: &Hull3,
    options: NathanOptions,
    base: WrapRow,
) -> Result<Result<WrapRow, FailureRow>> {
    let points = Points::new(&set.points)?;
    let run = study(points, options, &Perturbed(Exact), &mut Silent);
    if !is_hull(points, &run.triangles, hull) {
        let what = "the triangles are not those of the certified hull";
        return Ok(Err(failure(STAGE, set, &base.variant, what)));
    }
    Ok(Ok(WrapRow {
        triangles: run.triangles.len(),
        repetitions: run.repetitions(),
        searches: run.searches,
        edge_tests: run.edge_tests,
        plane_tests: run.plane_tests,
        mark_comparisons: run.mark_comparisons,
        ..base
    }))
}

/// The orientations after the dimension of the set was known, which is found out by every method in the same way.
fn by_pivoting(
    set: &PointSet3,
    hull: &Hull3,
    base: WrapRow,
) -> Result<Result<WrapRow, FailureRow>> {
    let points = Points::new(&set.points)?;
    let setting_up = Counted::new(Exact);
    AffineBasis::of(points, &setting_up);
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let found = (spatial_method("pivot-wrap")?.tallied)(points, &kernel, &mut tally)?;
    if &found != hull {
        let what = "not the certified hull";
        return Ok(Err(failure(STAGE, set, &base.variant, what)));
    }
    let orientations = |kernel: &Counted<Exact>| kernel.counts().orientations_in_space.total();
    Ok(Ok(WrapRow {
        triangles: tally.facets as usize,
        searches: tally.lines,
        plane_tests: orientations(&kernel) - orientations(&setting_up),
        ..base
    }))
}
