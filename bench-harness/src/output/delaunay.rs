//! A Delaunay triangulation as CSV, JSON, a mesh, a drawing or a summary.
//!
//! The JSON object, schema `hullbench/delaunay/1`:
//!
//! | member | holds |
//! |---|---|
//! | `schema` | `"hullbench/delaunay/1"` |
//! | `source` | where the points came from, in words |
//! | `points`, `distinct` | how many points there are, and how many without copies |
//! | `method` | the method's slug |
//! | `edges` | how many edges there are |
//! | `cocircular` | how many of them cut a polygon of points on one empty circle: a choice |
//! | `hull_edges` | the edges on the convex hull, anticlockwise, as pairs of indices of points |
//! | `triangles` | anticlockwise, as triples of indices of points |

use crate::commands::input::Input;
use crate::output::drawing;
use crate::output::hull::points_line;
use crate::output::mesh;
use crate::output::rows::{write_csv, write_json};
use crate::output::target::{Format, Report};
use crate::output::text;
use geometry_core::Triangulation;
use hull_verify::check::DelaunayCertificate;
use hullkit::Method;
use point_sets::mesh_file::PolygonMesh;
use serde::Serialize;
use std::io::{self, Write};

/// A certified triangulation, ready to be written.
#[derive(Debug, Serialize)]
pub struct DelaunayReport {
    schema: &'static str,
    source: String,
    points: usize,
    distinct: usize,
    method: &'static str,
    #[serde(skip)]
    title: &'static str,
    edges: usize,
    cocircular: usize,
    hull_edges: Vec<[u32; 2]>,
    triangles: Vec<[u32; 3]>,
    #[serde(skip)]
    input: Input,
    #[serde(skip)]
    triangulation: Triangulation,
}

/// A triangle of a table.
#[derive(Clone, Copy, Debug, Serialize)]
struct TriangleRow {
    triangle: usize,
    a: u32,
    b: u32,
    c: u32,
}

impl DelaunayReport {
    /// The report on `triangulation`, found by `method` and proved by `certificate`.
    pub fn new(
        input: Input,
        method: &Method,
        triangulation: Triangulation,
        certificate: &DelaunayCertificate,
    ) -> Self {
        Self {
            schema: "hullbench/delaunay/1",
            source: input.source.clone(),
            points: certificate.n,
            distinct: certificate.vertices,
            method: method.slug,
            title: method.title,
            edges: triangulation.edges().len(),
            cocircular: certificate.cocircular,
            hull_edges: triangulation.hull_edges(),
            triangles: triangulation.triangles().to_vec(),
            input,
            triangulation,
        }
    }

    fn rows(&self) -> Vec<TriangleRow> {
        let row = |(triangle, &[a, b, c]): (usize, &[u32; 3])| TriangleRow { triangle, a, b, c };
        self.triangles.iter().enumerate().map(row).collect()
    }

    /// All points in the plane z = 0, and the triangles.
    fn mesh(&self) -> PolygonMesh {
        PolygonMesh {
            points: self
                .input
                .points
                .iter()
                .map(|&[x, y]| [x, y, 0.0])
                .collect(),
            polygons: self
                .triangles
                .iter()
                .map(|corners| corners.to_vec())
                .collect(),
        }
    }
}

impl Report for DelaunayReport {
    const FORMATS: &'static [Format] = &[
        Format::Csv,
        Format::Json,
        Format::Off,
        Format::Obj,
        Format::Ply,
        Format::PlyText,
        Format::Svg,
    ];

    fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()> {
        match format {
            Format::Csv => write_csv(out, &["triangle", "a", "b", "c"], &self.rows()),
            Format::Json => write_json(out, self),
            Format::Svg => drawing::write(out, &self.input.points, &self.triangulation),
            _ => mesh::write(out, &self.mesh(), format),
        }
    }

    fn write_summary(&self, out: &mut dyn Write) -> io::Result<()> {
        text::line(out, "source", &self.source)?;
        text::line(out, "points", points_line(self.points, self.distinct))?;
        text::line(out, "method", format!("{}, {}", self.method, self.title))?;
        text::line(out, "triangles", self.triangles.len())?;
        text::line(out, "edges", self.edges)?;
        text::line(out, "hull edges", self.hull_edges.len())?;
        text::line(out, "cocircular", cocircular_line(self.cocircular))?;
        text::line(
            out,
            "certificate",
            format!(
                "proved: {} triangles, none with a point inside its circle, of {} points + {} copies of them",
                self.triangles.len(),
                self.distinct,
                self.points - self.distinct
            ),
        )
    }

    fn headline(&self) -> String {
        let triangles = text::count(self.triangles.len(), "triangle", "triangles");
        let points = text::count(self.points, "point", "points");
        format!("{triangles} of {points}, certified")
    }
}

fn cocircular_line(edges: usize) -> String {
    match edges {
        0 => "no edge: there is no other Delaunay triangulation".into(),
        _ => format!(
            "{}: four points on one circle, cut by a rule",
            text::count(edges, "edge", "edges")
        ),
    }
}
