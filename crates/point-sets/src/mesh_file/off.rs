//! The Object File Format.
//!
//! ```text
//! OFF                         a letter or two before OFF announce colours and the like after the coordinates;
//! 4 4 6                       Qhull prints the dimension, 3, in its place
//! 0 0 0                       points, polygons and edges (not used) are counted, also on the first line
//! 1 0 0
//! 0 1 0
//! 0 0 1
//! 3 0 2 1                     a polygon: how many corners, which, and perhaps a colour
//! ...
//! ```

use super::PolygonMesh;
use super::error::{Failure, MeshProblem};
use super::words::{Line, Lines};
use std::io::{self, Write};

pub(super) fn write(out: &mut impl Write, mesh: &PolygonMesh) -> io::Result<()> {
    writeln!(out, "OFF")?;
    writeln!(out, "{} {} 0", mesh.points.len(), mesh.polygons.len())?;
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

pub(super) fn read(content: &[u8]) -> Result<PolygonMesh, Failure> {
    let mut lines = Lines::new(content, Some('#'))?;
    let mut counts = after_keyword(&mut lines)?;
    let points: usize = counts.number("the number of points")?;
    let polygons: usize = counts.number("the number of polygons")?;
    let mut mesh = PolygonMesh::default();
    for _ in 0..points {
        mesh.points.push(lines.expect("a point")?.point()?);
    }
    for _ in 0..polygons {
        let mut line = lines.expect("a polygon")?;
        let place = line.start();
        let corners: usize = line.number("the number of corners")?;
        let corners = (0..corners).map(|_| line.corner(points));
        let corners = corners.collect::<Result<_, _>>()?;
        mesh.push_polygon(corners, place)?;
    }
    Ok(mesh)
}

/// The words after the keyword: of its own line if it holds more, else of the next.
fn after_keyword<'a>(lines: &mut Lines<'a>) -> Result<Line<'a>, Failure> {
    let mut first = lines.expect("OFF")?;
    let keyword = first.expect("OFF")?;
    let known = ["OFF", "COFF", "NOFF", "CNOFF", "STOFF", "3"];
    if !known.contains(&keyword.text) {
        return Err(keyword.is_not("OFF"));
    }
    let mut ahead = first;
    match ahead.next() {
        None => lines.expect("the number of points"),
        Some(word) if word.text == "BINARY" => Err((
            word.place(),
            MeshProblem::Unsupported {
                what: "binary OFF".to_owned(),
                remedy: "save it as text",
            },
        )),
        Some(_) => Ok(first),
    }
}
