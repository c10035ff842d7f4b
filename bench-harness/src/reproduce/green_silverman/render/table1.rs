//! Table 1: how the tolerance must be chosen.

use crate::reproduce::green_silverman::published::Published;
use crate::reproduce::green_silverman::records::{Records, ToleranceRow};
use crate::reproduce::green_silverman::verdicts::{limit_from_above, limit_from_below};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use crate::stats::wilson;
use anyhow::Result;
use std::collections::BTreeMap;

const INTRODUCTION: &str = "\
The powers of ten for which a complete peeling of 100 points, areas below ε counted as zero, is right. Each share
is over many data sets, with its 95 % Wilson interval in `table1.csv`.

Right means, for **random** data, what exact answers give. For the **lattice**, a 10 by 10 lattice of the unit
square turned by a random angle (about the origin; `fitted`: and then fitted into the unit square), it means the rings of 36, 28, 20, 12 and 4 points that the lattice had before it
was turned: its coordinates are rounded, so that this is the intended answer and not the exact one for the points
as given. `f32`, `f64` and `extended` are today's formats; `ibm370` and `cdc7600` emulate the machines of the
paper: six hexadecimal digits, and 48 bits, both truncated.

The paper prints no coordinates for its lattice. Turned about the origin, a lattice has coordinates from -1 to √2;
fitted into the unit square it lies where the paper's random data lie, and is taken for the paper's. That choice was
made after the first runs with the other, which is shown too: the limit of the IBM row depends on it. `decimals` is
the number to which the coordinates were rounded before anything else.

";

/// The rows of one kind of data in one format.
type Groups<'a> = BTreeMap<(String, Option<u32>, String), Vec<&'a ToleranceRow>>;

/// Writes `table1.md` and `table1.csv`.
pub(crate) fn write(folder: &Folder, records: &Records, published: &Published) -> Result<()> {
    let mut groups = Groups::new();
    for row in &records.own.tolerance {
        groups
            .entry((row.data.clone(), row.decimals, row.format.clone()))
            .or_default()
            .push(row);
    }
    let body = format!(
        "{INTRODUCTION}## The printed limits beside ours\n\n{}\n## Share of data sets peeled right\n\n{}\n{}",
        limits(&groups, published).markdown(),
        shares(&groups).markdown(),
        control(records),
    );
    folder.markdown("table1.md", "Table 1: the tolerance", &body)?;
    folder.csv("table1.csv", &long(&groups).csv())
}

/// For each printed row, how often each power of ten is the limit of a data set of ours.
fn limits(groups: &Groups<'_>, published: &Published) -> Sheet {
    let mut sheet = Sheet::new(&[
        "data",
        "machine",
        "printed",
        "format",
        "decimals",
        "our limits (share of sets)",
    ]);
    for row in &published.table1 {
        for ((data, decimals, format), sweeps) in groups
            .iter()
            .filter(|((data, ..), _)| data.strip_suffix("-fitted").unwrap_or(data) == row.data)
        {
            if *format != row.format {
                continue;
            }
            let limit = if row.data == "random" {
                limit_from_above
            } else {
                limit_from_below
            };
            sheet.push(vec![
                data.clone(),
                row.machine.clone(),
                format!("{} 1e{}", row.fails, row.exponent),
                format.clone(),
                decimals.map_or_else(|| "all".to_owned(), |decimals| decimals.to_string()),
                distribution(sweeps, limit),
            ]);
        }
    }
    sheet
}

/// The limits found, most frequent first.
fn distribution(sweeps: &[&ToleranceRow], limit: fn(&str) -> Option<i32>) -> String {
    let mut found: BTreeMap<Option<i32>, usize> = BTreeMap::new();
    for row in sweeps {
        *found.entry(limit(&row.outcomes)).or_default() += 1;
    }
    let mut found: Vec<_> = found.into_iter().collect();
    found.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let text = |(limit, count): &(Option<i32>, usize)| {
        let limit = limit.map_or_else(|| "none".to_owned(), |exponent| format!("1e{exponent}"));
        format!("{limit} ({:.3})", *count as f64 / sweeps.len() as f64)
    };
    found.iter().map(text).collect::<Vec<_>>().join(", ")
}

/// One row for each kind of data and format, one column for each ε.
fn shares(groups: &Groups<'_>) -> Sheet {
    let powers = groups
        .values()
        .flatten()
        .map(|row| row.outcomes.len())
        .max()
        .unwrap_or(0);
    let names: Vec<String> = (1..=powers).map(|power| format!("1e-{power}")).collect();
    let mut columns = vec!["data", "decimals", "format", "sets"];
    columns.extend(names.iter().map(String::as_str));
    let mut sheet = Sheet::new(&columns);
    for ((data, decimals, format), sweeps) in groups {
        let mut row = vec![
            data.clone(),
            decimals.map_or_else(|| "all".to_owned(), |decimals| decimals.to_string()),
            format.clone(),
            sweeps.len().to_string(),
        ];
        row.extend((0..powers).map(|place| share(sweeps, place)));
        sheet.push(row);
    }
    sheet
}

fn right(sweeps: &[&ToleranceRow], place: usize) -> usize {
    sweeps
        .iter()
        .filter(|row| row.outcomes.chars().nth(place) == Some('r'))
        .count()
}

/// All and nothing in words, so that the eye finds the borders.
fn share(sweeps: &[&ToleranceRow], place: usize) -> String {
    match right(sweeps, place) {
        0 => "·".to_owned(),
        hits if hits == sweeps.len() => "all".to_owned(),
        hits => format!("{:.3}", hits as f64 / sweeps.len() as f64),
    }
}

/// Every share with its interval, and how the others went wrong.
fn long(groups: &Groups<'_>) -> Sheet {
    let mut sheet = Sheet::new(&[
        "data",
        "decimals",
        "format",
        "epsilon_exponent",
        "sets",
        "right",
        "wrong",
        "contradiction",
        "low",
        "high",
    ]);
    for ((data, decimals, format), sweeps) in groups {
        let powers = sweeps.first().map_or(0, |row| row.outcomes.len());
        for place in 0..powers {
            let count = |letter| {
                sweeps
                    .iter()
                    .filter(|row| row.outcomes.chars().nth(place) == Some(letter))
                    .count()
            };
            let (low, high) = wilson::interval(count('r'), sweeps.len());
            sheet.push(vec![
                data.clone(),
                decimals.map_or_else(String::new, |decimals| decimals.to_string()),
                format.clone(),
                format!("-{}", place + 1),
                sweeps.len().to_string(),
                count('r').to_string(),
                count('w').to_string(),
                count('c').to_string(),
                format!("{low:.4}"),
                format!("{high:.4}"),
            ]);
        }
    }
    sheet
}

/// What exact answers give.
fn control(records: &Records) -> String {
    let mut sheet = Sheet::new(&["lattice", "convention", "method", "rings", "certified"]);
    for row in &records.own.rings {
        sheet.push(vec![
            row.distribution.clone(),
            row.boundary.clone(),
            row.method.clone(),
            row.rings.clone(),
            if row.certified {
                "yes".to_owned()
            } else {
                "NO".to_owned()
            },
        ]);
    }
    let failures = records
        .failures
        .iter()
        .filter(|row| row.stage == "tolerance")
        .count();
    let turned = records
        .own
        .tolerance
        .iter()
        .filter(|row| {
            row.data.starts_with("lattice") && row.data != "lattice-eddy" && row.format == "f64"
        })
        .count();
    format!(
        "## Control: exact answers, no tolerance\n\nOf {turned} turned lattices, as rounded, {failures} were peeled \
         without a certificate. Lattices whose coordinates are exact:\n\n{}",
        sheet.markdown()
    )
}
