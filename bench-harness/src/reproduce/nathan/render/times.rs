//! Times: the own corners tested or skipped, and registered methods beside each other.

use crate::records::rows::twin_of;
use crate::reproduce::nathan::records::Records;
use crate::reproduce::nathan::verdicts::CELL_MARGIN;
use crate::reproduce::ratio::{median_time, time_ratio};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::{Sheet, duration, fixed};
use anyhow::Result;

/// Writes `wrap-times.md` and `wrap-times.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "wrap",
        "median",
        "over the first",
        "90 % interval",
    ]);
    for (distribution, n) in cells(records) {
        let cell = (distribution, n);
        let names = names(records, cell);
        for family in [is_arm as fn(&str) -> bool, |name| !is_arm(name)] {
            let names: Vec<&str> = names.iter().copied().filter(|name| family(name)).collect();
            let Some(first) = names.first() else { continue };
            for name in &names {
                let ratio = time_ratio(&records.times, cell, name, first);
                let interval = ratio.as_ref().map(|ratio| ratio.interval(0.90));
                sheet.push(vec![
                    distribution.to_owned(),
                    n.to_string(),
                    (*name).to_owned(),
                    median_time(&records.times, cell, name).map_or_else(String::new, duration),
                    fixed(ratio.map(|ratio| ratio.median.exp()), 3),
                    interval.map_or_else(String::new, |(low, high)| {
                        format!("{:.3} to {:.3}", low.exp(), high.exp())
                    }),
                ]);
            }
        }
    }
    let text = format!(
        "Samples taken in turn, warm, on certified sets only; *@twin* is the same program once more. *Tested* and \
         *skipped* are the two ways to treat a candidate's own corners: *printed* is the innermost loop in the paper's \
         arithmetic over all candidates of a wrap, *exact* the whole wrap with exact answers. A difference within \
         {:.0} % is none.\n\n{}",
        100.0 * CELL_MARGIN,
        sheet.markdown()
    );
    folder.markdown("wrap-times.md", "Times of wrapping", &text)?;
    folder.csv("wrap-times.csv", &sheet.csv())
}

/// Whether a contestant is one of the ways with the own corners.
fn is_arm(name: &str) -> bool {
    name.contains(", ")
}

fn cells(records: &Records) -> Vec<(&str, usize)> {
    let cells = records
        .times
        .iter()
        .map(|row| (row.distribution.as_str(), row.n));
    let mut cells: Vec<(&str, usize)> = cells.collect();
    cells.sort_unstable();
    cells.dedup();
    cells
}

/// The contestants of a cell, a twin right after its original.
fn names<'a>(records: &'a Records, cell: (&str, usize)) -> Vec<&'a str> {
    let rows = records.times.iter();
    let rows = rows.filter(|row| (row.distribution.as_str(), row.n) == cell);
    let mut names: Vec<&str> = rows.map(|row| row.method.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let twinned = |name: &str| names.iter().any(|other| twin_of(other) == Some(name));
    let key = |name: &&str| !twinned(twin_of(name).unwrap_or(name));
    let mut sorted = names.clone();
    sorted.sort_by_key(key);
    sorted
}
