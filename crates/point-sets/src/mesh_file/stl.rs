//! Binary STL: triangles in single precision, each with its normal and its own copy of its corners.

use super::PolygonMesh;
use std::io::{self, Write};

pub(super) fn write(out: &mut impl Write, mesh: &PolygonMesh) -> io::Result<()> {
    let invalid = |what| io::Error::new(io::ErrorKind::InvalidInput, what);
    let fits = |c: &f64| (*c as f32).is_finite();
    if !mesh.points.as_flattened().iter().all(fits) {
        return Err(invalid(
            "a coordinate is beyond single precision, which is all that STL has",
        ));
    }
    let count = u32::try_from(mesh.triangles().count())
        .map_err(|_| invalid("more triangles than STL can count"))?;
    let mut header = [b' '; 80];
    header[..TITLE.len()].copy_from_slice(TITLE);
    out.write_all(&header)?;
    out.write_all(&count.to_le_bytes())?;
    for triangle in mesh.triangles() {
        let corners = triangle.map(|id| mesh.points[id as usize]);
        for vector in [normal(corners), corners[0], corners[1], corners[2]] {
            for coordinate in vector {
                out.write_all(&(coordinate as f32).to_le_bytes())?;
            }
        }
        out.write_all(&[0; 2])?;
    }
    Ok(())
}

/// It must not begin with `solid`, which announces text.
const TITLE: &[u8] = b"binary STL";

/// The unit normal by the rule of the right hand, rounded; zero where it under- or overflows.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let to = |p: [f64; 3]| [0, 1, 2].map(|axis| p[axis] - a[axis]);
    let ([ux, uy, uz], [vx, vy, vz]) = (to(b), to(c));
    let normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length.is_normal() {
        normal.map(|c| c / length)
    } else {
        [0.0; 3]
    }
}
