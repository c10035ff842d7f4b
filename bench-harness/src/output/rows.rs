//! Vertices and points as rows of CSV and JSON.
//!
//! A coordinate is written with the fewest digits that read back as the same `f64`.

use crate::commands::input::Input;
use serde::Serialize;
use std::io::{self, Write};

/// A vertex of a hull.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VertexRow {
    /// Its place on the boundary, from 0, anticlockwise.
    pub order: usize,
    /// The index of the point in the input, from 0.
    pub index: u32,
    /// The line of the input file that holds the point; none for a generated point.
    pub line: Option<u64>,
    /// Its first coordinate.
    pub x: f64,
    /// Its second coordinate.
    pub y: f64,
}

impl VertexRow {
    /// The header of a table of vertices.
    pub const HEADER: [&'static str; 5] = ["order", "index", "line", "x", "y"];

    /// The rows of the vertices `ids` of `input`.
    pub fn all(input: &Input, ids: &[u32]) -> Vec<Self> {
        let row = |(order, &index): (usize, &u32)| {
            let [x, y] = input.points[index as usize];
            Self {
                order,
                index,
                line: input.line(index),
                x,
                y,
            }
        };
        ids.iter().enumerate().map(row).collect()
    }
}

/// A vertex of a hull in space.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VertexRow3 {
    /// Its place among the vertices, from 0, in the order of their indices.
    pub order: usize,
    /// The index of the point in the input, from 0.
    pub index: u32,
    /// The line of the input file that holds the point; none for a generated point.
    pub line: Option<u64>,
    /// Its first coordinate.
    pub x: f64,
    /// Its second coordinate.
    pub y: f64,
    /// Its third coordinate.
    pub z: f64,
}

impl VertexRow3 {
    /// The header of a table of vertices.
    pub const HEADER: [&'static str; 6] = ["order", "index", "line", "x", "y", "z"];

    /// The rows of the vertices `ids` of `input`.
    pub fn all(input: &Input<3>, ids: &[u32]) -> Vec<Self> {
        let row = |(order, &index): (usize, &u32)| {
            let [x, y, z] = input.points[index as usize];
            Self {
                order,
                index,
                line: input.line(index),
                x,
                y,
                z,
            }
        };
        ids.iter().enumerate().map(row).collect()
    }
}

/// A point and its place in the layers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LayerRow {
    /// The index of the point in the input, from 0.
    pub index: u32,
    /// The line of the input file that holds the point; none for a generated point.
    pub line: Option<u64>,
    /// Its first coordinate.
    pub x: f64,
    /// Its second coordinate.
    pub y: f64,
    /// The number of the ring it is peeled with, from 1, outermost first.
    pub layer: u32,
    /// The c-rank: by definition the same number.
    pub c_rank: u32,
    /// The rank from the outside in, points of one layer sharing the mean of their places.
    pub mid_rank: f64,
}

impl LayerRow {
    /// The header of a table of points with their layers.
    pub const HEADER: [&'static str; 7] =
        ["index", "line", "x", "y", "layer", "c_rank", "mid_rank"];

    /// The rows of all points of `input`, in the order of the input.
    pub fn all(input: &Input, layers: &hullkit::Layers) -> Vec<Self> {
        let ranks = layers.c_ranks().iter().zip(layers.mid_ranks());
        let row = |(index, (&c_rank, mid_rank)): (u32, (&u32, f64))| {
            let [x, y] = input.points[index as usize];
            Self {
                index,
                line: input.line(index),
                x,
                y,
                layer: c_rank,
                c_rank,
                mid_rank,
            }
        };
        (0..).zip(ranks).map(row).collect()
    }
}

/// Writes `rows` as CSV under `header`, which is written also above no rows.
///
/// # Errors
///
/// Those of `out`.
pub fn write_csv<T: Serialize>(out: &mut dyn Write, header: &[&str], rows: &[T]) -> io::Result<()> {
    let mut csv = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(out);
    csv.write_record(header)?;
    for row in rows {
        csv.serialize(row)?;
    }
    csv.flush()
}

/// Writes `value` as indented JSON with a newline at the end.
///
/// # Errors
///
/// Those of `out`.
pub fn write_json<T: Serialize>(out: &mut dyn Write, value: &T) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, value)?;
    out.write_all(b"\n")
}
