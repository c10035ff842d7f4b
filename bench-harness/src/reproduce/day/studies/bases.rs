//! How many orientations it would take to stop the recursion at parts of several sizes (D-6), and sets that need dummy
//! points.
//!
//! The method as it is goes down to single points. Its merges of more than so many points are those it would have if the
//! hulls of parts of that size came from elsewhere; what these cost is counted on the parts themselves:
//!
//! | way | orientations for a part of m points |
//! |---|---|
//! | none | 0: a point is its own hull |
//! | tetrahedron | 1: the sign of Day's triple product, for m = 4 |
//! | gift wrapping | as `pivot-wrap` asks once the dimension is known |
//! | every triple | each plane of three points tried against the others, until two are on different sides |

use super::{METHOD, proved_in};
use crate::reproduce::day::definition::{Bases, Dummies, Studies};
use crate::reproduce::day::records::{BaseRow, DummyRow, Records};
use crate::reproduce::day::{formats, sets};
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::sets::{PointSet3, digest};
use crate::reproduce::space::certify::certify;
use crate::reproduce::space::spatial_method;
use anyhow::Result;
use divide_and_conquer::preparata_hong_3d::cotangent::Outcome;
use divide_and_conquer::preparata_hong_3d::{MergeRecord, Variant, merges};
use geometry_core::dimension::AffineBasis;
use geometry_core::{Counted, Exact, Kernel3, Point3, Points, Sign, Tally};

/// The name of this study in the records.
const STAGE: &str = "bases";

/// Counts every base of the study, and tries the sets with dummies.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let progress = Progress::start(STAGE, 2);
    let Bases {
        distributions,
        n,
        replicates,
        sizes,
    } = &studies.bases;
    let mut all = Vec::new();
    for distribution in distributions {
        all.extend((0..*replicates).map(|replicate| (distribution, replicate)));
    }
    let counted = parallel::map(&all, |&(distribution, replicate)| {
        let set = sets::generate(studies.seed, distribution, *n, replicate)?;
        let certified = certify(STAGE, &set, &[METHOD.to_owned()])?;
        let rows = match certified.hull {
            Some(_) => rows(&set, sizes)?,
            None => Vec::new(),
        };
        Ok((certified, rows))
    })?;
    for (certified, rows) in counted {
        records.sets.push(certified.set);
        records.failures.extend(certified.failures);
        records.own.bases.extend(rows);
    }
    progress.finished("sizes of a part");
    dummies(studies, records)?;
    progress.finished("dummy points");
    Ok(())
}

/// Every base on one set.
fn rows(set: &PointSet3, sizes: &[usize]) -> Result<Vec<BaseRow>> {
    let merges = merges(Points::new(&set.points)?, Variant::Resumed, &Exact)?;
    let mut sorted = set.points.clone();
    sorted.sort_unstable_by(|&p, &q| Exact.lexicographic3(p, q));
    let row = |size: usize, way: &str, base: u64| BaseRow {
        distribution: set.distribution.clone(),
        n: set.n,
        replicate: set.replicate,
        size,
        way: way.to_owned(),
        base,
        merges: above(&merges, size),
    };
    let mut rows = vec![row(1, "none", 0)];
    for &size in sizes {
        let parts = sorted.chunks(size);
        if size == 4 {
            rows.push(row(size, "tetrahedron", parts.len() as u64));
            continue;
        }
        let (mut wrapped, mut tried) = (0, 0);
        for part in parts {
            wrapped += by_gift_wrapping(part)?;
            tried += by_every_triple(part);
        }
        rows.push(row(size, "gift wrapping", wrapped));
        rows.push(row(size, "every triple", tried));
    }
    Ok(rows)
}

/// Comparisons of candidates in merges of more than `size` points.
fn above(merges: &[MergeRecord], size: usize) -> u64 {
    let above = merges.iter().filter(|merge| merge.points as usize > size);
    above.map(|merge| merge.candidates).sum()
}

fn by_gift_wrapping(part: &[Point3]) -> Result<u64> {
    let points = Points::new(part)?;
    let basis = Counted::new(Exact);
    let _ = AffineBasis::of(points, &basis);
    let kernel = Counted::new(Exact);
    let mut tally = Tally::default();
    let hull = (spatial_method("pivot-wrap")?.tallied)(points, &kernel, &mut tally)?;
    // Three for each triangle, to see whether it is coplanar with a neighbour.
    let triangles = 2 * hull.len() as u64 - 4;
    let asked = |kernel: &Counted<Exact>| kernel.counts().orientations_in_space.total();
    Ok(asked(&kernel).saturating_sub(asked(&basis) + 3 * triangles))
}

fn by_every_triple(part: &[Point3]) -> u64 {
    let mut asked = 0;
    for k in 2..part.len() {
        for j in 1..k {
            for i in 0..j {
                let mut side = Sign::Zero;
                for (id, &point) in part.iter().enumerate() {
                    if [i, j, k].contains(&id) {
                        continue;
                    }
                    asked += 1;
                    let sign = Exact.orient3(part[i], part[j], part[k], point);
                    if sign == -side && !sign.is_zero() {
                        break;
                    }
                    side = sign;
                }
            }
        }
    }
    asked
}

/// Sets whose number of points is no multiple of four, by the rounded program, which adds points inside.
fn dummies(studies: &Studies, records: &mut Records) -> Result<()> {
    let Dummies {
        distribution,
        n,
        format,
        power,
        sets,
    } = &studies.dummies;
    let machine = formats::find(format)?;
    for &n in n {
        let numbers: Vec<u64> = (0..*sets).collect();
        let tried = parallel::map(&numbers, |&replicate| {
            let set = sets::generate(studies.seed, distribution, n, replicate)?;
            let (set, hull) = proved_in("dummies", set, &machine)?;
            let end = hull.map(|hull| machine.end(&set.points, &hull, *power));
            Ok((set.fingerprint(), end))
        })?;
        let certified = tried.iter().filter(|(_, end)| end.is_ok());
        let right = tried
            .iter()
            .filter(|(_, end)| matches!(end, Ok(Outcome::Right)));
        records.own.dummies.push(DummyRow {
            distribution: distribution.clone(),
            n,
            format: format.clone(),
            power: *power,
            sets: certified.count(),
            right: right.count(),
            digest: digest(tried.iter().map(|(fingerprint, _)| fingerprint)),
        });
        let failures = tried.into_iter().filter_map(|(_, end)| end.err());
        records.failures.extend(failures.flatten());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tetrahedron_by_every_way() {
        let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        // Four planes, one point each.
        assert_eq!(by_every_triple(&corner), 4);
        // With a point inside: one more for each of them, and six planes through that point, which part the others.
        let with_inside = [&corner[..], &[[0.2, 0.21, 0.22]]].concat();
        assert_eq!(by_every_triple(&with_inside), 4 * 2 + 6 * 2);
    }

    #[test]
    fn the_merges_above_are_those_of_more_points() {
        let set = sets::generate(1, "ball", 64, 0).expect("a set");
        let rows = rows(&set, &[4, 8]).expect("counted");
        let ways: Vec<(usize, &str)> = rows
            .iter()
            .map(|row| (row.size, row.way.as_str()))
            .collect();
        let expected = [
            (1, "none"),
            (4, "tetrahedron"),
            (8, "gift wrapping"),
            (8, "every triple"),
        ];
        assert_eq!(ways, expected);
        assert_eq!(rows[1].base, 16);
        assert!(rows[0].merges > rows[1].merges && rows[1].merges > rows[2].merges);
        assert!(rows[2].base > 0 && rows[2].base < rows[3].base);
    }
}
