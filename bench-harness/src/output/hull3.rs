//! A hull in space as a mesh, CSV, JSON or a summary.
//!
//! The JSON object, schema `hullbench/hull-3d/1`:
//!
//! | member | holds |
//! |---|---|
//! | `schema` | `"hullbench/hull-3d/1"` |
//! | `source` | where the points came from, in words |
//! | `points`, `distinct` | how many points there are, and how many without copies |
//! | `method` | the method's slug |
//! | `dimension` | of the hull: 0 to 3; null for no points |
//! | `volume`, `area` | rounded; null where they overflow |
//! | `centroid` | the centre of mass, rounded; null below dimension 3 |
//! | `certificate` | how the checker accounted for every point: `vertices`, `copies` of them, `on_boundary`, `inside`; and the `edges` and `facets` it found convex and whole |
//! | `vertices` | by index; of a planar hull in order round it: objects of `order`, `index`, `line`, `x`, `y`, `z` |
//! | `facets` | the maximal polygons, as lists of indices of points, anticlockwise seen from outside |

use crate::commands::input::Input;
use crate::output::hull::{dimension_line, points_line};
use crate::output::mesh;
use crate::output::rows::{VertexRow3, write_csv, write_json};
use crate::output::target::{Format, Report};
use crate::output::text::{self, SHOWN};
use hull_verify::check::Certificate3;
use hullkit::{Hull3, Method};
use point_sets::mesh_file::PolygonMesh;
use serde::Serialize;
use std::io::{self, Write};

/// A certified hull in space, ready to be written.
#[derive(Debug, Serialize)]
pub struct HullReport3 {
    schema: &'static str,
    source: String,
    points: usize,
    distinct: usize,
    method: &'static str,
    #[serde(skip)]
    title: &'static str,
    dimension: Option<usize>,
    volume: f64,
    area: f64,
    centroid: Option<[f64; 3]>,
    certificate: Account3,
    vertices: Vec<VertexRow3>,
    facets: Vec<Vec<u32>>,
    #[serde(skip)]
    mesh: PolygonMesh,
}

/// The checker's account of the points; vertices, copies, on_boundary and inside add up to their number.
#[derive(Clone, Debug, Serialize)]
pub struct Account3 {
    vertices: usize,
    edges: usize,
    facets: usize,
    copies: usize,
    on_boundary: usize,
    inside: usize,
}

impl HullReport3 {
    /// The report on `hull`, found by `method` and proved by `certificate`.
    pub fn new(
        input: &Input<3>,
        method: &Method,
        hull: &Hull3,
        certificate: &Certificate3,
    ) -> Self {
        Self {
            schema: "hullbench/hull-3d/1",
            source: input.source.clone(),
            points: input.points.len(),
            distinct: input.distinct(),
            method: method.slug,
            title: method.title,
            dimension: hull.dimension(),
            volume: hull.volume(input.view()),
            area: hull.area(input.view()),
            centroid: hull.centroid(input.view()),
            certificate: Account3::of(certificate),
            vertices: VertexRow3::all(input, hull.vertices()),
            facets: hull.facets().map(<[u32]>::to_vec).collect(),
            mesh: mesh::of_hull(&input.points, hull),
        }
    }

    /// Writes all of the summary but the table of vertices.
    ///
    /// # Errors
    ///
    /// Those of `out`.
    pub fn write_figures(&self, out: &mut dyn Write) -> io::Result<()> {
        text::line(out, "source", &self.source)?;
        text::line(out, "points", points_line(self.points, self.distinct))?;
        text::line(out, "method", format!("{}, {}", self.method, self.title))?;
        text::line(out, "dimension", dimension_line(self.dimension))?;
        text::line(out, "vertices", self.vertices.len())?;
        text::line(out, "edges", self.certificate.edges)?;
        text::line(out, "facets", self.facets.len())?;
        text::line(out, "volume", text::number(self.volume))?;
        text::line(out, "area", text::number(self.area))?;
        if let Some(centroid) = self.centroid {
            text::line(out, "centroid", text::point(&centroid))?;
        }
        text::line(out, "certificate", self.certificate.in_words())
    }

    fn write_first_vertices(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.vertices.is_empty() {
            return Ok(());
        }
        let mut table = text::table(&VertexRow3::HEADER);
        for row in self.vertices.iter().take(SHOWN) {
            table.add_row([
                row.order.to_string(),
                row.index.to_string(),
                row.line.map_or_else(|| "-".into(), |line| line.to_string()),
                text::number(row.x),
                text::number(row.y),
                text::number(row.z),
            ]);
        }
        writeln!(out)?;
        text::write_table(out, &table)?;
        match self.vertices.len().saturating_sub(SHOWN) {
            0 => Ok(()),
            more => writeln!(out, "... and {more} more; -o FILE writes them all"),
        }
    }
}

impl Report for HullReport3 {
    const FORMATS: &'static [Format] = mesh::FORMATS;

    fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()> {
        match format {
            Format::Csv => write_csv(out, &VertexRow3::HEADER, &self.vertices),
            Format::Json => write_json(out, self),
            _ => mesh::write(out, &self.mesh, format),
        }
    }

    fn write_summary(&self, out: &mut dyn Write) -> io::Result<()> {
        self.write_figures(out)?;
        self.write_first_vertices(out)
    }

    fn headline(&self) -> String {
        let vertices = text::count(self.vertices.len(), "vertex", "vertices");
        let facets = text::count(self.facets.len(), "facet", "facets");
        let points = text::count(self.points, "point", "points");
        format!("{vertices} and {facets} of {points}, certified")
    }

    fn warning(&self, format: Format) -> Option<String> {
        mesh::warning(&self.mesh, format)
    }
}

impl Account3 {
    /// The account of `certificate`.
    pub fn of(certificate: &Certificate3) -> Self {
        Self {
            vertices: certificate.h,
            edges: certificate.edges,
            facets: certificate.facets,
            copies: certificate.copies,
            on_boundary: certificate.on_boundary,
            inside: certificate.inside,
        }
    }

    /// The account on one line.
    pub fn in_words(&self) -> String {
        format!(
            "proved: {} vertices + {} copies of them + {} on the boundary + {} inside = {} points",
            self.vertices,
            self.copies,
            self.on_boundary,
            self.inside,
            self.vertices + self.copies + self.on_boundary + self.inside
        )
    }
}
