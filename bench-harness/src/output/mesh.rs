//! Hulls and triangulations as polygon meshes.

use crate::output::target::Format;
use crate::output::text;
use hullkit::Hull3;
use point_sets::mesh_file::{MeshFormat, PolygonMesh};
use std::io::{self, Write};

/// The formats of a result that is a mesh and a table of vertices.
pub const FORMATS: &[Format] = &[
    Format::Csv,
    Format::Json,
    Format::Off,
    Format::Obj,
    Format::Ply,
    Format::PlyText,
    Format::Stl,
];

/// The vertices of `hull` and its facets between them; of a planar hull its polygon.
pub fn of_hull(points: &[[f64; 3]], hull: &Hull3) -> PolygonMesh {
    let ids = hull.vertices();
    let place = |id: &u32| {
        let found = ids.binary_search(id);
        found.expect("the vertices of a solid are the corners of its facets, ascending") as u32
    };
    let polygons = match hull {
        Hull3::Planar(ids) => vec![(0..ids.len() as u32).collect()],
        _ => hull
            .facets()
            .map(|facet| facet.iter().map(place).collect())
            .collect(),
    };
    PolygonMesh {
        points: ids.iter().map(|&id| points[id as usize]).collect(),
        polygons,
    }
}

/// Writes `mesh` in a format of meshes.
///
/// # Errors
///
/// Those of `out`; [`io::ErrorKind::InvalidInput`] for another format.
pub fn write(out: &mut dyn Write, mesh: &PolygonMesh, format: Format) -> io::Result<()> {
    let format = match format {
        Format::Off => MeshFormat::Off,
        Format::Obj => MeshFormat::Obj,
        Format::Ply => MeshFormat::Ply,
        Format::PlyText => MeshFormat::PlyText,
        Format::Stl => MeshFormat::Stl,
        other => return other.refuse(),
    };
    mesh.write(out, format)
}

/// What `mesh` loses in `format`, if anything.
pub fn warning(mesh: &PolygonMesh, format: Format) -> Option<String> {
    if format != Format::Stl {
        return None;
    }
    let rounded = text::count(mesh.rounded_in_stl(), "vertex is", "vertices are");
    Some(format!(
        "STL holds coordinates in single precision: {rounded} moved by rounding; OFF, OBJ and PLY keep them"
    ))
}
