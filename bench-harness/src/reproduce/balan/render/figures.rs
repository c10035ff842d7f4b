//! The figures: visibility tests, orders of insertion and evaluations of quickhull, against n.

use crate::reproduce::balan::derived::{plane_tests, runs};
use crate::reproduce::balan::published::DISTRIBUTIONS;
use crate::reproduce::balan::records::Records;
use crate::reproduce::balan::studies::orders::{AS_GIVEN, SHUFFLED};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{Chart, PALETTE, Scale, Series, Stroke, draw};
use crate::reproduce::render::sheet::Sheet;
use crate::reproduce::rows::CountRow;
use crate::reproduce::space::growth::{against_n, means};
use anyhow::Result;

/// Writes `visibility.svg` and `visibility.csv`.
pub(crate) fn write_visibility(folder: &Folder, records: &Records) -> Result<()> {
    let series = DISTRIBUTIONS.into_iter().zip(PALETTE).map(|pair| {
        let (distribution, colour) = pair;
        // On a lattice the first four points may lie in one plane, so set-up is not known to the question.
        let rows = runs(records, distribution, "incremental-3d");
        Series {
            label: distribution.to_owned(),
            colour,
            stroke: Stroke::Solid,
            points: means(&against_n(rows, plane_tests)),
        }
    });
    let chart = Figure {
        name: "visibility",
        title: "Visibility tests without a conflict graph",
        y: "tests",
        scale: Scale::Logarithmic,
    };
    chart.write(folder, &series.collect::<Vec<_>>())
}

/// Writes `orders.svg` and `orders.csv`.
pub(crate) fn write_orders(folder: &Folder, records: &Records) -> Result<()> {
    let line = |(order, label, colour, stroke): (&'static str, &str, usize, Stroke)| {
        let rows = records.counts.iter().filter(move |row| row.method == order);
        Series {
            label: label.to_owned(),
            colour: PALETTE[colour],
            stroke,
            points: means(&against_n(rows, |row| row.facets as f64)),
        }
    };
    let series = [
        (AS_GIVEN, "order as given", 1, Stroke::Solid),
        (SHUFFLED, "random order", 0, Stroke::Dashed),
    ]
    .map(line);
    let chart = Figure {
        name: "orders",
        title: "Facets made: a circle, then its axis, in this order and shuffled",
        y: "facets made",
        scale: Scale::Logarithmic,
    };
    chart.write(folder, &series)
}

/// Writes `evaluations.svg` and `evaluations.csv`.
pub(crate) fn write_evaluations(folder: &Folder, records: &Records) -> Result<()> {
    let methods = [
        ("quickhull-3d", "one set", Stroke::Solid),
        ("quickhull-balan", "as described", Stroke::Dashed),
    ];
    let mut series = Vec::new();
    for (method, label, stroke) in methods {
        for (distribution, colour) in DISTRIBUTIONS.into_iter().zip(PALETTE) {
            let a_point = |row: &CountRow| plane_tests(row) / row.n as f64;
            series.push(Series {
                label: format!("{distribution}, {label}"),
                colour,
                stroke,
                points: means(&against_n(runs(records, distribution, method), a_point)),
            });
        }
    }
    let chart = Figure {
        name: "evaluations",
        title: "Plane evaluations of quickhull a point",
        y: "evaluations a point",
        scale: Scale::Logarithmic,
    };
    chart.write(folder, &series)
}

/// A figure and its file name.
struct Figure {
    name: &'static str,
    title: &'static str,
    y: &'static str,
    scale: Scale,
}

impl Figure {
    fn write(&self, folder: &Folder, series: &[Series]) -> Result<()> {
        let filled: Vec<Series> = series
            .iter()
            .filter(|series| !series.points.is_empty())
            .cloned()
            .collect();
        let chart = Chart {
            title: self.title,
            x: "number of points n",
            y: self.y,
            scale: self.scale,
            series: &filled,
        };
        if let Some(svg) = draw(&chart)? {
            folder.svg(&format!("{}.svg", self.name), self.title, &svg)?;
        }
        let mut sheet = Sheet::new(&["series", "n", self.y]);
        for series in &filled {
            for (n, value) in &series.points {
                sheet.push(vec![
                    series.label.clone(),
                    n.to_string(),
                    format!("{value:.3}"),
                ]);
            }
        }
        folder.csv(&format!("{}.csv", self.name), &sheet.csv())
    }
}
