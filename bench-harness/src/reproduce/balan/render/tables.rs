//! The table that the paper does not print, in two: what each method asks and makes, and how long it takes.

use crate::reproduce::balan::derived::{BASE, TWIN};
use crate::reproduce::balan::derived::{Cell, hull_sizes, plane_tests, runs, triangles};
use crate::reproduce::balan::published::{Comparison, DISTRIBUTIONS, KIN, PROGRAMS, TWINS, slugs};
use crate::reproduce::balan::records::Records;
use crate::reproduce::ratio::{median_time, time_ratio, timed_cells};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::{Sheet, duration, fixed};
use crate::reproduce::rows::CountRow;
use crate::reproduce::verdict::ratio_text;
use crate::stats::summary::mean;
use anyhow::Result;

const COUNTS: &str = "\
Means over the sets of a cell, exact integers each. *Orientations* are all questions on which side of a plane a point
lies, set-up and the merging of coplanar facets included; *plane tests* are those of the search alone, which is without
one for each edge at the end. *Facets made* and *dropped* are triangles. h vertices and F facets are those of the
certified hull, coplanar triangles merged. Every result was certified first.

";

const TIMES: &str = "\
Median time of one call, every result certified, methods interleaved and warm; in brackets the ratio to `quickhull-3d`,
median of the rounds with its interval at 95 %. An empty cell was too slow to time. h and F are means over the sets.
All are written in one language, with the same exact kernel: what differs is the method.

";

/// Writes `counts.md` and `counts.csv`.
pub(crate) fn write_counts(folder: &Folder, records: &Records) -> Result<()> {
    let mut sheet = Sheet::new(&[
        "distribution",
        "n",
        "h",
        "F",
        "method",
        "sets",
        "orientations",
        "plane tests",
        "heights",
        "shadows",
        "comparisons",
        "candidates",
        "facets made",
        "facets dropped",
        "beyond filter",
    ]);
    for (distribution, n) in counted_cells(records) {
        let (vertices, facets) =
            hull_sizes(records, "counts", (distribution, n)).unwrap_or_default();
        for slug in slugs() {
            let rows: Vec<&CountRow> = runs(records, distribution, slug)
                .filter(|row| row.n == n)
                .collect();
            if rows.is_empty() {
                continue;
            }
            let average = |of: &dyn Fn(&CountRow) -> f64| {
                whole(mean(&rows.iter().map(|row| of(row)).collect::<Vec<f64>>()))
            };
            let tests = match slug {
                "pivot-wrap" | "nathan" => String::new(),
                _ => average(&plane_tests),
            };
            sheet.push(vec![
                distribution.to_owned(),
                n.to_string(),
                whole(vertices),
                whole(facets),
                slug.to_owned(),
                rows.len().to_string(),
                average(&|row| row.orientations as f64),
                tests,
                average(&|row| row.heights as f64),
                average(&|row| row.shadows as f64),
                average(&|row| row.lexicographic as f64),
                average(&|row| row.candidates as f64),
                average(&|row| row.facets as f64),
                average(&|row| (row.facets - triangles(row)) as f64),
                average(&|row| row.beyond_filter as f64),
            ]);
        }
    }
    let body = COUNTS.to_owned() + &key() + &sheet.markdown();
    folder.markdown("counts.md", "Questions asked and facets made", &body)?;
    folder.csv("counts.csv", &sheet.csv())
}

/// The table's cells, in its order.
fn counted_cells(records: &Records) -> Vec<Cell<'static>> {
    let mut cells = Vec::new();
    for distribution in DISTRIBUTIONS {
        let rows = records
            .counts
            .iter()
            .filter(|row| row.distribution == distribution);
        let mut sizes: Vec<usize> = rows.map(|row| row.n).collect();
        sizes.sort_unstable();
        sizes.dedup();
        cells.extend(sizes.into_iter().map(|n| (distribution, n)));
    }
    cells
}

/// Which slug is which program.
fn key() -> String {
    let mut text = String::new();
    for ((slug, name), (twin, what)) in PROGRAMS.into_iter().zip(TWINS) {
        text += &format!("- the paper's {name}: `{slug}`; beside it `{twin}` ({what})\n");
    }
    for (slug, name) in KIN {
        text += &format!("- for comparison: `{slug}` ({name})\n");
    }
    text + "\n"
}

/// Writes `times.md` and `times.csv`.
pub(crate) fn write_times(
    folder: &Folder,
    records: &Records,
    comparisons: &[Comparison],
) -> Result<()> {
    let mut columns = vec!["distribution", "n", "h", "F"];
    columns.extend(slugs());
    columns.push(TWIN);
    let mut sheet = Sheet::new(&columns);
    for (distribution, n) in timed_cells(&records.times) {
        let cell = (distribution.as_str(), n);
        let (vertices, facets) = hull_sizes(records, "times", cell).unwrap_or_default();
        let mut row = vec![
            distribution.clone(),
            n.to_string(),
            whole(vertices),
            whole(facets),
        ];
        row.extend(slugs().chain([TWIN]).map(|slug| time(records, cell, slug)));
        sheet.push(row);
    }
    let body = format!(
        "{TIMES}{}{}{}",
        key(),
        sheet.markdown(),
        beside(records, comparisons)
    );
    folder.markdown("times.md", "Times", &body)?;
    folder.csv("times.csv", &long_times(records).csv())
}

fn time(records: &Records, cell: Cell<'_>, slug: &str) -> String {
    let Some(median) = median_time(&records.times, cell, slug) else {
        return String::new();
    };
    match time_ratio(&records.times, cell, slug, BASE) {
        Some(ratio) if slug != BASE => {
            let text = ratio_text(ratio.median, ratio.interval(0.95));
            format!("{} ({text})", duration(median))
        }
        _ => duration(median),
    }
}

fn long_times(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "distribution",
        "n",
        "method",
        "nanoseconds_median",
        "ratio",
        "ratio_low",
        "ratio_high",
    ]);
    for (distribution, n) in timed_cells(&records.times) {
        let cell = (distribution.as_str(), n);
        for slug in slugs().chain([TWIN]) {
            let Some(median) = median_time(&records.times, cell, slug) else {
                continue;
            };
            let ratio = time_ratio(&records.times, cell, slug, BASE);
            let interval = ratio.as_ref().map(|ratio| ratio.interval(0.95));
            sheet.push(vec![
                distribution.clone(),
                n.to_string(),
                slug.to_owned(),
                format!("{median:.0}"),
                fixed(ratio.as_ref().map(|ratio| ratio.median.exp()), 4),
                fixed(interval.map(|(low, _)| low.exp()), 4),
                fixed(interval.map(|(_, high)| high.exp()), 4),
            ]);
        }
    }
    sheet
}

/// What others found of programs of these kinds, and what we find of ours.
fn beside(records: &Records, comparisons: &[Comparison]) -> String {
    let mut sheet = Sheet::new(&[
        "source",
        "slower",
        "faster",
        "input",
        "n",
        "ratio",
        "ours",
        "our n",
        "our ratio",
    ]);
    for comparison in comparisons {
        let cells = timed_cells(&records.times);
        let sizes = cells
            .iter()
            .filter(|(distribution, _)| *distribution == comparison.distribution)
            .map(|(_, n)| *n);
        let ours = |n: usize| {
            let cell = (comparison.distribution.as_str(), n);
            let ratio = time_ratio(
                &records.times,
                cell,
                &comparison.our_slower,
                &comparison.our_faster,
            )?;
            Some((n, ratio_text(ratio.median, ratio.interval(0.95))))
        };
        let Some((n, ratio)) = sizes.filter_map(ours).max_by_key(|(n, _)| *n) else {
            continue;
        };
        sheet.push(vec![
            comparison.source.clone(),
            comparison.slower.clone(),
            comparison.faster.clone(),
            comparison.input.clone(),
            comparison.n.to_string(),
            format!(
                "{:.2}",
                comparison.slower_seconds / comparison.faster_seconds
            ),
            format!("{} / {}", comparison.our_slower, comparison.our_faster),
            n.to_string(),
            ratio,
        ]);
    }
    if sheet.is_empty() {
        return String::new();
    }
    format!(
        "\nBeside a published comparison of programs of these kinds (theirs keeps a Delaunay triangulation, ours a conflict \
         graph, so only the order of magnitude can agree):\n\n{}",
        sheet.markdown()
    )
}

/// A count or mean without decimals where it is large.
fn whole(value: f64) -> String {
    if value < 100.0 && value.fract() > 0.0 {
        format!("{value:.1}")
    } else {
        format!("{value:.0}")
    }
}
