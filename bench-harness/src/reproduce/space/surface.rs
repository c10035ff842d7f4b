//! Whether triangles that know nothing of each other are the surface of a hull.

use geometry_core::{Exact, Hull3, Kernel3, Point3, Points};

/// Whether `triangles`, repetitions aside, are the surface of `hull`, which is certified: its triangles if it is
/// simplicial, else a triangulation of its facets.
///
/// A triangulation of facets is closed, each of its triangles has no vertex of the hull outside, and their areas sum
/// to that of the hull (to a relative 1e-9; a surface that covered the hull twice would have twice its area). It may
/// have triangles without area, between collinear points on an edge.
pub(crate) fn is_hull(points: Points<'_, 3>, triangles: &[[u32; 3]], hull: &Hull3) -> bool {
    let distinct = distinct(triangles);
    if hull.facets().all(|facet| facet.len() == 3) {
        return distinct.iter().copied().eq(hull.triangles());
    }
    let area: f64 = distinct
        .iter()
        .map(|corners| area(corners.map(|id| points[id])))
        .sum();
    let whole = hull.area(points);
    is_closed(&distinct)
        && distinct
            .iter()
            .all(|&corners| supports(points, corners, hull))
        && (area - whole).abs() <= 1e-9 * whole
}

/// Each triangle once, from its smallest index, in lexicographic order.
fn distinct(triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut distinct: Vec<[u32; 3]> = triangles.to_vec();
    for corners in &mut distinct {
        let first = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
        corners.rotate_left(first);
    }
    distinct.sort_unstable();
    distinct.dedup();
    distinct
}

/// Whether every side occurs once, and once in the opposite direction.
fn is_closed(triangles: &[[u32; 3]]) -> bool {
    let sides = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut sides: Vec<[u32; 2]> = sides.collect();
    sides.sort_unstable();
    let once = sides.windows(2).all(|pair| pair[0] != pair[1]);
    once && sides
        .iter()
        .all(|&[a, b]| sides.binary_search(&[b, a]).is_ok())
}

/// Whether the triangle has no vertex of the hull outside.
fn supports(points: Points<'_, 3>, corners: [u32; 3], hull: &Hull3) -> bool {
    let [a, b, c] = corners.map(|id| points[id]);
    let is_outside = |&id: &u32| Exact.orient3(a, b, c, points[id]).is_positive();
    !hull.vertices().iter().any(is_outside)
}

fn area([a, b, c]: [Point3; 3]) -> f64 {
    let minus = |p: Point3, q: Point3| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
    let (u, v) = (minus(b, a), minus(c, a));
    let normal = [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ];
    normal.iter().map(|x| x * x).sum::<f64>().sqrt() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry_core::{Perturbed, Silent};
    use gift_wrap::nathan::{NathanOptions, study};

    fn cube() -> Vec<Point3> {
        (0..8)
            .map(|i| [i & 1, i >> 1 & 1, i >> 2].map(f64::from))
            .collect()
    }

    #[test]
    fn any_triangulation_of_the_facets_will_do() {
        let cube = cube();
        let points = Points::new(&cube).expect("finite");
        let hull = hullkit::convex_hull_3d(&cube).expect("finite");
        let fans: Vec<[u32; 3]> = hull.triangles().collect();
        assert!(is_hull(points, &fans, &hull));
        let twice: Vec<[u32; 3]> = fans.iter().chain(&fans[3..5]).copied().collect();
        assert!(is_hull(points, &twice, &hull));
        assert!(!is_hull(points, &fans[1..], &hull));
        let mut turned = fans.clone();
        turned[0].swap(0, 1);
        assert!(!is_hull(points, &turned, &hull));
    }

    #[test]
    fn a_perturbed_wrap_of_a_lattice_is_its_hull() {
        let lattice: Vec<Point3> = (0..60)
            .map(|i| [i % 4, i / 4 % 4, i / 16].map(f64::from))
            .collect();
        let points = Points::new(&lattice).expect("finite");
        let hull = hullkit::convex_hull_3d(&lattice).expect("finite");
        let run = study(
            points,
            NathanOptions::PRINTED,
            &Perturbed(Exact),
            &mut Silent,
        );
        assert!(is_hull(points, &run.triangles, &hull));
        let plain = study(points, NathanOptions::PRINTED, &Exact, &mut Silent);
        assert!(!is_hull(points, &plain.triangles, &hull));
    }

    #[test]
    fn triangles_that_overlap_are_no_surface() {
        let cube = cube();
        let points = Points::new(&cube).expect("finite");
        let hull = hullkit::convex_hull_3d(&cube).expect("finite");
        let facet = hull.facets().next().expect("six");
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| facet[i]);
        let mut triangles: Vec<[u32; 3]> = hull.triangles().collect();
        triangles.retain(|corners| !corners.iter().all(|id| facet.contains(id)));
        assert!(is_hull(
            points,
            &[&triangles[..], &[[a, b, d], [b, c, d]]].concat(),
            &hull
        ));
        assert!(!is_hull(
            points,
            &[&triangles[..], &[[a, b, c], [b, c, d]]].concat(),
            &hull
        ));
    }
}
