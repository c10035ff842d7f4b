//! Stanford PLY, as text and binary.
//!
//! ```text
//! ply
//! format binary_little_endian 1.0         or ascii, or binary_big_endian
//! element vertex 4
//! property double x                       any scalar type is read, in any order, among other properties
//! property double y
//! property double z
//! element face 4
//! property list uchar int vertex_indices  or vertex_index
//! end_header
//! ...                                     the elements, one after another
//! ```

mod body;
mod header;

use super::PolygonMesh;
use super::error::{Failure, MeshProblem};
use body::Body;
use header::{Element, Header, Scalar};
use std::io::{self, Write};

pub(super) fn write_text(out: &mut impl Write, mesh: &PolygonMesh) -> io::Result<()> {
    write_header(out, mesh, "ascii")?;
    for [x, y, z] in &mesh.points {
        writeln!(out, "{x:?} {y:?} {z:?}")?;
    }
    for polygon in &mesh.polygons {
        write!(out, "{}", polygon.len())?;
        for corner in polygon {
            write!(out, " {corner}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}

pub(super) fn write_binary(out: &mut impl Write, mesh: &PolygonMesh) -> io::Result<()> {
    write_header(out, mesh, "binary_little_endian")?;
    for coordinate in mesh.points.as_flattened() {
        out.write_all(&coordinate.to_le_bytes())?;
    }
    let wide = count_type(mesh) == "uint";
    for polygon in &mesh.polygons {
        let count = (polygon.len() as u32).to_le_bytes();
        out.write_all(if wide { &count } else { &count[..1] })?;
        for corner in polygon {
            out.write_all(&corner.to_le_bytes())?;
        }
    }
    Ok(())
}

fn write_header(out: &mut impl Write, mesh: &PolygonMesh, format: &str) -> io::Result<()> {
    writeln!(out, "ply\nformat {format} 1.0")?;
    writeln!(out, "element vertex {}", mesh.points.len())?;
    for name in ["x", "y", "z"] {
        writeln!(out, "property double {name}")?;
    }
    writeln!(out, "element face {}", mesh.polygons.len())?;
    writeln!(
        out,
        "property list {} uint vertex_indices",
        count_type(mesh)
    )?;
    writeln!(out, "end_header")
}

/// The type of the number of corners: that of all other writers, if no polygon has too many.
fn count_type(mesh: &PolygonMesh) -> &'static str {
    let small = mesh.polygons.iter().all(|polygon| polygon.len() <= 255);
    if small { "uchar" } else { "uint" }
}

pub(super) fn read(content: &[u8]) -> Result<PolygonMesh, Failure> {
    let (header, mut body) = Header::read(content)?;
    let mut mesh = PolygonMesh::default();
    for element in &header.elements {
        match element.name {
            "vertex" => read_points(&mut mesh, element, &mut body)?,
            "face" => read_polygons(&mut mesh, element, &header, &mut body)?,
            _ => skip(element, &mut body)?,
        }
    }
    Ok(mesh)
}

fn read_points(
    mesh: &mut PolygonMesh,
    element: &Element<'_>,
    body: &mut Body<'_>,
) -> Result<(), Failure> {
    let axes = element.positions(["x", "y", "z"])?;
    for _ in 0..element.count {
        body.begin("a point")?;
        let mut point = [0.0; 3];
        for (position, property) in element.properties.iter().enumerate() {
            let axis = axes.iter().position(|&axis| axis == position);
            match (axis, property.count_type) {
                (Some(axis), None) => point[axis] = body.coordinate(property.value_type)?,
                _ => property.skip(body)?,
            }
        }
        mesh.points.push(point);
    }
    Ok(())
}

fn read_polygons(
    mesh: &mut PolygonMesh,
    element: &Element<'_>,
    header: &Header<'_>,
    body: &mut Body<'_>,
) -> Result<(), Failure> {
    let points = header.count_of("vertex");
    let is_corners = |name: &str| name == "vertex_indices" || name == "vertex_index";
    for _ in 0..element.count {
        body.begin("a polygon")?;
        for property in &element.properties {
            match property.count_type {
                Some(count_type) if is_corners(property.name) => {
                    let place = body.mark().place();
                    let count = body.index(count_type, "the number of corners")?;
                    let corners = (0..count).map(|_| corner(property.value_type, points, body));
                    let corners = corners.collect::<Result<_, _>>()?;
                    mesh.push_polygon(corners, place)?;
                }
                _ => property.skip(body)?,
            }
        }
    }
    Ok(())
}

fn corner(value_type: Scalar, points: usize, body: &mut Body<'_>) -> Result<u32, Failure> {
    let mark = body.mark();
    let value = body.scalar(value_type, "a corner")?;
    if value >= 0.0 && value < points as f64 && value.fract() == 0.0 {
        return Ok(value as u32);
    }
    let found = value.to_string();
    Err((
        mark.place(),
        MeshProblem::NoSuchPoint {
            found,
            count: points,
        },
    ))
}

fn skip(element: &Element<'_>, body: &mut Body<'_>) -> Result<(), Failure> {
    for _ in 0..element.count {
        body.begin("an element")?;
        for property in &element.properties {
            property.skip(body)?;
        }
    }
    Ok(())
}
