//! What the merges ask and keep.

use super::figure::Figure;
use crate::reproduce::day::derived::{WORST, largest, merged, of_merges, top};
use crate::reproduce::day::records::{MergeRow, Records};
use crate::reproduce::day::variants;
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{PALETTE, Scale, Series, Stroke};
use crate::reproduce::render::sheet::Sheet;
use crate::reproduce::space::growth::{exponent, groups, means};
use crate::stats::summary::mean;
use anyhow::Result;

const MERGE: &str = "\
Questions about candidate edges at the top merge, each one orientation of four points. *FAN* (`fan`) has a vertex that
recurs n/4 times on the path of the merge, the case of the paper's Figure 18; *turned*, the merge begins elsewhere. *CONE*
has a vertex that stays the pivot throughout. A search is *resumed* where the last one at the vertex stopped, as the paper
has it, or starts *anew at every step*, or *sorts* all edges at every step, as Balan, Munjal and Rao have it. Exponents are
fitted over the two upper decades of n, with intervals at 90 %. Every result was certified first.

![Questions at the top merge](merge.svg)

";

const EDGES: &str = "\
Edge records by the paper's own rule of search. *Made* are those that would be kept if none were freed; *most* is the
largest number in use after any merge if hidden ones are freed; *last* are the edges of the hull, in triangles. Per point,
means over the sets of a cell.

![Edge records made a point](edges.svg)

";

/// Writes `merge.md`, `merge.svg` and `merge.csv`.
pub(crate) fn write_merge(folder: &Folder, records: &Records) -> Result<()> {
    let figure = Figure {
        name: "merge",
        title: "Questions at the top merge: the vertex that recurs, the pivot that stays",
        x: "number of points n",
        y: "questions",
        scale: Scale::Logarithmic,
    };
    let mut series = Vec::new();
    for (distribution, colour) in [WORST[0], WORST[2], "sphere"].into_iter().zip(PALETTE) {
        for (name, stroke) in [("resumed", Stroke::Solid), ("rescanned", Stroke::Dashed)] {
            series.push(Series {
                label: format!("{}, {name}", short(distribution)),
                colour,
                stroke,
                points: means(&top(records, distribution, name)),
            });
        }
    }
    figure.write(folder, series)?;
    let growth = growth(records);
    let body = format!(
        "{MERGE}{}\n# By size\n\n{}",
        growth.markdown(),
        by_size(records).markdown()
    );
    folder.markdown("merge.md", "The merge", &body)?;
    folder.csv("merge-growth.csv", &growth.csv())?;
    folder.csv("merge-sizes.csv", &by_size(records).csv())
}

/// The name of a set without its axis.
fn short(distribution: &str) -> &str {
    distribution.split(':').next().unwrap_or(distribution)
}

fn growth(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "search",
        "exponent",
        "largest n",
        "over n",
        "over n²",
        "a facet of the wrap",
        "looked at again",
    ]);
    for name in variants::NAMES {
        for distribution in merged(records, name) {
            let of =
                |quantity: fn(&MergeRow) -> f64| largest(records, distribution, name, quantity);
            let Some((n, asked)) = of(|row| row.top_candidates as f64) else {
                continue;
            };
            let fitted = exponent(&top(records, distribution, name));
            let value = |found: Option<(f64, f64)>| found.map_or(f64::NAN, |(_, value)| value);
            sheet.push(vec![
                short(distribution).to_owned(),
                variants::words(name).to_owned(),
                fitted.map_or_else(String::new, |exponent| {
                    let (low, high) = exponent.interval;
                    format!("{:.3} [{low:.3}, {high:.3}]", exponent.value)
                }),
                n.to_string(),
                format!("{:.3}", asked / n),
                format!("{:.4}", asked / (n * n)),
                format!(
                    "{:.3}",
                    value(of(
                        |row| row.top_candidates as f64 / row.top_facets.max(1) as f64
                    ))
                ),
                format!("{:.0}", value(of(|row| row.reexamined as f64))),
            ]);
        }
    }
    sheet
}

fn by_size(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "search",
        "n",
        "sets",
        "top merge",
        "facets",
        "all merges",
    ]);
    for name in variants::NAMES {
        for distribution in merged(records, name) {
            let of = |quantity: fn(&MergeRow) -> f64| {
                groups(&of_merges(records, distribution, name, quantity))
            };
            let facets = of(|row| row.top_facets as f64);
            let all = of(|row| row.candidates as f64);
            let tops = of(|row| row.top_candidates as f64);
            for (((n, top), (_, facets)), (_, all)) in tops.into_iter().zip(facets).zip(all) {
                let mut cells = vec![
                    short(distribution).to_owned(),
                    variants::words(name).to_owned(),
                    n.to_string(),
                    top.len().to_string(),
                ];
                cells.extend([&top, &facets, &all].map(|values| format!("{:.0}", mean(values))));
                sheet.push(cells);
            }
        }
    }
    sheet
}

/// Writes `edges.md`, `edges.svg` and `edges.csv`.
pub(crate) fn write_edges(folder: &Folder, records: &Records) -> Result<()> {
    let figure = Figure {
        name: "edges",
        title: "Edge records a point: made in all, and most in use",
        x: "number of points n",
        y: "records a point",
        scale: Scale::Linear,
    };
    let made = |row: &MergeRow| row.edges_made as f64 / row.n as f64;
    let most = |row: &MergeRow| row.edges_most as f64 / row.n as f64;
    let mut series = Vec::new();
    let mut sheet = Sheet::new(&["set", "n", "made", "most", "last", "made over most"]);
    let names = merged(records, "resumed");
    for (distribution, colour) in names.iter().zip(PALETTE.iter().cycle()) {
        let of = |quantity: &dyn Fn(&MergeRow) -> f64| {
            means(&of_merges(records, distribution, "resumed", quantity))
        };
        let (made, most) = (of(&made), of(&most));
        let last = of(&|row| row.edges_last as f64 / row.n as f64);
        let ratio = of(&|row| row.edges_made as f64 / row.edges_most.max(1) as f64);
        for (i, &(n, value)) in made.iter().enumerate() {
            let values = [value, most[i].1, last[i].1, ratio[i].1];
            let mut cells = vec![short(distribution).to_owned(), n.to_string()];
            cells.extend(values.map(|value| format!("{value:.3}")));
            sheet.push(cells);
        }
        if ["sphere", "ball", "normal3"].contains(distribution) {
            for (what, stroke, points) in [
                ("made", Stroke::Solid, made),
                ("most", Stroke::Dashed, most),
            ] {
                series.push(Series {
                    label: format!("{distribution}, {what}"),
                    colour: *colour,
                    stroke,
                    points,
                });
            }
        }
    }
    figure.write(folder, series)?;
    let body = EDGES.to_owned() + &sheet.markdown();
    folder.markdown("edges.md", "Edge records made, and in use", &body)?;
    folder.csv("edge-records.csv", &sheet.csv())
}
