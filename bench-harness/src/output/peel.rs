//! Convex layers as CSV, JSON or a summary.
//!
//! The JSON object, schema `hullbench/peel/1`:
//!
//! | member | holds |
//! |---|---|
//! | `schema` | `"hullbench/peel/1"` |
//! | `source` | where the points came from, in words |
//! | `points`, `distinct` | how many points there are, and how many without copies |
//! | `method`, `boundary` | the method's slug; `"extreme"` or `"all"` |
//! | `rings` | the number of vertices of each layer, outermost first |
//! | `innermost` | `points`: how many have the largest c-rank; `mean`: their mean, null for no points |
//! | `certificate` | how the checker accounted for every point: `vertices` of `rings`, and `copies` of them |
//! | `ranks` | the points in the order of the input: objects of `index`, `line`, `x`, `y`, `layer`, `c_rank`, `mid_rank` |

use crate::commands::input::Input;
use crate::output::hull::{boundary_name, points_line};
use crate::output::rows::{LayerRow, write_csv, write_json};
use crate::output::target::{Format, Report};
use crate::output::text;
use hull_verify::check::LayersCertificate;
use hullkit::{Boundary, Hull2, Layers, Method};
use serde::Serialize;
use std::io::{self, Write};

/// Certified layers, ready to be written.
#[derive(Debug, Serialize)]
pub struct PeelReport {
    schema: &'static str,
    source: String,
    points: usize,
    distinct: usize,
    method: &'static str,
    #[serde(skip)]
    title: &'static str,
    boundary: &'static str,
    rings: Vec<usize>,
    innermost: Innermost,
    certificate: Account,
    ranks: Vec<LayerRow>,
}

/// The points that are peeled last.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Innermost {
    points: usize,
    mean: Option<[f64; 2]>,
}

/// The checker's account of the points: vertices and copies add up to their number.
#[derive(Clone, Debug, Serialize)]
struct Account {
    rings: usize,
    vertices: usize,
    copies: usize,
}

impl PeelReport {
    /// The report on `layers`, found by `method` and proved by `certificate`.
    pub fn new(
        input: &Input,
        method: &Method,
        boundary: Boundary,
        layers: &Layers,
        certificate: &LayersCertificate,
    ) -> Self {
        Self {
            schema: "hullbench/peel/1",
            source: input.source.clone(),
            points: input.points.len(),
            distinct: input.distinct(),
            method: method.slug,
            title: method.title,
            boundary: boundary_name(boundary),
            rings: layers.rings().iter().map(Hull2::len).collect(),
            innermost: Innermost::of(&input.points, layers),
            certificate: Account::of(certificate),
            ranks: LayerRow::all(input, layers),
        }
    }
}

impl Report for PeelReport {
    const FORMATS: &'static [Format] = &[Format::Csv, Format::Json];

    fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()> {
        match format {
            Format::Csv => write_csv(out, &LayerRow::HEADER, &self.ranks),
            Format::Json => write_json(out, self),
            other => other.refuse(),
        }
    }

    fn write_summary(&self, out: &mut dyn Write) -> io::Result<()> {
        text::line(out, "source", &self.source)?;
        text::line(out, "points", points_line(self.points, self.distinct))?;
        text::line(out, "method", format!("{}, {}", self.method, self.title))?;
        text::line(out, "boundary", self.boundary)?;
        text::line(out, "layers", self.rings.len())?;
        text::list(out, "ring sizes", &self.rings)?;
        text::line(
            out,
            "innermost",
            text::count(self.innermost.points, "point", "points"),
        )?;
        if let Some([x, y]) = self.innermost.mean {
            let [x, y] = [x, y].map(text::number);
            text::line(
                out,
                "median",
                format!("({x}, {y}), the mean of the innermost"),
            )?;
        }
        text::line(out, "certificate", self.certificate.in_words())
    }

    fn headline(&self) -> String {
        let layers = text::count(self.rings.len(), "layer", "layers");
        let points = text::count(self.points, "point", "points");
        format!("{layers} of {points}, certified")
    }
}

impl Account {
    fn of(certificate: &LayersCertificate) -> Self {
        Self {
            rings: certificate.rings,
            vertices: certificate.vertices,
            copies: certificate.copies,
        }
    }

    fn in_words(&self) -> String {
        format!(
            "proved: {} vertices of {} rings + {} copies of them = {} points",
            self.vertices,
            self.rings,
            self.copies,
            self.vertices + self.copies
        )
    }
}

impl Innermost {
    /// The points of the largest c-rank, copies included, and their mean.
    fn of(points: &[[f64; 2]], layers: &Layers) -> Self {
        let last = layers.c_ranks().iter().copied().max();
        let members: Vec<_> = points
            .iter()
            .zip(layers.c_ranks())
            .filter(|&(_, &rank)| Some(rank) == last)
            .map(|(point, _)| *point)
            .collect();
        Self {
            points: members.len(),
            mean: last.map(|_| [0, 1].map(|axis| mean(&members, axis))),
        }
    }
}

/// The mean of one coordinate, also where the sum overflows.
fn mean(points: &[[f64; 2]], axis: usize) -> f64 {
    let count = points.len() as f64;
    let sum: f64 = points.iter().map(|point| point[axis]).sum();
    if sum.is_finite() {
        sum / count
    } else {
        points.iter().map(|point| point[axis] / count).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_of_huge_coordinates_does_not_overflow() {
        assert_eq!(mean(&[[1.5e308, 0.0], [1.5e308, 1.0]], 0), 1.5e308);
        assert_eq!(mean(&[[1.5e308, 0.0], [1.5e308, 1.0]], 1), 0.5);
    }

    #[test]
    fn copies_of_an_innermost_point_count() {
        let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [1.0, 1.0], [1.0, 1.0]];
        let rings = vec![Hull2::Polygon(vec![0, 1, 2]), Hull2::Point(3)];
        let innermost = Innermost::of(&points, &Layers::new(rings, vec![1, 1, 1, 2, 2]));
        let expected = Innermost {
            points: 2,
            mean: Some([1.0, 1.0]),
        };
        assert_eq!(innermost, expected);
    }

    #[test]
    fn no_points_have_no_median() {
        assert_eq!(Innermost::of(&[], &Layers::default()).mean, None);
    }
}
