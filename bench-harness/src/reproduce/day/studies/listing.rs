//! The faces of the finished hull, listed by the paper's spiral and by a plain traversal (D-9).

use super::METHOD;
use crate::reproduce::day::definition::Studies;
use crate::reproduce::day::formats::is_right;
use crate::reproduce::day::records::{ListingRow, Records};
use crate::reproduce::day::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::sets::PointSet3;
use crate::reproduce::space::certify::certify;
use anyhow::Result;
use divide_and_conquer::preparata_hong_3d::listings;
use geometry_core::{Exact, Hull3, Points};
use std::collections::BTreeSet;

/// The name of this study in the records.
const STAGE: &str = "listing";

/// Lists the faces of every set of the study.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let progress = Progress::start(STAGE, studies.listing.len());
    for block in &studies.listing {
        let listed = parallel::map(&block.sets(), |(distribution, n, replicate)| {
            let set = sets::generate(studies.seed, distribution, *n, *replicate)?;
            let certified = certify(STAGE, &set, &[METHOD.to_owned()])?;
            let row = match &certified.hull {
                Some(hull) => Some(row(&set, hull)?),
                None => None,
            };
            Ok((certified, row))
        })?;
        for (certified, row) in listed {
            records.sets.push(certified.set);
            records.failures.extend(certified.failures);
            records.own.listings.extend(row);
        }
        progress.finished(&format!("{:?}", block.distributions));
    }
    Ok(())
}

/// Both lists of one certified hull.
fn row(set: &PointSet3, hull: &Hull3) -> Result<ListingRow> {
    let points = Points::new(&set.points)?;
    let listings = listings(points, &Exact)?;
    let spiral: BTreeSet<[u32; 3]> = listings.spiral.iter().copied().map(named).collect();
    let plain: BTreeSet<[u32; 3]> = listings.by_number.iter().copied().map(named).collect();
    let pairs = listings.spiral.windows(2);
    let share_an_edge = |pair: &&[[u32; 3]]| {
        let common = pair[0].iter().filter(|id| pair[1].contains(id));
        common.count() == 2
    };
    Ok(ListingRow {
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        faces: plain.len(),
        listed: listings.spiral.len(),
        only_one: spiral.symmetric_difference(&plain).count(),
        is_hull: is_right(points, &listings.spiral, hull),
        neighbours: pairs.filter(share_an_edge).count(),
        deepest: listings.deepest,
    })
}

/// A face from its smallest corner on.
fn named(mut corners: [u32; 3]) -> [u32; 3] {
    let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
    corners.rotate_left(first);
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_lists_are_the_hull() {
        for distribution in ["ball", "fan:axis=x", "cubic-lattice"] {
            let set = sets::generate(1, distribution, 66, 0).expect("a set");
            let hull = hullkit::convex_hull_3d(&set.points).expect("finite");
            let row = row(&set, &hull).expect("lists");
            assert!(row.is_hull && row.only_one == 0, "{row:?}");
            assert_eq!(row.listed, row.faces);
            assert!(row.neighbours < row.listed && row.deepest <= row.listed);
        }
    }
}
