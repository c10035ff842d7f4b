//! Which formats are right at which eps2, where that ends, and how fast they are.

use super::figure::Figure;
use super::share;
use crate::reproduce::day::derived::{Setting, powers, settings, speed_ratio, threshold};
use crate::reproduce::day::records::{ControlRow, Records};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{PALETTE, Scale, Series, Stroke};
use crate::reproduce::render::sheet::{Sheet, duration};
use crate::reproduce::verdict::ratio_text;
use crate::stats::summary::median;
use anyhow::Result;

const INTRODUCTION: &str = "\
Day's merge with his cotangents in several number formats, over powers of ten of eps2. A run is *right* if its faces are
the surface of the certified hull of the points as the format holds them. Else it ends with a *wrong hull*, a closed
surface that is not it; or it is *endless*, stopped after twenty times as many steps as there can be faces; or it comes
upon faces that do not fit together, *dangling*, as where the paper's program dereferences nil. Shares come with Wilson's
intervals at 95 %. Coordinates are range times a uniform number from 0 to 1, plus the offset.

![Share right against eps2](precision.svg)

";

const THRESHOLDS: &str = "
# Where it ends

The eps2 at which the share right falls to a half, by Firth's logistic regression from the power with the largest share
on, with 95 % intervals; none if no more than half are right at any power, or if the share never falls. *Control* is the
share of sets that the exact method gets right, *general* the share of them whose hull has triangles only.

";

const SPEED: &str = "
# Time

Day's merge in each format on the same sets. What a program computes bit for bit says nothing of a machine that has the
format; it is here because it is what the study costs.

";

/// Writes `precision.md`, `precision.svg` and `.csv`, `outcomes.csv`, `thresholds.csv` and `formats.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    figure(folder, records)?;
    let (outcomes, thresholds, speed) = (outcomes(records), thresholds(records), speed(records));
    let body = INTRODUCTION.to_owned()
        + &shares(records).markdown()
        + THRESHOLDS
        + &thresholds.markdown()
        + SPEED
        + &speed.markdown();
    folder.markdown("precision.md", "Precision and eps2", &body)?;
    folder.csv("outcomes.csv", &outcomes.csv())?;
    folder.csv("thresholds.csv", &thresholds.csv())?;
    folder.csv("formats.csv", &speed.csv())
}

fn name(setting: &Setting<'_>) -> [String; 4] {
    [
        setting.n.to_string(),
        format!("{:e}", setting.range),
        format!("{:e}", setting.offset),
        setting.format.to_owned(),
    ]
}

/// In the unit cube: right of all, a row a power, a column a format and size.
fn shares(records: &Records) -> Sheet {
    let plain: Vec<Setting<'_>> = settings(records)
        .into_iter()
        .filter(Setting::is_plain)
        .collect();
    let heads: Vec<String> = plain
        .iter()
        .map(|setting| format!("{}, n = {}", setting.format, setting.n))
        .collect();
    let columns = std::iter::once("eps2").chain(heads.iter().map(String::as_str));
    let mut sheet = Sheet::new(&columns.collect::<Vec<_>>());
    let rows = records.own.precision.iter();
    let mut all: Vec<i32> = rows.map(|row| row.power).collect();
    all.sort_unstable();
    all.dedup();
    for power in all {
        let cell = |setting: &Setting<'_>| {
            let rows = powers(records, *setting);
            let row = rows.iter().find(|row| row.power == power);
            row.map_or_else(String::new, |row| share(row.right, row.sets))
        };
        let cells = std::iter::once(format!("1e{power}")).chain(plain.iter().map(cell));
        sheet.push(cells.collect());
    }
    sheet
}

/// Every end of every setting.
fn outcomes(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "n", "range", "offset", "format", "bits", "power", "sets", "right", "wrong", "endless",
        "dangling", "share",
    ]);
    for row in &records.own.precision {
        let mut cells = vec![
            row.n.to_string(),
            row.range.to_string(),
            row.offset.to_string(),
            row.format.clone(),
            row.bits.to_string(),
            row.power.to_string(),
        ];
        let counts = [row.sets, row.right, row.wrong, row.endless, row.dangling];
        cells.extend(counts.map(|count| count.to_string()));
        cells.push(share(row.right, row.sets));
        sheet.push(cells);
    }
    sheet
}

fn thresholds(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "n",
        "range",
        "offset",
        "format",
        "bits",
        "sets",
        "half at, log10",
        "control",
        "general",
    ]);
    for setting in settings(records) {
        let half = threshold(records, setting).map_or_else(
            || "none".to_owned(),
            |curve| {
                let error = 1.96 * curve.half_error;
                let (low, high) = (curve.half - error, curve.half + error);
                format!("{:.2} [{low:.2}, {high:.2}]", curve.half)
            },
        );
        let is_same = |row: &&ControlRow| {
            let place = (row.n, row.format.as_str()) == (setting.n, setting.format);
            place && [row.range, row.offset] == [setting.range, setting.offset]
        };
        let controls = || records.own.controls.iter().filter(is_same);
        let sets: usize = controls().map(|row| row.sets).sum();
        let right = controls().map(|row| row.right).sum();
        let general = controls().map(|row| row.general).sum();
        let mut cells = name(&setting).to_vec();
        cells.extend([
            setting.bits.to_string(),
            sets.to_string(),
            half,
            share(right, sets),
            share(general, right),
        ]);
        sheet.push(cells);
    }
    sheet
}

fn speed(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&["format", "computed by", "median", "over f64"]);
    let mut formats: Vec<&str> = Vec::new();
    for row in &records.own.speed {
        if formats.contains(&row.format.as_str()) {
            continue;
        }
        formats.push(&row.format);
        let own = records
            .own
            .speed
            .iter()
            .filter(|other| other.format == row.format);
        let times: Vec<f64> = own
            .map(|row| row.nanoseconds as f64 / row.calls as f64)
            .collect();
        let ratio = speed_ratio(records, &row.format, "f64");
        sheet.push(vec![
            row.format.clone(),
            format!("{:?}", row.arithmetic).to_lowercase(),
            duration(median(&times)),
            ratio.map_or_else(String::new, |ratio| {
                ratio_text(ratio.median, ratio.interval(0.95))
            }),
        ]);
    }
    sheet
}

fn figure(folder: &Folder, records: &Records) -> Result<()> {
    let plain = settings(records)
        .into_iter()
        .filter(Setting::is_plain)
        .collect::<Vec<_>>();
    let mut sizes: Vec<usize> = plain.iter().map(|setting| setting.n).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut formats: Vec<&str> = Vec::new();
    let mut series = Vec::new();
    // More would not be told apart: solid is the smallest size, dashed the next.
    for setting in plain
        .iter()
        .filter(|setting| sizes.iter().take(2).any(|n| *n == setting.n))
    {
        if !formats.contains(&setting.format) {
            formats.push(setting.format);
        }
        let colour = formats.iter().position(|format| *format == setting.format);
        let rows = powers(records, *setting);
        series.push(Series {
            label: format!("{}, {}", setting.format, setting.n),
            colour: PALETTE[colour.unwrap_or(0) % PALETTE.len()],
            stroke: if setting.n == sizes[0] {
                Stroke::Solid
            } else {
                Stroke::Dashed
            },
            points: rows
                .iter()
                .map(|row| {
                    let share = row.right as f64 / row.sets.max(1) as f64;
                    (10_f64.powi(row.power), 100.0 * share)
                })
                .collect(),
        });
    }
    let figure = Figure {
        name: "precision",
        title: "Right hulls with rounded cotangents, by format and number of points",
        x: "eps2",
        y: "percent of sets",
        scale: Scale::Linear,
    };
    figure.write(folder, series)
}
