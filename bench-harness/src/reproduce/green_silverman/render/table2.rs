//! Table 2: vertices, questions and times of the seven methods and their kin.

use crate::reproduce::green_silverman::derived::TWIN;
use crate::reproduce::green_silverman::derived::{Cell, a_point, count_ratio, sizes};
use crate::reproduce::green_silverman::published::{KIN, METHODS, Published};
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::ratio::{median_time, time_ratio, timed_cells};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::{Sheet, duration, fixed};
use crate::reproduce::rows::CountRow;
use crate::reproduce::theory::hull_size::expected;
use crate::stats::kendall;
use anyhow::Result;

const INTRODUCTION: &str = "\
Every time is of a certified result. *Questions* are all that a method asks of the kernel for one point; *areas* are
the orientations among them, the paper's area evaluations. Ratios are to GS on the same sets: for time the median
of the rounds' ratios with its 95 % bootstrap interval over realisations. The paper's times are of single
precision FORTRAN on a CDC 7600. Rows below the seven are kin of theirs, and GS against itself.

";

/// Writes `table2.md` and `table2.csv`, `vertices.csv`.
pub(crate) fn write(folder: &Folder, records: &Records, published: &Published) -> Result<()> {
    let vertices = vertices(records, published);
    let mut body = format!(
        "{INTRODUCTION}## Average number of vertices\n\n{}\n",
        vertices.markdown()
    );
    body += "z is the distance from the exact expectation in standard errors: of our mean, and of the printed one \
             with our spread and the paper's number of realisations.\n\n";
    let mut all = Sheet::new(&[
        "distribution",
        "n",
        "method",
        "published_ms",
        "published_ratio",
        "median_ns",
        "ratio",
        "ratio_low",
        "ratio_high",
        "areas_a_point",
        "questions_a_point",
        "questions_ratio",
    ]);
    for (distribution, n) in timed_cells(&records.times) {
        let cell = (distribution.as_str(), n);
        if median_time(&records.times, cell, "graham").is_none() {
            continue; // a cell of Figure 7
        }
        body += &format!(
            "## {distribution}, n = {n}\n\n{}\n{}\n",
            section(records, published, cell).markdown(),
            orders(records, published, cell)
        );
        long(&mut all, records, published, cell);
    }
    folder.markdown("table2.md", "Table 2: seven methods", &body)?;
    folder.csv("vertices.csv", &vertices.csv())?;
    folder.csv("table2.csv", &all.csv())
}

fn vertices(records: &Records, published: &Published) -> Sheet {
    let mut sheet = Sheet::new(&[
        "distribution",
        "n",
        "published",
        "of",
        "ours",
        "s.e.",
        "sd",
        "replicates",
        "exact",
        "z ours",
        "z published",
    ]);
    let mut cells: Vec<(String, usize)> = records
        .sizes
        .iter()
        .map(|row| (row.distribution.clone(), row.n))
        .collect();
    cells.dedup();
    for (distribution, n) in cells {
        let cell = (distribution.as_str(), n);
        let Some(ours) = sizes(records, cell) else {
            continue;
        };
        let exact = expected(&distribution, n);
        let printed = published.table2(&distribution, n, "average vertices");
        let of = published.table2(&distribution, n, "realisations");
        let z = printed
            .zip(of)
            .zip(exact)
            .map(|((printed, of), exact)| (printed - exact) / ours.error(of));
        sheet.push(vec![
            distribution.clone(),
            n.to_string(),
            fixed(printed, 1),
            fixed(of, 0),
            format!("{:.3}", ours.mean),
            format!("{:.3}", ours.error(ours.replicates as f64)),
            format!("{:.3}", ours.deviation),
            ours.replicates.to_string(),
            fixed(exact, 4),
            fixed(exact.map(|exact| ours.z(exact)), 2),
            fixed(z, 2),
        ]);
    }
    sheet
}

/// The methods of the table and their letters, kin and twin last.
fn rows() -> impl Iterator<Item = (&'static str, &'static str)> {
    METHODS
        .into_iter()
        .chain(KIN)
        .chain([("gs-bare", "GS, hull only"), (TWIN, "GS again")])
}

fn section(records: &Records, published: &Published, cell: Cell<'_>) -> Sheet {
    let mut sheet = Sheet::new(&[
        "",
        "method",
        "published ms",
        "published / GS",
        "median",
        "time / GS",
        "95 %",
        "areas a point",
        "questions a point",
        "questions / GS",
    ]);
    for (slug, letter) in rows() {
        if records.failed(cell.0, cell.1, slug) {
            sheet.push(vec![
                letter.to_owned(),
                slug.to_owned(),
                String::new(),
                String::new(),
                "no certificate".to_owned(),
            ]);
            continue;
        }
        let Some(median) = median_time(&records.times, cell, slug) else {
            continue;
        };
        let ratio = time_ratio(&records.times, cell, slug, "gs");
        let interval = ratio.as_ref().map(|ratio| ratio.interval(0.95));
        sheet.push(vec![
            letter.to_owned(),
            slug.to_owned(),
            fixed(published.table2(cell.0, cell.1, slug), 2),
            fixed(published.ratio_to_gs(cell.0, cell.1, slug), 2),
            duration(median),
            fixed(ratio.map(|ratio| ratio.median.exp()), 3),
            interval.map_or_else(String::new, |(low, high)| {
                format!("{:.3} – {:.3}", low.exp(), high.exp())
            }),
            fixed(a_point(records, cell, slug, |row| row.orientations), 3),
            fixed(a_point(records, cell, slug, |row| row.questions()), 3),
            fixed(
                count_ratio(records, cell, slug, "gs", CountRow::questions)
                    .map(|ratio| ratio.ratio()),
                3,
            ),
        ]);
    }
    sheet
}

/// The order of the seven methods, by the paper, by time and by questions, with Kendall's tau to the paper's.
fn orders(records: &Records, published: &Published, cell: Cell<'_>) -> String {
    let order = |value: &dyn Fn(&str) -> Option<f64>| -> Option<(Vec<f64>, String)> {
        let values: Option<Vec<f64>> = METHODS.iter().map(|(slug, _)| value(slug)).collect();
        let values = values?;
        let mut letters: Vec<(f64, &str)> = values
            .iter()
            .copied()
            .zip(METHODS.map(|(_, letter)| letter))
            .collect();
        letters.sort_by(|a, b| a.0.total_cmp(&b.0));
        let text = letters
            .iter()
            .map(|(_, letter)| *letter)
            .collect::<Vec<_>>()
            .join(" < ");
        Some((values, text))
    };
    let printed = order(&|slug| published.table2(cell.0, cell.1, slug));
    let time = order(&|slug| median_time(&records.times, cell, slug));
    let questions = order(&|slug| a_point(records, cell, slug, |row| row.questions()));
    let mut text = String::new();
    if let Some((_, order)) = &printed {
        text += &format!("- published order: {order}\n");
    }
    for (what, ours) in [("time", &time), ("questions", &questions)] {
        let Some((values, order)) = ours else {
            continue;
        };
        let tau = printed
            .as_ref()
            .map(|(printed, _)| kendall::tau(printed, values));
        let tau = tau.map_or_else(String::new, |tau| {
            format!(" (Kendall's tau with the published order {tau:.2})")
        });
        text += &format!("- order by {what}: {order}{tau}\n");
    }
    text
}

fn long(sheet: &mut Sheet, records: &Records, published: &Published, cell: Cell<'_>) {
    for (slug, _) in rows() {
        let Some(median) = median_time(&records.times, cell, slug) else {
            continue;
        };
        let ratio = time_ratio(&records.times, cell, slug, "gs");
        let interval = ratio.as_ref().map(|ratio| ratio.interval(0.95));
        sheet.push(vec![
            cell.0.to_owned(),
            cell.1.to_string(),
            slug.to_owned(),
            fixed(published.table2(cell.0, cell.1, slug), 2),
            fixed(published.ratio_to_gs(cell.0, cell.1, slug), 4),
            format!("{median:.1}"),
            fixed(ratio.map(|ratio| ratio.median.exp()), 5),
            fixed(interval.map(|(low, _)| low.exp()), 5),
            fixed(interval.map(|(_, high)| high.exp()), 5),
            fixed(a_point(records, cell, slug, |row| row.orientations), 5),
            fixed(a_point(records, cell, slug, |row| row.questions()), 5),
            fixed(
                count_ratio(records, cell, slug, "gs", CountRow::questions)
                    .map(|ratio| ratio.ratio()),
                5,
            ),
        ]);
    }
}
