//! Wavefront OBJ.
//!
//! ```text
//! v 0 0 0                     a point; a fourth number, and colours, are passed over
//! f 1 3 2                     a polygon; points are numbered from 1, and backwards from -1
//! f 1/1/1 2//3 -1             with texture and normal, which are passed over
//! ```
//!
//! Lines of other keywords (`vn`, `vt`, `g`, `o`, `s`, `usemtl`, ...) are passed over.

use super::PolygonMesh;
use super::error::Failure;
use super::words::{Lines, Word};
use std::io::{self, Write};

pub(super) fn write(out: &mut impl Write, mesh: &PolygonMesh) -> io::Result<()> {
    for [x, y, z] in &mesh.points {
        writeln!(out, "v {x:?} {y:?} {z:?}")?;
    }
    for polygon in &mesh.polygons {
        write!(out, "f")?;
        for corner in polygon {
            write!(out, " {}", u64::from(*corner) + 1)?;
        }
        writeln!(out)?;
    }
    Ok(())
}

pub(super) fn read(content: &[u8]) -> Result<PolygonMesh, Failure> {
    let mut mesh = PolygonMesh::default();
    for mut line in Lines::new(content, Some('#'))? {
        let keyword = line.expect("a keyword")?;
        match keyword.text {
            "v" => mesh.points.push(line.point()?),
            "f" => {
                let count = mesh.points.len();
                let corners = line.map(|word| corner(word, count));
                let corners = corners.collect::<Result<_, _>>()?;
                mesh.push_polygon(corners, keyword.place())?;
            }
            _ => {}
        }
    }
    Ok(mesh)
}

/// The index, from 0, of the point that `word` names among the `count` before it.
fn corner(word: Word<'_>, count: usize) -> Result<u32, Failure> {
    let point = word.text.split('/').next().unwrap_or_default();
    let number: i64 = point.parse().map_err(|_| word.is_not("a corner"))?;
    let index = match number {
        1.. => number - 1,
        _ => count as i64 + number,
    };
    let is_point = number != 0 && (0..count as i64).contains(&index);
    match u32::try_from(index) {
        Ok(index) if is_point => Ok(index),
        _ => Err(word.is_no_point(count)),
    }
}
