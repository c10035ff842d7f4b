//! A hull as CSV, JSON or a summary.
//!
//! The JSON object, schema `hullbench/hull/1`:
//!
//! | member | holds |
//! |---|---|
//! | `schema` | `"hullbench/hull/1"` |
//! | `source` | where the points came from, in words |
//! | `points`, `distinct` | how many points there are, and how many without copies |
//! | `method`, `boundary` | the method's slug; `"extreme"` or `"all"` |
//! | `dimension` | of the hull: 0, 1 or 2; null for no points |
//! | `area`, `perimeter` | rounded; null where they overflow |
//! | `certificate` | how the checker accounted for every point: `vertices`, `copies` of them, `on_edges`, `inside` |
//! | `vertices` | anticlockwise from the lexicographically smallest: objects of `order`, `index`, `line`, `x`, `y` |

use crate::commands::input::Input;
use crate::output::rows::{VertexRow, write_csv, write_json};
use crate::output::target::{Format, Report};
use crate::output::text::{self, SHOWN};
use hull_verify::check::Certificate2;
use hullkit::{Boundary, Hull2, Method};
use serde::Serialize;
use std::io::{self, Write};

/// A certified hull, ready to be written.
#[derive(Debug, Serialize)]
pub struct HullReport {
    schema: &'static str,
    source: String,
    points: usize,
    distinct: usize,
    method: &'static str,
    #[serde(skip)]
    title: &'static str,
    boundary: &'static str,
    dimension: Option<usize>,
    area: f64,
    perimeter: f64,
    certificate: Account,
    vertices: Vec<VertexRow>,
}

/// The checker's account of the points; it adds up to their number.
#[derive(Clone, Debug, Serialize)]
pub struct Account {
    vertices: usize,
    copies: usize,
    on_edges: usize,
    inside: usize,
}

impl HullReport {
    /// The report on `hull`, found by `method` and proved by `certificate`.
    pub fn new(
        input: &Input,
        method: &Method,
        boundary: Boundary,
        hull: &Hull2,
        certificate: &Certificate2,
    ) -> Self {
        Self {
            schema: "hullbench/hull/1",
            source: input.source.clone(),
            points: input.points.len(),
            distinct: input.distinct(),
            method: method.slug,
            title: method.title,
            boundary: boundary_name(boundary),
            dimension: hull.dimension(),
            area: hull.area(input.view()),
            perimeter: hull.perimeter(input.view()),
            certificate: Account::of(certificate),
            vertices: VertexRow::all(input, hull.vertices()),
        }
    }
}

impl Report for HullReport {
    const FORMATS: &'static [Format] = &[Format::Csv, Format::Json];

    fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()> {
        match format {
            Format::Csv => write_csv(out, &VertexRow::HEADER, &self.vertices),
            Format::Json => write_json(out, self),
            other => other.refuse(),
        }
    }

    fn write_summary(&self, out: &mut dyn Write) -> io::Result<()> {
        text::line(out, "source", &self.source)?;
        text::line(out, "points", points_line(self.points, self.distinct))?;
        text::line(out, "method", format!("{}, {}", self.method, self.title))?;
        text::line(out, "boundary", self.boundary)?;
        text::line(out, "dimension", dimension_line(self.dimension))?;
        text::line(out, "vertices", self.vertices.len())?;
        text::line(out, "area", text::number(self.area))?;
        text::line(out, "perimeter", text::number(self.perimeter))?;
        text::line(out, "certificate", self.certificate.in_words())?;
        self.write_first_vertices(out)
    }

    fn headline(&self) -> String {
        let vertices = text::count(self.vertices.len(), "vertex", "vertices");
        let points = text::count(self.points, "point", "points");
        format!("{vertices} of {points}, certified")
    }
}

impl HullReport {
    fn write_first_vertices(&self, out: &mut dyn Write) -> io::Result<()> {
        if self.vertices.is_empty() {
            return Ok(());
        }
        let mut table = text::table(&VertexRow::HEADER);
        for row in self.vertices.iter().take(SHOWN) {
            table.add_row([
                row.order.to_string(),
                row.index.to_string(),
                row.line.map_or_else(|| "-".into(), |line| line.to_string()),
                text::number(row.x),
                text::number(row.y),
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

impl Account {
    /// The account of `certificate`.
    pub fn of(certificate: &Certificate2) -> Self {
        Self {
            vertices: certificate.h,
            copies: certificate.copies,
            on_edges: certificate.on_edges,
            inside: certificate.inside,
        }
    }

    /// The account on one line.
    pub fn in_words(&self) -> String {
        format!(
            "proved: {} vertices + {} copies of them + {} on edges + {} inside = {} points",
            self.vertices,
            self.copies,
            self.on_edges,
            self.inside,
            self.vertices + self.copies + self.on_edges + self.inside
        )
    }
}

/// The name of `boundary` on the command line and in files.
pub fn boundary_name(boundary: Boundary) -> &'static str {
    match boundary {
        Boundary::Extreme => "extreme",
        Boundary::All => "all",
    }
}

/// How many points there are, and how many without copies if that differs.
pub fn points_line(points: usize, distinct: usize) -> String {
    if distinct == points {
        points.to_string()
    } else {
        format!("{points}, of which {distinct} distinct")
    }
}

/// The dimension of a hull, in words where it is low.
pub fn dimension_line(dimension: Option<usize>) -> String {
    match dimension {
        None => "none: there are no points".into(),
        Some(0) => "0: all points are copies of one".into(),
        Some(1) => "1: all points are on one line".into(),
        Some(dimension) => dimension.to_string(),
    }
}
