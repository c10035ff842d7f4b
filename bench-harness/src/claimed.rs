//! Hulls as others state them, turned into the values that the checker proves or refutes.
//!
//! Nothing here trusts a claim: whatever it says becomes the value that it would be if it were right, and the checker
//! finds out.

use geometry_core::hull2::sort_distinct;
use geometry_core::hull3::Solid;
use geometry_core::kernel::lexicographic;
use geometry_core::kernel::space::lexicographic3;
use geometry_core::mesh::{TriMesh, TriangleId};
use geometry_core::{Exact, Hull2, Hull3, Kernel2, Layers, Point2, Points};
use hull_verify::check::{self, Certificate3, Finding3};
use std::collections::HashMap;

/// The value that the cycle `ids` stands for. Ids that name no point are left for the checker to find.
pub fn planar(points: Points<'_, 2>, mut ids: Vec<u32>) -> Hull2 {
    if ids.iter().any(|&id| id as usize >= points.len()) {
        return Hull2::Polygon(ids);
    }
    let at = |id: &u32| points[*id];
    let is_flat = |c: &u32| -> bool {
        let [a, b]: [Point2; 2] = [&ids[0], &ids[1]].map(at);
        Exact.orient(a, b, at(c)).is_zero() && lexicographic(a, b).is_ne()
    };
    if ids.len() > 2 && ids.iter().all(is_flat) {
        sort_distinct(points, &mut ids, &Exact);
        return Hull2::Segment(ids);
    }
    Hull2::from_cycle(points, ids)
}

/// The value that `polygons` stand for, seen from outside; without any, `vertices` are those of a point or a segment.
/// Every id must name a point.
pub fn spatial(points: Points<'_, 3>, vertices: &[u32], mut polygons: Vec<Vec<u32>>) -> Hull3 {
    let by_place = |a: &u32, b: &u32| lexicographic3(points[*a], points[*b]);
    match (&mut polygons[..], vertices) {
        ([], []) => Hull3::Empty,
        ([], [id]) => Hull3::Point(*id),
        ([], [first, rest @ ..]) => {
            let ends = rest.iter().fold([*first; 2], |[low, high], &id| {
                [
                    std::cmp::min_by(low, id, by_place),
                    std::cmp::max_by(high, id, by_place),
                ]
            });
            Hull3::Segment(ends)
        }
        ([corners], _) => {
            let first = (0..corners.len()).min_by(|&i, &j| by_place(&corners[i], &corners[j]));
            corners.rotate_left(first.unwrap_or(0));
            if let [_, second, .., last] = &corners[..]
                && by_place(last, second).is_lt()
            {
                corners[1..].reverse();
            }
            Hull3::Planar(std::mem::take(corners))
        }
        _ => Hull3::Solid(Solid::from_loops(polygons)),
    }
}

/// The certificate of `hull`; if nothing is wrong with it but that facets are cut into coplanar pieces, that of the
/// whole facets.
///
/// # Errors
///
/// What is wrong with it.
pub fn certify3(points: Points<'_, 3>, hull: &Hull3) -> Result<Certificate3, Vec<Finding3>> {
    let findings = match check::hull3(points.as_slice(), hull) {
        Ok(certificate) => return Ok(certificate),
        Err(findings) => findings,
    };
    let is_cut = |finding: &Finding3| matches!(finding, Finding3::CoplanarFacets { .. });
    if !findings.iter().all(is_cut) {
        return Err(findings);
    }
    // The checker went through the topology before it came to coplanar facets: the surface is closed.
    let whole = Hull3::from_mesh(points, &triangulated(hull), &Exact);
    check::hull3(points.as_slice(), &whole)
}

/// The closed surface of `hull`, cut into triangles.
fn triangulated(hull: &Hull3) -> TriMesh {
    let mut mesh = TriMesh::new();
    let mut sides = HashMap::new();
    let triangles: Vec<TriangleId> = hull.triangles().map(|corners| mesh.add(corners)).collect();
    for side in triangles.into_iter().flat_map(TriangleId::sides) {
        sides.insert((mesh.origin(side), mesh.target(side)), side);
    }
    for (&(from, to), &side) in &sides {
        if let Some(&twin) = sides.get(&(to, from)) {
            mesh.link(side, twin);
        }
    }
    mesh
}

/// The value that the cycles `rings`, outermost first, stand for. Every id must name a point; a point that is on no
/// ring and a copy of none is left for the checker to find.
pub fn layers(points: Points<'_, 2>, rings: Vec<Vec<u32>>) -> Layers {
    let mut stage_of = vec![0; points.len()];
    for (stage, ring) in (1..).zip(&rings) {
        for &id in ring {
            stage_of[id as usize] = stage;
        }
    }
    let smallest = smallest_copies(points.as_slice());
    let stages = points
        .ids()
        .map(|id| stage_of[smallest[&key(points[id])] as usize])
        .collect();
    let rings = rings.into_iter().map(|ring| planar(points, ring)).collect();
    Layers::new(rings, stages)
}

/// The smallest index of the copies of each point, by its [`key`].
pub fn smallest_copies<const D: usize>(points: &[[f64; D]]) -> HashMap<[u64; D], u32> {
    let mut smallest = HashMap::with_capacity(points.len());
    for (id, point) in (0..).zip(points) {
        smallest.entry(key(*point)).or_insert(id);
    }
    smallest
}

/// Coordinates as bits, the two zeros alike.
pub fn key<const D: usize>(point: [f64; D]) -> [u64; D] {
    point.map(|coordinate| (coordinate + 0.0).to_bits())
}
