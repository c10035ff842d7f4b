//! The paper's arithmetic, unit normals and an epsilon, against exact answers (N-5).
//!
//! A run is right if its triangles are the surface of the certified hull of the points as they were given to it.

use super::proved;
use crate::reproduce::data::product;
use crate::reproduce::nathan::definition::Studies;
use crate::reproduce::nathan::records::{EpsilonRow, Records};
use crate::reproduce::nathan::sets;
use crate::reproduce::progress::Progress;
use crate::reproduce::space::surface::is_hull;
use anyhow::Result;
use geometry_core::{Exact, Hull3, Perturbed, Points, Silent};
use gift_wrap::nathan::{NathanOptions, OwnCorners, PrintedArithmetic, study};

/// The runs on each set: arithmetic and what is done with a candidate's own corners, by name.
const ARMS: [(&str, &str); 3] = [
    ("epsilon", "tested"),
    ("epsilon", "skipped"),
    ("exact", "tested"),
];

/// Wraps every set of the study at every offset.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let block = &studies.epsilon;
    let cells = product(&block.distributions, &[block.n]);
    let progress = Progress::start("epsilon", cells.len());
    for (distribution, n) in cells {
        for &offset in &block.offsets {
            let cell = (distribution.as_str(), n, block.sets);
            let (tried, digest) = sets::each_moved(studies.seed, cell, offset, |set| {
                let hull = proved("epsilon", &set)?;
                let wrong = match &hull {
                    Ok(hull) => Some(ARMS.map(|arm| is_wrong(&set.points, arm, hull))),
                    Err(_) => None,
                };
                Ok((wrong, hull.err()))
            })?;
            for (place, (arithmetic, own_corners)) in ARMS.into_iter().enumerate() {
                let outcomes = || tried.iter().filter_map(|(wrong, _)| *wrong);
                records.own.epsilon.push(EpsilonRow {
                    distribution: distribution.clone(),
                    n,
                    offset,
                    arithmetic: arithmetic.to_owned(),
                    own_corners: own_corners.to_owned(),
                    sets: outcomes().count(),
                    wrong: outcomes().filter(|wrong| wrong[place]).count(),
                    digest: digest.clone(),
                });
            }
            let failures = tried.into_iter().filter_map(|(_, failures)| failures);
            records.failures.extend(failures.flatten());
        }
        progress.finished(&distribution);
    }
    Ok(())
}

fn is_wrong(points: &[[f64; 3]], (arithmetic, own): (&str, &str), hull: &Hull3) -> bool {
    let Ok(points) = Points::new(points) else {
        return true;
    };
    let own_corners = match own {
        "skipped" => OwnCorners::Skipped,
        _ => OwnCorners::Tested,
    };
    let options = NathanOptions {
        own_corners,
        ..NathanOptions::PRINTED
    };
    let run = match arithmetic {
        "epsilon" => study(points, options, &PrintedArithmetic::of(points), &mut Silent),
        _ => study(points, options, &Perturbed(Exact), &mut Silent),
    };
    !is_hull(points, &run.triangles, hull)
}
