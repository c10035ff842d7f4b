//! What wrapping asks.

use crate::reproduce::nathan::records::{Records, WrapRow};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{Chart, PALETTE, Scale, Series, Stroke, draw};
use crate::reproduce::render::sheet::Sheet;
use crate::stats::summary::mean;
use anyhow::Result;
use std::collections::BTreeMap;

const INTRODUCTION: &str = "\
Counted with exact answers; every wrap is the certified hull. *printed* is the paper to the letter, *corrected* our
registered method `nathan`, *pivot-wrap* the wrap that keeps the best candidate of one pass. Random order gives O(h n log n):
a search takes n (½ ln n + c) tests. Inside out, the points that refute a candidate come last, and it is O(h n²).

![Plane tests over n h](wraps.svg)

";

/// A distribution, an order, a variant, and a size.
type Key<'a> = (&'a str, &'a str, &'a str, usize);

/// A variant, an order and a distribution: what a line is for.
type Label<'a> = (&'a str, &'a str, &'a str);

/// Writes `wraps.md`, a drawing and `wraps.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let mut groups: BTreeMap<Key<'_>, Vec<&WrapRow>> = BTreeMap::new();
    for row in &records.own.wraps {
        let key = (
            row.distribution.as_str(),
            row.order.as_str(),
            row.variant.as_str(),
            row.n,
        );
        groups.entry(key).or_default().push(row);
    }
    let series = series(&groups);
    let title = "Plane tests over n h";
    let chart = Chart {
        title,
        x: "number of points n",
        y: "tests over n h",
        scale: Scale::Logarithmic,
        series: &series,
    };
    if let Some(svg) = draw(&chart)? {
        folder.svg("wraps.svg", title, &svg)?;
    }
    let sheet = table(&groups);
    let text = INTRODUCTION.to_owned() + &sheet.markdown();
    folder.markdown("wraps.md", "What wrapping asks", &text)?;
    folder.csv("wraps.csv", &sheet.csv())
}

fn average(rows: &[&WrapRow], of: impl Fn(&WrapRow) -> f64) -> f64 {
    mean(&rows.iter().map(|row| of(row)).collect::<Vec<f64>>())
}

/// A line for each distribution, order and variant, pivoting dashed.
fn series(groups: &BTreeMap<Key<'_>, Vec<&WrapRow>>) -> Vec<Series> {
    let mut lines: BTreeMap<Label<'_>, Vec<(f64, f64)>> = BTreeMap::new();
    for (&(distribution, order, variant, n), rows) in groups {
        let is_shown = variant == "printed" || (variant == "pivot-wrap" && order == "random");
        if is_shown {
            let point = (n as f64, average(rows, WrapRow::over_nh));
            lines
                .entry((variant, order, distribution))
                .or_default()
                .push(point);
        }
    }
    let colour = |place: usize| PALETTE[place % PALETTE.len()];
    let line = |(place, ((variant, order, distribution), points)): (
        usize,
        (Label<'_>, Vec<(f64, f64)>),
    )| Series {
        label: match (variant, order) {
            ("pivot-wrap", _) => format!("{distribution}, pivot"),
            (_, "random") => distribution.to_owned(),
            _ => format!("{distribution}, {order}"),
        },
        colour: colour(place),
        stroke: if variant == "pivot-wrap" {
            Stroke::Dashed
        } else {
            Stroke::Solid
        },
        points,
    };
    lines.into_iter().enumerate().map(line).collect()
}

fn table(groups: &BTreeMap<Key<'_>, Vec<&WrapRow>>) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "order",
        "wrap",
        "n",
        "runs",
        "h",
        "triangles / h",
        "repeated / h",
        "plane tests / (n h)",
        "passes a search",
        "less ½ ln n",
        "comparisons of edges / (3h-6)²",
    ]);
    for (&(distribution, order, variant, n), rows) in groups {
        let h = |row: &WrapRow| row.h as f64;
        let passes = average(rows, WrapRow::passes);
        let edges = |row: &WrapRow| row.mark_comparisons as f64 / (3.0 * h(row) - 6.0).powi(2);
        sheet.push(vec![
            distribution.to_owned(),
            order.to_owned(),
            variant.to_owned(),
            n.to_string(),
            rows.len().to_string(),
            format!("{:.1}", average(rows, h)),
            format!("{:.3}", average(rows, |row| row.triangles as f64 / h(row))),
            format!(
                "{:.3}",
                average(rows, |row| row.repetitions as f64 / h(row))
            ),
            format!("{:.3}", average(rows, WrapRow::over_nh)),
            format!("{passes:.3}"),
            match variant {
                "pivot-wrap" => String::new(),
                _ => format!("{:.3}", passes - 0.5 * (n as f64).ln()),
            },
            match variant {
                "pivot-wrap" => String::new(),
                _ => format!("{:.3}", average(rows, edges)),
            },
        ]);
    }
    sheet
}
