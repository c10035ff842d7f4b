//! The point sets of the experiments: those of the catalogue, some of them changed.

use crate::reproduce::sets::PointSet3;
use anyhow::Result;

/// Before the name of a set laid along x: the set turned about x by a step and a half of FAN's ring, so that the wrap
/// of the last merge begins away from the vertex that recurs.
const TURNED: &str = "turned ";

/// Generates replicate `replicate` of the cell (`distribution`, `n`).
pub(crate) fn generate(
    seed: u64,
    distribution: &str,
    n: usize,
    replicate: u64,
) -> Result<PointSet3> {
    let Some(plain) = distribution.strip_prefix(TURNED) else {
        return PointSet3::generate(seed, distribution, n, replicate);
    };
    let set = PointSet3::generate(seed, plain, n, replicate)?;
    let sides = (n.saturating_sub(2) / 4).max(3) * 2;
    Ok(set.changed(distribution, |points| turn(points, 1.5 / sides as f64)))
}

/// Turns about the x-axis by about `part` of a full turn: by the angle whose half has the tangent π `part`, since a
/// rotation given by that tangent takes no more than the four operations, which are the same everywhere.
fn turn(points: &mut [[f64; 3]], part: f64) {
    let tangent = std::f64::consts::PI * part;
    let square = tangent * tangent;
    let (cosine, sine) = (
        (1.0 - square) / (1.0 + square),
        2.0 * tangent / (1.0 + square),
    );
    for [_, y, z] in points {
        (*y, *z) = (cosine * *y - sine * *z, sine * *y + cosine * *z);
    }
}

/// The set stretched to the `range`, and moved by the `offset` along every axis.
pub(crate) fn placed(set: PointSet3, range: f64, offset: f64) -> PointSet3 {
    let name = set.distribution.clone();
    set.changed(&name, |points| {
        for point in points {
            *point = point.map(|coordinate| range * coordinate + offset);
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turned_set_keeps_its_heights_and_radii() {
        let plain = generate(1, "fan:axis=x", 66, 0).expect("a set");
        let turned = generate(1, "turned fan:axis=x", 66, 0).expect("a set");
        assert_ne!(plain.fingerprint(), turned.fingerprint());
        for (p, q) in plain.points.iter().zip(&turned.points) {
            assert!(p[0].total_cmp(&q[0]).is_eq());
            let radius = |p: &[f64; 3]| p[1].hypot(p[2]);
            assert!((radius(p) - radius(q)).abs() < 1e-12);
        }
    }

    #[test]
    fn a_placed_set_is_where_it_was_put() {
        let set = placed(generate(1, "cube", 50, 0).expect("a set"), 10.0, 100.0);
        let inside = |x: &f64| (100.0..=110.0).contains(x);
        assert!(set.points.iter().flatten().all(inside));
    }
}
