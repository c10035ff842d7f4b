//! The whole call: questions and times, by one processor and by all.

use super::figure::Figure;
use crate::records::rows::twin;
use crate::reproduce::day::derived::{in_order, times};
use crate::reproduce::day::laws::compare;
use crate::reproduce::day::records::Records;
use crate::reproduce::day::studies::METHOD;
use crate::reproduce::day::studies::PARALLEL;
use crate::reproduce::ratio::{median_time, time_ratio};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::plot::{PALETTE, Scale, Series, Stroke};
use crate::reproduce::render::sheet::{Sheet, duration, fixed};
use crate::reproduce::space::growth::{against_n, groups, means, questions};
use crate::reproduce::verdict::ratio_text;
use crate::stats::summary::mean;
use anyhow::Result;

const QUESTIONS: &str = "\
All questions of the whole call a point, exact integers: orientations of four points and of shadows, and lexicographic
comparisons of the sort. A cost of n log n is a straight line in the figure, whose axis of n is logarithmic. The laws y = a
f(n) + b n are fitted by least squares of the logarithm; *ahead* is the error at the upper 30 % of the sizes of a fit
to the others. A law is *left* unless both its criterion (AICc, by more than ten) and its foresight are worse than the best
one's.

![Questions a point](whole.svg)

";

const TIMES: &str = "
# Times

Median time of one call, every result certified, interleaved and warm. Side by side, halves of more than 4096 points are
conquered on all processors of this machine; the ratio is to one after the other, median of the rounds with its interval at
95 %. *Against itself* is the noise.

";

/// Writes `whole.md`, `whole.svg` and `.csv`, `laws.csv` and `whole-times.csv`.
pub(crate) fn write(folder: &Folder, records: &Records) -> Result<()> {
    let names = in_order(records.counts.iter().map(|row| &row.distribution));
    let series = names.iter().zip(PALETTE).map(|(name, colour)| {
        let rows = records
            .counts
            .iter()
            .filter(|row| row.distribution == *name);
        Series {
            label: (*name).to_owned(),
            colour,
            stroke: Stroke::Solid,
            points: means(&against_n(rows, |row| questions(row) / row.n as f64)),
        }
    });
    let figure = Figure {
        name: "whole",
        title: "All questions a point: n log n is a straight line",
        x: "number of points n",
        y: "questions a point",
        scale: Scale::Linear,
    };
    figure.write(folder, series.collect())?;
    let (counts, laws) = (counts(records, &names), laws(records, &names));
    let times = write_times_sheet(records);
    let body = format!(
        "{QUESTIONS}{}\n# Laws\n\n{}{TIMES}{}",
        counts.markdown(),
        laws.markdown(),
        times.markdown()
    );
    folder.markdown("whole.md", "The whole call", &body)?;
    folder.csv("laws.csv", &laws.csv())?;
    folder.csv("whole-times.csv", &times.csv())
}

/// Questions a point, a row a size.
fn counts(records: &Records, names: &[&str]) -> Sheet {
    let mut sheet = Sheet::new(&["set", "n", "sets", "questions a point", "over n ln n"]);
    for name in names {
        let rows = records
            .counts
            .iter()
            .filter(|row| row.distribution == *name);
        for (n, values) in groups(&against_n(rows, questions)) {
            let asked = mean(&values);
            sheet.push(vec![
                (*name).to_owned(),
                n.to_string(),
                values.len().to_string(),
                format!("{:.3}", asked / n),
                format!("{:.4}", asked / (n * n.ln())),
            ]);
        }
    }
    sheet
}

fn laws(records: &Records, names: &[&str]) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "of",
        "law",
        "factor",
        "linear term",
        "error, %",
        "ahead, %",
        "AICc",
        "left",
    ]);
    let mut add = |name: &str, what: &str, data: &[(f64, f64)]| {
        for model in compare(data) {
            sheet.push(vec![
                name.to_owned(),
                what.to_owned(),
                model.law.to_string(),
                fixed(model.fit.map(|fit| fit.leading), 4),
                fixed(model.fit.map(|fit| fit.correction), 3),
                fixed(model.fit.map(|fit| 100.0 * fit.scatter), 3),
                format!("{:.3}", 100.0 * model.ahead),
                format!("+{:.1}", model.behind),
                if model.ruled_out { "no" } else { "yes" }.to_owned(),
            ]);
        }
    };
    for name in names {
        let rows = records
            .counts
            .iter()
            .filter(|row| row.distribution == *name);
        add(name, "questions", &against_n(rows, questions));
    }
    for name in in_order(records.times.iter().map(|row| &row.distribution)) {
        add(name, "nanoseconds", &times(records, name));
    }
    sheet
}

/// The table of times.
fn write_times_sheet(records: &Records) -> Sheet {
    let mut sheet = Sheet::new(&[
        "set",
        "n",
        "one",
        "a point",
        "side by side",
        "ratio",
        "against itself",
    ]);
    for name in in_order(records.times.iter().map(|row| &row.distribution)) {
        for (n, _) in groups(&times(records, name)) {
            let cell = (name, n as usize);
            let time = |method: &str| median_time(&records.times, cell, method);
            let ratio = |method: &str| {
                let ratio = time_ratio(&records.times, cell, method, METHOD);
                ratio.map_or_else(String::new, |ratio| {
                    ratio_text(ratio.median, ratio.interval(0.95))
                })
            };
            let text = |time: Option<f64>| time.map_or_else(String::new, duration);
            sheet.push(vec![
                name.to_owned(),
                n.to_string(),
                text(time(METHOD)),
                text(time(METHOD).map(|time| time / n)),
                text(time(PARALLEL)),
                ratio(PARALLEL),
                ratio(&twin(METHOD)),
            ]);
        }
    }
    sheet
}
