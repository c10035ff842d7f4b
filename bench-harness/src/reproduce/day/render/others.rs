//! The smaller tables: degenerate sets, bases of the recursion, the spiral, the paper's check, side by side.

use super::share;
use crate::reproduce::day::derived::in_order;
use crate::reproduce::day::records::{BaseRow, BatteryRow, CheckRow, Records};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use crate::stats::summary::mean;
use anyhow::Result;
use std::collections::BTreeMap;

const DEGENERATE: &str = "\
How degenerate sets end, with Day's cotangents at the eps2 named, and with exact orientations and a symbolic perturbation,
where all variants of the method, quickhull and gift wrapping must give the one certified hull. Shares right with Wilson's
intervals at 95 %; the rest are wrong hulls / endless / dangling. *Vanish* is the share of exact answers that are zero: what
the perturbation is there for. With cotangents, coplanar faces may come as any triangles.

";

const BASES: &str = "\
Orientations a point, means over the sets, if the recursion stopped at parts of so many points: those of the parts, and
those of the merges above them, which are the merges of the method as it is. Every set was certified first.

";

const DUMMIES: &str = "
# Dummy points

Sets whose size is no multiple of four, made one by points inside.

";

const SPIRAL: &str = "\
The faces of the hull, in triangles, as the paper's closed path meets them, against a plain traversal of the edge records.
*Calls deep* is what the paper's recursive procedure would take; here the path is followed with a stack. Means over the
sets of a cell.

";

const CHECKS: &str = "\
The paper's third stage of testing: F(x) = x · (p₁ × p₂ + p₂ × p₃ + p₃ × p₁) - [p₁, p₂, p₃] for every face and every other
point, with the origin inside, in the format in which the hull was made, and by exact orientations. Which hulls are right is
known from a certificate.

";

const SIDE_BY_SIDE: &str = "\
The same sets by one processor and with halves side by side: hulls and questions. Times are in [whole.md](whole.md).

";

/// Writes `degenerate.md` and `degenerate.csv`.
pub(crate) fn write_degenerate(folder: &Folder, records: &Records) -> Result<()> {
    let formats = in_order(records.own.battery.iter().map(|row| &row.format));
    let power = |format: &str| {
        let row = records.own.battery.iter().find(|row| row.format == format);
        row.and_then(|row| row.power)
    };
    let heads: Vec<String> = formats
        .iter()
        .map(|format| match power(format) {
            Some(power) => format!("{format}, 1e{power}"),
            None => (*format).to_owned(),
        })
        .collect();
    let mut columns = vec!["what", "set", "n", "sets"];
    columns.extend(heads.iter().map(String::as_str));
    columns.push("vanish, %");
    let mut sheet = Sheet::new(&columns);
    let mut cells: BTreeMap<(&str, &str, usize), Vec<&BatteryRow>> = BTreeMap::new();
    for row in &records.own.battery {
        let key = (row.what.as_str(), row.distribution.as_str(), row.n);
        cells.entry(key).or_default().push(row);
    }
    for ((what, distribution, n), rows) in cells {
        let of = |format: &str| -> Vec<&&BatteryRow> {
            rows.iter().filter(|row| row.format == format).collect()
        };
        let exact = of(formats.first().copied().unwrap_or_default());
        let questions: u64 = exact.iter().map(|row| row.questions).sum();
        let vanished: u64 = exact.iter().map(|row| row.vanished).sum();
        let mut line = vec![
            if what.is_empty() {
                "general position"
            } else {
                what
            }
            .to_owned(),
            distribution.to_owned(),
            n.to_string(),
            exact.len().to_string(),
        ];
        line.extend(formats.iter().map(|format| ends(&of(format))));
        line.push(format!(
            "{:.2}",
            100.0 * vanished as f64 / questions.max(1) as f64
        ));
        sheet.push(line);
    }
    let body = DEGENERATE.to_owned() + &sheet.markdown();
    folder.markdown("degenerate.md", "Degenerate sets", &body)?;
    folder.csv("degenerate.csv", &sheet.csv())
}

/// Share right with its interval, and what became of the rest.
fn ends(rows: &[&&BatteryRow]) -> String {
    let count = |end: &str| rows.iter().filter(|row| row.outcome == end).count();
    let right = count("right");
    let rest = ["wrong hull", "endless", "dangling"].map(|end| count(end).to_string());
    let text = share(right, rows.len());
    if right == rows.len() {
        text
    } else {
        format!("{text}; {}", rest.join(" / "))
    }
}

/// Writes `bases.md` and `bases.csv`.
pub(crate) fn write_bases(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "points of a part",
        "by",
        "parts",
        "merges",
        "all",
    ]);
    let mut cells: BTreeMap<(&str, usize, usize, &str), Vec<&BaseRow>> = BTreeMap::new();
    for row in &records.own.bases {
        let key = (row.distribution.as_str(), row.n, row.size, row.way.as_str());
        cells.entry(key).or_default().push(row);
    }
    for ((distribution, n, size, way), rows) in cells {
        let a_point = |of: fn(&BaseRow) -> u64| {
            let values: Vec<f64> = rows.iter().map(|row| of(row) as f64 / n as f64).collect();
            format!("{:.3}", mean(&values))
        };
        sheet.push(vec![
            distribution.to_owned(),
            n.to_string(),
            size.to_string(),
            way.to_owned(),
            a_point(|row| row.base),
            a_point(|row| row.merges),
            a_point(BaseRow::total),
        ]);
    }
    let mut dummies = Sheet::new(&["n", "format", "eps2", "sets", "right"]);
    for row in &records.own.dummies {
        dummies.push(vec![
            row.n.to_string(),
            row.format.clone(),
            format!("1e{}", row.power),
            row.sets.to_string(),
            share(row.right, row.sets),
        ]);
    }
    let body = BASES.to_owned() + &sheet.markdown() + DUMMIES + &dummies.markdown();
    folder.markdown("bases.md", "Where the recursion stops", &body)?;
    folder.csv("bases.csv", &sheet.csv())
}

/// Writes `spiral.md` and `spiral.csv`.
pub(crate) fn write_spiral(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "sets",
        "faces",
        "listed",
        "in one list only",
        "next to the one before, %",
        "calls deep",
    ]);
    let mut cells: BTreeMap<(&str, usize), Vec<_>> = BTreeMap::new();
    for row in &records.own.listings {
        let key = (row.distribution.as_str(), row.n);
        cells.entry(key).or_default().push(row);
    }
    for ((distribution, n), rows) in cells {
        let average = |of: fn(&crate::reproduce::day::records::ListingRow) -> f64| {
            mean(&rows.iter().map(|row| of(row)).collect::<Vec<_>>())
        };
        sheet.push(vec![
            distribution.to_owned(),
            n.to_string(),
            rows.len().to_string(),
            format!("{:.0}", average(|row| row.faces as f64)),
            format!("{:.0}", average(|row| row.listed as f64)),
            format!("{:.0}", average(|row| row.only_one as f64)),
            format!(
                "{:.1}",
                100.0 * average(|row| row.neighbours as f64 / (row.listed.max(2) - 1) as f64)
            ),
            format!("{:.0}", average(|row| row.deepest as f64)),
        ]);
    }
    let body = SPIRAL.to_owned() + &sheet.markdown();
    folder.markdown("spiral.md", "Listing the faces", &body)?;
    folder.csv("spiral.csv", &sheet.csv())
}

/// Writes `checks.md` and `checks.csv`.
pub(crate) fn write_checks(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "made in",
        "eps2",
        "checked in",
        "right: accepted",
        "right: rejected",
        "wrong: accepted",
        "wrong: rejected",
        "right but for a face left out: accepted",
    ]);
    for row in &records.own.checks {
        let CheckRow {
            right_accepted,
            right_rejected,
            wrong_accepted,
            wrong_rejected,
            holed_accepted,
            ..
        } = row;
        let mut cells = vec![
            row.made_in.clone(),
            format!("1e{}", row.power),
            row.checked_in.clone(),
        ];
        let counts = [
            right_accepted,
            right_rejected,
            wrong_accepted,
            wrong_rejected,
        ];
        cells.extend(counts.map(ToString::to_string));
        cells.push(holed_accepted.to_string());
        sheet.push(cells);
    }
    let body = CHECKS.to_owned() + &sheet.markdown();
    folder.markdown("checks.md", "The paper's own check", &body)?;
    folder.csv("checks.csv", &sheet.csv())
}

/// Writes `side-by-side.md` and `side-by-side.csv`.
pub(crate) fn write_side_by_side(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&["set", "n", "replicate", "certified", "one", "side by side"]);
    for row in &records.own.parallel {
        sheet.push(vec![
            row.distribution.clone(),
            row.n.to_string(),
            row.replicate.to_string(),
            if row.same_hull { "both" } else { "**no**" }.to_owned(),
            row.sequential.to_string(),
            row.parallel.to_string(),
        ]);
    }
    let body = SIDE_BY_SIDE.to_owned() + &sheet.markdown();
    folder.markdown("side-by-side.md", "Side by side", &body)?;
    folder.csv("side-by-side.csv", &sheet.csv())
}
