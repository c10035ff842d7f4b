//! From triangles that know nothing of each other to a surface.

use geometry_core::HullError;
use geometry_core::mesh::{SideId, TriMesh};
use std::collections::HashMap;

/// The closed surface of these triangles, each anticlockwise seen from outside.
///
/// # Errors
///
/// [`HullError::Contradiction`] if two triangles have the same side, or a side has no neighbour.
///
/// # Cost
///
/// O(triangles).
pub(crate) fn surface(triangles: &[[u32; 3]]) -> Result<TriMesh, HullError> {
    let mut mesh = TriMesh::new();
    // The sides that wait for their neighbour, by origin and target.
    let mut open: HashMap<[u32; 2], SideId> = HashMap::with_capacity(triangles.len());
    for &corners in triangles {
        for side in mesh.add(corners).sides() {
            let (from, to) = (mesh.origin(side), mesh.target(side));
            if let Some(twin) = open.remove(&[to, from]) {
                mesh.link(side, twin);
            } else if open.insert([from, to], side).is_some() {
                return Err(HullError::Contradiction {
                    what: "two triangles of the surface have the same side",
                });
            }
        }
    }
    if !open.is_empty() {
        return Err(HullError::Contradiction {
            what: "the surface is not closed",
        });
    }
    Ok(mesh)
}
