//! The sets of this paper's experiments: those of the catalogue, moved away from the origin or put in another order.

use super::definition::Order;
use crate::reproduce::parallel;
use crate::reproduce::sets::{PointSet3, digest};
use anyhow::{Context, Result};
use geometry_core::Point2;
use point_sets::Spec;
use std::str::FromStr;

/// Points of the unit sphere, pushed out to distance 1 from the z axis: the paper's epsilon is next to nothing here.
pub(crate) const CYLINDER: &str = "cylinder";

/// Replicate `replicate` of the cell (`name`, `n`): of [`CYLINDER`] or of a set of the catalogue.
pub(crate) fn generate(seed: u64, name: &str, n: usize, replicate: u64) -> Result<PointSet3> {
    if name != CYLINDER {
        return PointSet3::generate(seed, name, n, replicate);
    }
    let sphere = PointSet3::generate(seed, "sphere", n, replicate)?;
    Ok(sphere.changed(CYLINDER, |points| {
        for [x, y, _] in points {
            let length = (*x * *x + *y * *y).sqrt();
            (*x, *y) = (*x / length, *y / length);
        }
    }))
}

/// The set with `offset` added to every coordinate, rounded: what a method is then given.
pub(crate) fn moved(set: PointSet3, offset: f64) -> PointSet3 {
    let name = set.distribution.clone();
    set.changed(&name, |points| {
        for coordinate in points.as_flattened_mut() {
            *coordinate += offset;
        }
    })
}

/// What `work` makes of so many replicates of the cell (name, n, replicates), each with `offset` added to every coordinate;
/// and one name for all these sets.
pub(crate) fn each_moved<R: Send>(
    seed: u64,
    (name, n, replicates): (&str, usize, u64),
    offset: f64,
    work: impl Fn(PointSet3) -> Result<R> + Sync,
) -> Result<(Vec<R>, String)> {
    let replicates: Vec<u64> = (0..replicates).collect();
    let done = parallel::map(&replicates, |&replicate| {
        let set = moved(generate(seed, name, n, replicate)?, offset);
        Ok((set.fingerprint(), work(set)?))
    })?;
    let (fingerprints, results): (Vec<String>, Vec<R>) = done.into_iter().unzip();
    Ok((results, digest(fingerprints)))
}

/// The set in another order.
pub(crate) fn ordered(set: PointSet3, order: Order) -> PointSet3 {
    let name = set.distribution.clone();
    set.changed(&name, |points| {
        if order == Order::InsideOut {
            let square = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>();
            points.sort_by(|p, q| square(p).total_cmp(&square(q)));
        }
    })
}

/// Points of the plane, with `offset` added to every coordinate.
pub(crate) fn generate_planar(
    seed: u64,
    name: &str,
    n: usize,
    replicate: u64,
    offset: f64,
) -> Result<Vec<Point2>> {
    let spec = Spec::from_str(name).with_context(|| format!("the distribution {name:?}"))?;
    let seed = point_sets::cell_seed(seed, &spec, n, replicate);
    let mut points = spec
        .generate(n, seed)
        .with_context(|| format!("generating {n} points of {name:?}"))?;
    for coordinate in points.as_flattened_mut() {
        *coordinate += offset;
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cylinder_is_one() {
        let set = generate(1, CYLINDER, 50, 0).expect("a set");
        assert!(
            set.points
                .iter()
                .all(|[x, y, _]| (x.hypot(*y) - 1.0).abs() < 1e-15)
        );
        let far = moved(set.clone(), 1e3);
        assert!(far.points.iter().all(|p| p[2] >= 999.0));
        assert_ne!(far.fingerprint(), set.fingerprint());
    }

    #[test]
    fn inside_out_ends_far_out() {
        let set = ordered(generate(1, "ball", 50, 0).expect("a set"), Order::InsideOut);
        let square = |p: &[f64; 3]| p.iter().map(|x| x * x).sum::<f64>();
        assert!(
            set.points
                .windows(2)
                .all(|w| square(&w[0]) <= square(&w[1]))
        );
    }
}
