//! Lifting with computed heights and without.

use crate::reproduce::nathan::records::{LiftRow, Records};
use crate::reproduce::nathan::verdicts::predictions::share_of_wrong_signs;
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{Chart, PALETTE, Scale, Series, Stroke, draw};
use crate::reproduce::render::sheet::{Sheet, fixed};
use anyhow::Result;

const INTRODUCTION: &str = "\
Heights computed in doubles, z = x² + y², are rounded: the lifted points leave the paraboloid, and an exact hull of them
answers another question. Every triangulation is put to an independent check of its circles. The questions are those of
all pairs of neighbouring triangles of the certified triangulation.

![Wrong in-circle signs against the offset](lifting.svg)

";

const GRIDS: &str = "
# Grids

Cells of square grids whose corners, as doubles, are exactly cocircular, and those of them whose lifts to computed
heights do not lie in one plane. Integers, and eighths, are lifted exactly as long as x² + y² is at most 2⁵³ units.

";

/// Writes `lifting.md`, a drawing, `lifting.csv` and `grids.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let series = series(&records.own.lifting);
    let title = "In-circle questions answered wrongly by computed heights";
    let chart = Chart {
        title,
        x: "offset of every coordinate",
        y: "percent of questions",
        scale: Scale::Linear,
        series: &series,
    };
    if let Some(svg) = draw(&chart)? {
        folder.svg("lifting.svg", title, &svg)?;
    }
    let (lifts, grids) = (lifts(&records.own.lifting), grids(records));
    let text = INTRODUCTION.to_owned() + &lifts.markdown() + GRIDS + &grids.markdown();
    folder.markdown("lifting.md", "Delaunay triangulations by lifting", &text)?;
    folder.csv("lifting.csv", &lifts.csv())?;
    folder.csv("grids.csv", &grids.csv())
}

fn series(rows: &[LiftRow]) -> Vec<Series> {
    let mut series: Vec<Series> = Vec::new();
    for row in rows.iter().filter(|row| row.offset >= 1.0) {
        let label = format!(
            "{} {}",
            row.distribution.trim_start_matches("flattened-"),
            row.n
        );
        let point = share_of_wrong_signs(row).map(|share| (row.offset, 100.0 * share));
        if series.last().is_none_or(|line| line.label != label) {
            let colour = PALETTE[series.len() % PALETTE.len()];
            series.push(Series {
                label,
                colour,
                stroke: Stroke::Solid,
                points: Vec::new(),
            });
        }
        if let Some(line) = series.last_mut() {
            line.points.extend(point);
        }
    }
    series
}

fn lifts(rows: &[LiftRow]) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "offset",
        "sets",
        "right without heights",
        "right with computed heights",
        "questions",
        "wrong signs, %",
    ]);
    for row in rows {
        sheet.push(vec![
            row.distribution.clone(),
            row.n.to_string(),
            format!("{:e}", row.offset),
            row.sets.to_string(),
            row.exact_right.to_string(),
            row.rounded_right.to_string(),
            row.quadruples.to_string(),
            fixed(share_of_wrong_signs(row).map(|share| 100.0 * share), 3),
        ]);
    }
    sheet
}

fn grids(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "spacing",
        "offset",
        "cocircular cells",
        "wrong signs",
        "wrong, %",
    ]);
    for row in &records.own.grids {
        sheet.push(vec![
            row.spacing.to_string(),
            row.offset.to_string(),
            row.cocircular.to_string(),
            row.wrong_signs.to_string(),
            format!(
                "{:.1}",
                100.0 * row.wrong_signs as f64 / row.cocircular.max(1) as f64
            ),
        ]);
    }
    sheet
}
