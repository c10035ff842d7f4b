//! The paper's epsilon and its first points, set against exact answers.

use super::percent;
use crate::reproduce::nathan::records::{EpsilonRow, Records};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{Chart, PALETTE, Scale, Series, Stroke, draw};
use crate::reproduce::render::sheet::Sheet;
use anyhow::Result;

const INTRODUCTION: &str = "\
A run is wrong if its triangles are not the surface of the certified hull of the points as they were given to it.
*Tested* is as printed: a candidate is tested against its own corners too. In percent, with 95 % intervals.

![Wrong wraps against the offset](epsilon.svg)

";

const STARTS: &str = "
# First points

Sets whose first point is not on the hull of the flattened points, in percent, with 95 % intervals.

";

/// Writes `epsilon.md`, a drawing, `epsilon.csv` and `starts.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let series = series(&records.own.epsilon);
    let title = "Wrong wraps with the paper's epsilon";
    let chart = Chart {
        title,
        x: "offset of every coordinate (1 stands for 0 too)",
        y: "percent of sets",
        scale: Scale::Linear,
        series: &series,
    };
    if let Some(svg) = draw(&chart)? {
        folder.svg("epsilon.svg", title, &svg)?;
    }
    let (wraps, starts) = (wraps(&records.own.epsilon), starts(records));
    let text = INTRODUCTION.to_owned() + &wraps.markdown() + STARTS + &starts.markdown();
    folder.markdown("epsilon.md", "The epsilon", &text)?;
    folder.csv("epsilon.csv", &wraps.csv())?;
    folder.csv("starts.csv", &starts.csv())
}

/// Sets and ways with the own corners, each once, in the order of the rows.
fn arms(rows: &[EpsilonRow]) -> Vec<(&str, &str, &str)> {
    let mut arms = Vec::new();
    for row in rows {
        let arm = (
            row.distribution.as_str(),
            row.arithmetic.as_str(),
            row.own_corners.as_str(),
        );
        if !arms.contains(&arm) {
            arms.push(arm);
        }
    }
    arms
}

fn series(rows: &[EpsilonRow]) -> Vec<Series> {
    let mut names: Vec<&str> = Vec::new();
    let mut series = Vec::new();
    for (distribution, arithmetic, own_corners) in arms(rows) {
        if arithmetic != "epsilon" {
            continue;
        }
        if !names.contains(&distribution) {
            names.push(distribution);
        }
        let of_arm = rows.iter().filter(|row| {
            row.distribution == distribution
                && row.arithmetic == arithmetic
                && row.own_corners == own_corners
                && row.offset >= 1.0
                && row.sets > 0
        });
        let share = |row: &EpsilonRow| 100.0 * row.wrong as f64 / row.sets as f64;
        let short = distribution.trim_start_matches("shuffled:of=");
        series.push(Series {
            label: format!("{short}, {own_corners}"),
            colour: PALETTE[(names.len() - 1) % PALETTE.len()],
            stroke: match own_corners {
                "tested" => Stroke::Solid,
                _ => Stroke::Dashed,
            },
            points: of_arm.map(|row| (row.offset, share(row))).collect(),
        });
    }
    series
}

fn wraps(rows: &[EpsilonRow]) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "offset",
        "arithmetic",
        "own corners",
        "sets",
        "wrong, %",
    ]);
    for row in rows {
        sheet.push(vec![
            row.distribution.clone(),
            row.n.to_string(),
            format!("{:e}", row.offset),
            row.arithmetic.clone(),
            row.own_corners.clone(),
            row.sets.to_string(),
            percent(row.wrong, row.sets),
        ]);
    }
    sheet
}

fn starts(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "offset",
        "first point",
        "sets",
        "off the hull, %",
    ]);
    for row in &records.own.starts {
        sheet.push(vec![
            row.distribution.clone(),
            row.n.to_string(),
            format!("{:e}", row.offset),
            row.start.clone(),
            row.sets.to_string(),
            percent(row.off_hull, row.sets),
        ]);
    }
    sheet
}
