//! Storage and cost of complete peelings (GS-7, GS-9).

use crate::reproduce::green_silverman::records::{PeelRow, Records};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use crate::stats::summary::mean;
use anyhow::Result;
use std::collections::BTreeMap;

/// The peelings of each cell.
fn cells(records: &Records) -> BTreeMap<(&str, usize), Vec<&PeelRow>> {
    let mut cells: BTreeMap<(&str, usize), Vec<&PeelRow>> = BTreeMap::new();
    for row in &records.own.peels {
        cells
            .entry((&row.distribution, row.n))
            .or_default()
            .push(row);
    }
    cells
}

fn mean_of(rows: &[&PeelRow], value: impl Fn(&PeelRow) -> f64) -> f64 {
    mean(&rows.iter().map(|row| value(row)).collect::<Vec<f64>>())
}

fn most(rows: &[&PeelRow], value: impl Fn(&PeelRow) -> u64) -> u64 {
    rows.iter().map(|row| value(row)).max().unwrap_or(0)
}

/// Writes `storage.md` and `storage.csv`.
pub(crate) fn write_storage(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "distribution",
        "n",
        "peelings",
        "m, mean",
        "m, most",
        "peels + largest peel, mean",
        "m / bound, most",
        "m / n",
    ]);
    for ((distribution, n), rows) in cells(records) {
        let bound = |row: &PeelRow| (row.layers + row.largest) as f64;
        let fullest = rows
            .iter()
            .map(|row| row.storage as f64 / bound(row))
            .fold(0.0, f64::max);
        let storage = mean_of(&rows, |row| row.storage as f64);
        sheet.push(vec![
            distribution.to_owned(),
            n.to_string(),
            rows.len().to_string(),
            format!("{storage:.1}"),
            most(&rows, |row| row.storage).to_string(),
            format!("{:.1}", mean_of(&rows, bound)),
            format!("{fullest:.3}"),
            format!("{:.4}", storage / n as f64),
        ]);
    }
    let body = "m is the high-water mark of the stack of labels (peels found, edges and test lists of the present \
                peel) during a complete peeling by GS. The paper's bound is the number of peels plus the points on \
                the largest.\n\n"
        .to_owned()
        + &sheet.markdown();
    folder.markdown("storage.md", "Storage: the stack of method GS", &body)?;
    folder.csv("storage.csv", &sheet.csv())
}

/// Writes `peeling.md` and `peeling.csv`.
pub(crate) fn write_peeling(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "distribution",
        "n",
        "peelings",
        "layers",
        "layers / n^(2/3)",
        "points left, summed",
        "sum / (n layers)",
        "sum / n^(5/3)",
        "areas / sum",
        "questions / sum",
    ]);
    for ((distribution, n), rows) in cells(records) {
        let size = n as f64;
        let layers = mean_of(&rows, |row| row.layers as f64);
        let remaining = mean_of(&rows, |row| row.remaining as f64);
        sheet.push(vec![
            distribution.to_owned(),
            n.to_string(),
            rows.len().to_string(),
            format!("{layers:.2}"),
            format!("{:.4}", layers / size.powf(2.0 / 3.0)),
            format!("{remaining:.0}"),
            format!(
                "{:.4}",
                mean_of(&rows, |row| row.remaining as f64
                    / (size * row.layers as f64))
            ),
            format!("{:.4}", remaining / size.powf(5.0 / 3.0)),
            format!(
                "{:.3}",
                mean_of(&rows, |row| row.orientations as f64 / row.remaining as f64)
            ),
            format!(
                "{:.3}",
                mean_of(&rows, |row| row.questions as f64 / row.remaining as f64)
            ),
        ]);
    }
    let body = "Complete peelings by GS with exact answers, each certified. Every peel looks at all points that are \
                left, so the sum of the points left before each peel is the work. On the disc the layers close in so \
                that the sum tends to 2/5 of n times the number of layers.\n\n"
        .to_owned()
        + &sheet.markdown();
    folder.markdown("peeling.md", "Peeling: what all layers cost", &body)?;
    folder.csv("peeling.csv", &sheet.csv())
}
