//! Delaunay triangulations by lifting, with heights computed in doubles and without computed heights (N-7).
//!
//! Of every certified triangulation, each pair of neighbouring triangles asks one question: is the corner beyond inside
//! the circle? The orientation of the four points lifted to computed heights is an exact answer about points that are
//! not on the paraboloid.

use crate::reproduce::data::product;
use crate::reproduce::nathan::definition::{Shifted, Studies};
use crate::reproduce::nathan::records::{GridRow, LiftRow, Records};
use crate::reproduce::nathan::sets;
use crate::reproduce::parallel;
use crate::reproduce::progress::Progress;
use crate::reproduce::sets::digest;
use anyhow::Result;
use geometry_core::{
    Axis, Exact, Hull3, InCircle, Kernel3, Lifted, Point2, Point3, Points, Triangulation,
};
use std::collections::HashMap;

/// Triangulates every set of the study at every offset, and lifts the grids.
pub(crate) fn run(studies: &Studies, records: &mut Records) -> Result<()> {
    let cells = |block: &Shifted| product(&block.distributions, &[block.n]);
    let all = studies.lifting.iter().map(|block| cells(block).len()).sum();
    let progress = Progress::start("lifting", all);
    for block in &studies.lifting {
        for (distribution, n) in cells(block) {
            for &offset in &block.offsets {
                let replicates: Vec<u64> = (0..block.sets).collect();
                let tried = parallel::map(&replicates, |&replicate| {
                    let seed = studies.seed;
                    let points = sets::generate_planar(seed, &distribution, n, replicate, offset)?;
                    Ok((point_sets::fingerprint(&points).to_string(), lift(&points)?))
                })?;
                let mut row = LiftRow {
                    distribution: distribution.clone(),
                    n,
                    offset,
                    sets: tried.len(),
                    digest: digest(tried.iter().map(|(fingerprint, _)| fingerprint)),
                    ..LiftRow::default()
                };
                for (_, lifted) in &tried {
                    row.exact_right += usize::from(lifted.exact_is_right);
                    row.rounded_right += usize::from(lifted.rounded_is_right);
                    row.quadruples += lifted.quadruples;
                    row.wrong_signs += lifted.wrong_signs;
                }
                records.own.lifting.push(row);
            }
            progress.finished(&format!("{distribution} {n}"));
        }
    }
    let grids = &studies.grids;
    let rows = grids.grids.iter();
    let rows = rows.map(|&[spacing, offset]| grid(grids.side, spacing, offset));
    records.own.grids.extend(rows);
    Ok(())
}

/// What lifting did on one set.
struct LiftedSet {
    exact_is_right: bool,
    rounded_is_right: bool,
    quadruples: u64,
    wrong_signs: u64,
}

fn lift(points: &[Point2]) -> Result<LiftedSet> {
    let exact = hullkit::delaunay(points)?;
    let exact_is_right = hull_verify::check::delaunay(points, &exact).is_ok();
    let rounded = by_rounded_heights(points)?;
    let rounded_is_right = hull_verify::check::delaunay(points, &rounded).is_ok();
    let (mut quadruples, mut wrong_signs) = (0, 0);
    // What is not certified is not counted.
    if exact_is_right {
        for corners in neighbours(&exact) {
            let [a, b, c, d] = corners.map(|id| points[id as usize]);
            quadruples += 1;
            wrong_signs += u64::from(is_wrong(a, b, c, d));
        }
    }
    Ok(LiftedSet {
        exact_is_right,
        rounded_is_right,
        quadruples,
        wrong_signs,
    })
}

/// (x, y, x² + y²), in doubles.
fn lifted([x, y]: Point2) -> Point3 {
    [x, y, x * x + y * y]
}

/// Whether the lifts to computed heights are oriented otherwise than the true ones.
fn is_wrong(a: Point2, b: Point2, c: Point2, d: Point2) -> bool {
    let [p, q, r, s] = [a, b, c, d].map(lifted);
    Exact.orient3(p, q, r, s) != Lifted(Exact).orient3(p, q, r, s)
}

/// The paper's recipe: the hull of the lifts, exactly, and of its facets those that face downwards.
fn by_rounded_heights(points: &[Point2]) -> Result<Triangulation> {
    let heights: Vec<Point3> = points.iter().copied().map(lifted).collect();
    let hull = hullkit::convex_hull_3d(&heights)?;
    let places = Points::new(&heights)?;
    let Hull3::Solid(solid) = hull else {
        return Ok(Triangulation::default());
    };
    let mut triangles = Vec::new();
    for facet in solid.facets() {
        let [a, b, c] = [0, 1, 2].map(|i| places[facet[i]]);
        if Exact.shadow(Axis::Z, a, b, c).is_negative() {
            let fan = facet.windows(2).skip(1);
            triangles.extend(fan.map(|edge| [facet[0], edge[1], edge[0]]));
        }
    }
    Ok(Triangulation::new(triangles))
}

/// For each edge of two triangles the corners of one and the corner beyond.
fn neighbours(triangulation: &Triangulation) -> Vec<[u32; 4]> {
    let mut apexes: HashMap<[u32; 2], u32> = HashMap::new();
    for &[a, b, c] in triangulation.triangles() {
        apexes.extend([([a, b], c), ([b, c], a), ([c, a], b)]);
    }
    let edges = triangulation.edges().into_iter();
    edges
        .filter_map(|[a, b]| {
            let (left, right) = (apexes.get(&[a, b])?, apexes.get(&[b, a])?);
            Some([a, b, *left, *right])
        })
        .collect()
}

fn grid(side: u32, spacing: f64, offset: f64) -> GridRow {
    let place = |i: u32, j: u32| [i, j].map(|step| offset + spacing * f64::from(step));
    let mut row = GridRow {
        spacing,
        offset,
        ..GridRow::default()
    };
    for i in 0..side {
        for j in 0..side {
            let corners = [
                place(i, j),
                place(i + 1, j),
                place(i + 1, j + 1),
                place(i, j + 1),
            ];
            let [a, b, c, d] = corners;
            if Exact.in_circle(a, b, c, d).is_zero() {
                row.cocircular += 1;
                row.wrong_signs += u64::from(is_wrong(a, b, c, d));
            }
        }
    }
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_the_origin_rounded_heights_do() {
        let near = sets::generate_planar(1, "square", 200, 0, 0.0).expect("a set");
        let lifted = lift(&near).expect("finite");
        assert!(lifted.exact_is_right && lifted.rounded_is_right);
        assert_eq!(lifted.wrong_signs, 0);
        // An edge inside for each of 3n - 3 - h, less the h of the outline.
        assert!(lifted.quadruples > 500 && lifted.quadruples < 600);
    }

    #[test]
    fn far_from_the_origin_only_exact_lifts_do() {
        let far = sets::generate_planar(1, "square", 200, 0, 1e7).expect("a set");
        let lifted = lift(&far).expect("finite");
        assert!(lifted.exact_is_right && !lifted.rounded_is_right);
        assert!(lifted.wrong_signs > 50);
    }

    #[test]
    fn integers_are_lifted_exactly_until_their_squares_are_rounded() {
        for [spacing, offset] in [[1.0, 0.0], [3.0, 0.0], [0.125, 0.0], [1.0, 67_108_800.0]] {
            let row = grid(50, spacing, offset);
            assert_eq!(
                (row.cocircular, row.wrong_signs),
                (2_500, 0),
                "{spacing} {offset}"
            );
        }
        assert!(grid(50, 0.1, 0.0).wrong_signs > 0);
    }
}
