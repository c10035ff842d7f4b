//! What both incremental methods of space do to a surface: begin it, and find the rim of what a point sees.

use geometry_core::dimension::AffineBasis;
use geometry_core::mesh::{SideId, TriMesh, TriangleId};
use geometry_core::{Hull3, HullError, Kernel3, Points, Sign};

/// How an insertion begins.
pub(crate) enum Start {
    /// The points do not span space: this is their hull.
    Flat(Hull3),
    /// The first four points that do, and the others in order.
    Tetrahedron {
        /// Positively oriented.
        corners: [u32; 4],
        rest: Vec<u32>,
    },
}

/// Begins with the first two points of `order`, which are distinct, the first point not collinear with them, and the
/// first not coplanar with these three.
///
/// In general position that is one shadow and one orientation.
pub(crate) fn start<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    mut order: Vec<u32>,
) -> Result<Start, HullError> {
    let Some(corners) = first_independent(points, kernel, &order) else {
        let flat = AffineBasis::of(points, kernel).flat_hull(points, kernel);
        return flat.map(Start::Flat).map_err(|_| HullError::Contradiction {
            what: "points that span space were found to lie in one plane",
        });
    };
    order.retain(|id| !corners.contains(id));
    Ok(Start::Tetrahedron {
        corners,
        rest: order,
    })
}

fn first_independent<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    order: &[u32],
) -> Option<[u32; 4]> {
    let [a, b, rest @ ..] = order else {
        return None;
    };
    let [p, q] = [points[*a], points[*b]];
    let off_line = |&c: &u32| !kernel.collinear3(p, q, points[c]);
    let place = rest.iter().position(off_line)?;
    // The points before it are on the line.
    let (c, rest) = rest[place..].split_first()?;
    let side = |d: u32| kernel.orient3(p, q, points[*c], points[d]);
    rest.iter().find_map(|&d| match side(d) {
        Sign::Zero => None,
        Sign::Positive => Some([*a, *b, *c, d]),
        Sign::Negative => Some([*a, *c, *b, d]),
    })
}

/// Whether the point `id` sees the triangle.
pub(crate) fn sees<K: Kernel3>(
    points: Points<'_, 3>,
    kernel: &K,
    mesh: &TriMesh,
    triangle: TriangleId,
    id: u32,
) -> bool {
    let [a, b, c] = mesh.corners(triangle).map(|id| points[id]);
    kernel.orient3(a, b, c, points[id]).is_positive()
}

/// Finds the rim of the `visible` triangles, those for which `is_visible` holds: the sides beyond it that border them,
/// in order for [`TriMesh::close`].
///
/// From one side on the rim, the next begins at its end: turn about that corner through the visible triangles until a
/// side has none behind it.
///
/// ```text
///        \   beyond   /
///         \          /              side --> corner --> the first of the sides leaving
///     -----*------->*-----          the corner, clockwise from the one after `side`, that
///         / \ side / \              borders a triangle that is not visible
///        /   \    /   \
///           visible
/// ```
///
/// # Errors
///
/// [`HullError::Contradiction`] if there is no rim, or more than one.
pub(crate) fn rim(
    mesh: &TriMesh,
    visible: &[TriangleId],
    is_visible: impl Fn(TriangleId) -> bool,
    rim: &mut Vec<SideId>,
) -> Result<(), HullError> {
    rim.clear();
    let borders = |side: SideId| !is_visible(mesh.twin(side).triangle());
    let mut on_rim = visible
        .iter()
        .flat_map(|triangle| triangle.sides())
        .filter(|&side| borders(side));
    let first = on_rim.next();
    let count = usize::from(first.is_some()) + on_rim.count();
    let mut at = first;
    while let Some(side) = at {
        rim.push(mesh.twin(side));
        let mut next = side.next();
        while !borders(next) {
            next = mesh.twin(next).next();
        }
        at = Some(next).filter(|_| Some(next) != first);
    }
    if rim.len() == count && count >= 3 {
        Ok(())
    } else {
        Err(HullError::Contradiction {
            what: "the facets that a point sees are not one region with one rim",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rim_of(visible: &[u32]) -> Result<Vec<u32>, HullError> {
        let mesh = TriMesh::tetrahedron([0, 1, 2, 3]);
        let visible: Vec<TriangleId> = visible.iter().copied().map(TriangleId).collect();
        let mut sides = Vec::new();
        rim(
            &mesh,
            &visible,
            |triangle| visible.contains(&triangle),
            &mut sides,
        )?;
        // In order round it.
        for (i, &side) in sides.iter().enumerate() {
            assert_eq!(mesh.origin(side), mesh.target(sides[(i + 1) % sides.len()]));
        }
        Ok(sides.iter().map(|&side| mesh.target(side)).collect())
    }

    #[test]
    fn the_rim_goes_round_what_is_visible() -> Result<(), HullError> {
        assert_eq!(rim_of(&[0])?, [0, 2, 1]);
        assert_eq!(rim_of(&[1, 2])?.len(), 4);
        assert_eq!(rim_of(&[1, 2, 3])?, [0, 1, 2]);
        assert!(rim_of(&[0, 1, 2, 3]).is_err());
        assert!(rim_of(&[]).is_err());
        Ok(())
    }
}
