//! A plain right method for hulls in space: insert the points one by one, every triangle asked about every point.

use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::{SideId, TriMesh};
use geometry_core::{Hull3, HullError, Kernel3, Observer, Perturbed, Points};

/// The hull of `points`, by O(n f) orientations.
pub(crate) fn right_hull<K: Kernel3, O: Observer>(
    points: Points<'_, 3>,
    kernel: &K,
    _: &mut O,
) -> Result<Hull3, HullError> {
    let simplex = match AffineBasis::of(points, kernel).flat_hull(points, kernel) {
        Ok(flat) => return Ok(flat),
        Err(simplex) => simplex,
    };
    let moved = Perturbed(kernel);
    let mut mesh = TriMesh::tetrahedron(simplex);
    let mut made = Vec::new();
    for p in points.ids() {
        let sees = |mesh: &TriMesh, side: SideId| {
            let [a, b, c] = mesh.corners(side.triangle()).map(|id| points[id]);
            moved.orient3(a, b, c, points[p]).is_positive()
        };
        let visible: Vec<_> = mesh
            .triangles()
            .filter(|triangle| sees(&mesh, triangle.side(0)))
            .collect();
        let rim = visible
            .iter()
            .flat_map(|triangle| triangle.sides())
            .map(|side| mesh.twin(side))
            .filter(|&beyond| !visible.contains(&beyond.triangle()));
        let horizon = in_order(&mesh, rim.collect())?;
        if horizon.is_empty() {
            continue;
        }
        for triangle in visible {
            mesh.remove(triangle);
        }
        mesh.close(&horizon, p, &mut made);
    }
    Ok(Hull3::from_mesh(points, &mesh, kernel))
}

/// The sides of the rim in the order that [`TriMesh::close`] wants.
fn in_order(mesh: &TriMesh, rim: Vec<SideId>) -> Result<Vec<SideId>, HullError> {
    let mut horizon: Vec<SideId> = rim.first().copied().into_iter().collect();
    while horizon.len() < rim.len() {
        let end = mesh.origin(horizon[horizon.len() - 1]);
        let mut ahead = rim.iter().filter(|&&side| mesh.target(side) == end);
        match (ahead.next(), ahead.next()) {
            (Some(&side), None) if side != horizon[0] => horizon.push(side),
            _ => {
                let what = "the horizon is not one cycle";
                return Err(HullError::Contradiction { what });
            }
        }
    }
    Ok(horizon)
}
