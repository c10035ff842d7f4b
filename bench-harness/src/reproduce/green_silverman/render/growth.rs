//! Figure 7: time and questions of GS and E against the number of points.

use crate::reproduce::green_silverman::derived::{counts_against_n, times_against_n};
use crate::reproduce::green_silverman::published::DISTRIBUTIONS;
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{Chart, PALETTE, Scale, Series, Stroke, draw};
use crate::reproduce::render::sheet::{Sheet, duration};
use crate::stats::summary::{mean, median};
use anyhow::Result;
use std::collections::BTreeMap;

/// The methods of the figure.
const METHODS: [(&str, &str, Stroke); 2] =
    [("gs", "GS", Stroke::Solid), ("eddy", "E", Stroke::Dashed)];

const INTRODUCTION: &str = "\
Median time of a call, and mean number of questions, against the number of points: GS solid with discs, E dashed
with triangles; one colour a distribution. The paper's figure shows times up to about a thousand points.

![Time against n](figure7-time.svg)

![Time a point against n](figure7-time-a-point.svg)

![Questions a point against n](figure7-questions-a-point.svg)

";

/// Writes `figure7.md`, three drawings and `figure7.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let time =
        lines(|distribution, method| by_n(times_against_n(records, distribution, method), median));
    let questions = lines(|distribution, method| {
        by_n(
            counts_against_n(records, distribution, method, |row| row.questions()),
            mean,
        )
    });
    let per_point = |series: &[Series], unit: f64| -> Vec<Series> {
        let divide = |series: &Series| Series {
            points: series
                .points
                .iter()
                .map(|&(n, value)| (n, value / n / unit))
                .collect(),
            ..series.clone()
        };
        series.iter().map(divide).collect()
    };
    let milliseconds: Vec<Series> = time
        .iter()
        .map(|series| Series {
            points: series
                .points
                .iter()
                .map(|&(n, time)| (n, time / 1e6))
                .collect(),
            ..series.clone()
        })
        .collect();
    let charts = [
        (
            "figure7-time.svg",
            "Time of one call",
            "milliseconds",
            Scale::Logarithmic,
            milliseconds,
        ),
        (
            "figure7-time-a-point.svg",
            "Time a point",
            "nanoseconds a point",
            Scale::Linear,
            per_point(&time, 1.0),
        ),
        (
            "figure7-questions-a-point.svg",
            "Questions a point",
            "questions a point",
            Scale::Linear,
            per_point(&questions, 1.0),
        ),
    ];
    for (name, title, y, scale, series) in &charts {
        let chart = Chart {
            title,
            x: "number of points n",
            y,
            scale: *scale,
            series,
        };
        if let Some(svg) = draw(&chart)? {
            folder.svg(name, title, &svg)?;
        }
    }
    folder.markdown(
        "figure7.md",
        "Figure 7: growth of GS and E",
        &(INTRODUCTION.to_owned() + &table(&time)),
    )?;
    folder.csv("figure7.csv", &long(&time, &questions).csv())
}

/// One line a distribution and method.
fn lines(points: impl Fn(&str, &str) -> Vec<(f64, f64)>) -> Vec<Series> {
    let mut lines = Vec::new();
    for (method, letter, stroke) in METHODS {
        for (distribution, colour) in DISTRIBUTIONS.into_iter().zip(PALETTE) {
            let points = points(distribution, method);
            lines.push(Series {
                label: format!("{letter}, {distribution}"),
                colour,
                stroke,
                points,
            });
        }
    }
    lines
}

/// One value for each n.
fn by_n(data: Vec<(usize, f64)>, of: fn(&[f64]) -> f64) -> Vec<(f64, f64)> {
    let mut groups: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for (n, value) in data {
        groups.entry(n).or_default().push(value);
    }
    groups
        .into_iter()
        .map(|(n, values)| (n as f64, of(&values)))
        .collect()
}

fn table(time: &[Series]) -> String {
    let mut columns = vec!["n"];
    columns.extend(time.iter().map(|series| series.label.as_str()));
    let mut sheet = Sheet::new(&columns);
    let mut sizes: Vec<f64> = time
        .iter()
        .flat_map(|series| series.points.iter().map(|(n, _)| *n))
        .collect();
    sizes.sort_unstable_by(f64::total_cmp);
    sizes.dedup();
    for n in sizes {
        let at = |series: &Series| {
            series
                .points
                .iter()
                .find(|(size, _)| size.total_cmp(&n).is_eq())
                .map(|(_, time)| *time)
        };
        let mut row = vec![n.to_string()];
        row.extend(
            time.iter()
                .map(|series| at(series).map_or_else(String::new, duration)),
        );
        sheet.push(row);
    }
    sheet.markdown()
}

fn long(time: &[Series], questions: &[Series]) -> Sheet {
    let mut sheet = Sheet::new(&["series", "n", "quantity", "value"]);
    for (quantity, lines) in [
        ("nanoseconds a call, median", time),
        ("questions a call, mean", questions),
    ] {
        for series in lines {
            for (n, value) in &series.points {
                sheet.push(vec![
                    series.label.clone(),
                    n.to_string(),
                    quantity.to_owned(),
                    format!("{value:.1}"),
                ]);
            }
        }
    }
    sheet
}
