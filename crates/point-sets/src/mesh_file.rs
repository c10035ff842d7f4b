//! Polygon meshes in files: OFF, OBJ and PLY in and out, STL out.
//!
//! | format | coordinates | read | written |
//! |---|---|---|---|
//! | [`Off`](MeshFormat::Off) | the shortest decimals that read back as the same bits | yes, also what Qhull prints (`o`) | yes |
//! | [`Obj`](MeshFormat::Obj) | the same | yes | yes |
//! | [`PlyText`](MeshFormat::PlyText) | the same | yes | yes |
//! | [`Ply`](MeshFormat::Ply) | binary, little-endian, `double` | yes, also big-endian, and any scalar type | yes |
//! | [`Stl`](MeshFormat::Stl) | binary, rounded to single precision | no | yes |
//!
//! Read are points and polygons; colours, normals, textures, groups and lines are passed over. An error names the
//! file and the place in it: line and column of a text, the byte of a binary body.
//!
//! ```
//! use point_sets::mesh_file::{MeshFormat, PolygonMesh, read_mesh};
//! let mesh = PolygonMesh {
//!     points: vec![[0.1, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1e300, 0.0], [0.0, 0.0, -5e-324]],
//!     polygons: vec![vec![0, 2, 1], vec![0, 1, 3], vec![1, 2, 3], vec![2, 0, 3]],
//! };
//! let path = std::env::temp_dir().join(format!("point-sets-doc-{}.off", std::process::id()));
//! mesh.write(std::fs::File::create(&path)?, MeshFormat::Off)?;
//! assert_eq!(read_mesh(&path)?, mesh);
//! # std::fs::remove_file(&path)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod obj;
mod off;
mod ply;
mod stl;
mod words;

pub use error::{MeshFileError, MeshPlace, MeshProblem};

use error::Failure;
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::Path;

/// Points of space and polygons between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolygonMesh {
    /// The points.
    pub points: Vec<[f64; 3]>,
    /// The corners of each polygon in order, as indices of points from 0.
    pub polygons: Vec<Vec<u32>>,
}

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MeshFormat {
    /// Object File Format: counts, points, polygons.
    Off,
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY, binary.
    Ply,
    /// Stanford PLY, text.
    PlyText,
    /// Stereolithography, binary: triangles without points in common, in single precision.
    Stl,
}

impl MeshFormat {
    /// The format that the extension of `path` names; binary for `.ply`.
    pub fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "off" => Some(MeshFormat::Off),
            "obj" => Some(MeshFormat::Obj),
            "ply" => Some(MeshFormat::Ply),
            "stl" => Some(MeshFormat::Stl),
            _ => None,
        }
    }
}

impl PolygonMesh {
    /// Writes the mesh. `out` is buffered here and flushed.
    ///
    /// # Errors
    ///
    /// Those of `out`; [`io::ErrorKind::InvalidInput`] for STL if a coordinate is beyond single precision, or there
    /// are more than `u32::MAX` triangles.
    ///
    /// # Cost
    ///
    /// One pass.
    pub fn write(&self, out: impl Write, format: MeshFormat) -> io::Result<()> {
        let mut out = BufWriter::with_capacity(1 << 16, out);
        match format {
            MeshFormat::Off => off::write(&mut out, self)?,
            MeshFormat::Obj => obj::write(&mut out, self)?,
            MeshFormat::Ply => ply::write_binary(&mut out, self)?,
            MeshFormat::PlyText => ply::write_text(&mut out, self)?,
            MeshFormat::Stl => stl::write(&mut out, self)?,
        }
        out.flush()
    }

    /// How many points change when their coordinates are rounded to single precision, as STL has it.
    pub fn rounded_in_stl(&self) -> usize {
        let changes = |c: &f64| f64::from(*c as f32) != *c;
        let changed = self.points.iter().filter(|p| p.iter().any(changes));
        changed.count()
    }

    /// The corners of the triangles of each polygon, as a fan from its first corner.
    fn triangles(&self) -> impl Iterator<Item = [u32; 3]> {
        self.polygons.iter().flat_map(|polygon| {
            let sides = polygon.windows(2).skip(1);
            sides.map(|side| [polygon[0], side[0], side[1]])
        })
    }

    /// Adds a polygon whose corners are all points, at least three.
    fn push_polygon(&mut self, corners: Vec<u32>, place: MeshPlace) -> Result<(), Failure> {
        if corners.len() < 3 {
            let count = corners.len();
            return Err((place, MeshProblem::FewCorners { count }));
        }
        self.polygons.push(corners);
        Ok(())
    }
}

/// Reads a mesh from an OFF, OBJ or PLY file, by its extension.
///
/// All coordinates are finite, all corners name points, every polygon has at least three.
///
/// # Errors
///
/// [`MeshFileError`] names the file, the place and the remedy.
///
/// # Cost
///
/// The file is held in memory, and one pass.
pub fn read_mesh(path: &Path) -> Result<PolygonMesh, MeshFileError> {
    let error = |place, problem| MeshFileError {
        path: path.to_owned(),
        place,
        problem,
    };
    let read = match MeshFormat::of(path) {
        Some(MeshFormat::Off) => off::read,
        Some(MeshFormat::Obj) => obj::read,
        Some(MeshFormat::Ply | MeshFormat::PlyText) => ply::read,
        Some(MeshFormat::Stl) | None => return Err(error(None, MeshProblem::NoFormat)),
    };
    let content = fs::read(path).map_err(|cause| error(None, MeshProblem::Open(cause)))?;
    read(&content).map_err(|(place, problem)| error(Some(place), problem))
}
