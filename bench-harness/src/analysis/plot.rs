//! Growth and ratios as drawings: one chart a point set and question.
//!
//! - time against n, with the fit of the declared law and the sizes at which the points fill a cache;
//! - each count against n, with the fit of the declared law;
//! - the ratio of each engine to the fastest one at the largest size, with 95 % intervals and the A/A band.

use super::band::Band;
use super::compare::Comparison;
use super::fit::{Fits, Fitted, Quantity, fills, fit};
use super::typical_time;
use crate::output::plot::{Chart, Marks, PALETTE, Scale, Series, Stroke, draw_marked};
use crate::records::{Case, Run};
use crate::stats::growth::{Law, Observation};
use crate::stats::summary::median;
use anyhow::Result;
use std::collections::{BTreeMap, BTreeSet};

/// A drawing.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// A name for its file, without the extension.
    pub name: String,
    /// What it shows, in words.
    pub caption: String,
    /// At how many sizes: one is no growth.
    pub sizes: usize,
    /// SVG.
    pub svg: String,
}

/// All drawings of a run; counts of `counters`.
///
/// # Errors
///
/// A fault of the drawing.
pub fn plot(run: &Run, counters: &[String]) -> Result<Vec<Drawing>> {
    let mut quantities = vec![Quantity::Time];
    quantities.extend(counters.iter().cloned().map(Quantity::Counter));
    let mut drawings = Vec::new();
    for quantity in &quantities {
        drawings.extend(growth(run, &fit(run, quantity, &(0..=usize::MAX)))?);
    }
    drawings.extend(ratios(run)?);
    Ok(drawings)
}

/// One chart a point set: a line an engine, and the fit of its law, if one is declared.
///
/// # Errors
///
/// A fault of the drawing.
pub fn growth(run: &Run, fits: &Fits) -> Result<Vec<Drawing>> {
    let mut by_set: BTreeMap<(&str, &str), Vec<&Fitted>> = BTreeMap::new();
    for fitted in &fits.fitted {
        let key = (fitted.definition.as_str(), fitted.set.as_str());
        by_set.entry(key).or_default().push(fitted);
    }
    let quantity = fits.quantity.name();
    let mut drawings = Vec::new();
    for ((definition, set), engines) in by_set {
        let mut series = Vec::new();
        for (fitted, (colour, stroke)) in engines.iter().zip(styles()) {
            let law = fitted.law();
            series.push(Series {
                label: law.map_or_else(
                    || fitted.engine.clone(),
                    |law| format!("{}: {law}", fitted.engine),
                ),
                colour,
                stroke,
                points: medians(&fitted.data, |place| Some(place.cost)),
            });
            series.extend(law.map(|law| Series {
                label: String::new(),
                colour,
                stroke: Stroke::Thin,
                points: fitted_curve(fitted, law),
            }));
        }
        let marks = Marks {
            borders: match fits.quantity {
                Quantity::Time => cache_marks(run, set),
                Quantity::Counter(_) => Vec::new(),
            },
            ..Marks::default()
        };
        let title = format!("{definition}/{set}");
        let chart = Chart {
            title: &title,
            x: "number of points n",
            y: quantity,
            scale: Scale::Logarithmic,
            series: &series,
        };
        if let Some(svg) = draw_marked(&chart, &marks)? {
            drawings.push(Drawing {
                name: file_name(&["growth", quantity, definition, set]),
                caption: format!("{definition}/{set}: {quantity} against n, both axes logarithmic"),
                sizes: sizes(&series),
                svg,
            });
        }
    }
    Ok(drawings)
}

fn fitted_curve(fitted: &Fitted, law: Law) -> Vec<(f64, f64)> {
    let found = fitted.choice.candidates.iter().find(|c| c.fit.law == law);
    found.map_or_else(Vec::new, |candidate| {
        medians(&fitted.data, |place| candidate.fit.at(place))
    })
}

/// The median at each size of what `of` says.
fn medians(data: &[Observation], of: impl Fn(&Observation) -> Option<f64>) -> Vec<(f64, f64)> {
    let mut data = data.to_vec();
    data.sort_unstable_by(|a, b| a.n.total_cmp(&b.n));
    let groups = data.chunk_by(|a, b| a.n.total_cmp(&b.n).is_eq());
    let middle = |group: &[Observation]| {
        let values: Vec<f64> = group.iter().filter_map(&of).collect();
        (group[0].n, median(&values))
    };
    groups
        .map(middle)
        .filter(|(_, value)| *value > 0.0)
        .collect()
}

fn cache_marks(run: &Run, set: &str) -> Vec<(f64, String)> {
    let caches = run.manifest.caches.iter();
    caches
        .map(|cache| (fills(cache, set), format!("L{}", cache.level)))
        .collect()
}

/// One chart a point set: each engine over the fastest at the largest size.
///
/// # Errors
///
/// A fault of the drawing.
pub fn ratios(run: &Run) -> Result<Vec<Drawing>> {
    let band = Band::of(&[run]);
    let mut drawings = Vec::new();
    let all = run.cases();
    let sets: BTreeSet<(&str, &str)> = all
        .iter()
        .map(|case| (case.definition.as_str(), case.set.as_str()))
        .collect();
    for (definition, set) in sets {
        let of_set = all
            .iter()
            .filter(|case| case.definition == definition && case.set == set && case.n > 0);
        let cases: Vec<&Case> = of_set.copied().collect();
        let Some(baseline) = fastest_at_the_end(run, &cases) else {
            continue;
        };
        let (series, intervals) = ratio_lines(run, &cases, &baseline);
        let marks = Marks {
            borders: Vec::new(),
            levels: vec![(-band.half_width).exp(), 1.0, band.half_width.exp()],
            intervals,
        };
        let (title, y) = (
            format!("{definition}/{set}, with 95 % intervals and the A/A band"),
            format!("time over that of {baseline}"),
        );
        let chart = Chart {
            title: &title,
            x: "number of points n",
            y: &y,
            scale: Scale::Logarithmic,
            series: &series,
        };
        if let Some(svg) = draw_marked(&chart, &marks)? {
            drawings.push(Drawing {
                name: file_name(&["ratio", definition, set]),
                caption: format!("{definition}/{set}: {y}, with 95 % intervals and the A/A band"),
                sizes: sizes(&series),
                svg,
            });
        }
    }
    Ok(drawings)
}

fn fastest_at_the_end(run: &Run, cases: &[&Case]) -> Option<String> {
    let last = cases
        .iter()
        .rev()
        .find(|case| !run.timed(case).is_empty())?;
    let time = |engine: &&str| typical_time(run, last, engine).unwrap_or(f64::INFINITY);
    let engines = run.timed(last).into_iter();
    let found = engines.min_by(|a, b| time(a).total_cmp(&time(b)));
    found.map(str::to_owned)
}

type Interval = (f64, f64, f64, plotters::style::RGBColor);

fn ratio_lines(run: &Run, cases: &[&Case], baseline: &str) -> (Vec<Series>, Vec<Interval>) {
    let engines: BTreeSet<&str> = cases.iter().flat_map(|case| run.timed(case)).collect();
    let mut intervals = Vec::new();
    let mut series = Vec::new();
    let others = engines.into_iter().filter(|engine| *engine != baseline);
    for (engine, (colour, stroke)) in others.zip(styles()) {
        let mut points = Vec::new();
        for case in cases {
            if let Some(compared) = Comparison::of(run, case, engine, baseline) {
                let (low, high) = compared.log.interval(0.95);
                let n = case.n as f64;
                points.push((n, compared.log.median.exp()));
                intervals.push((n, low.exp(), high.exp(), colour));
            }
        }
        series.push(Series {
            label: engine.to_owned(),
            colour,
            stroke,
            points,
        });
    }
    (series, intervals)
}

/// Colours and strokes, all different as long as there are enough.
fn styles() -> impl Iterator<Item = (plotters::style::RGBColor, Stroke)> {
    let strokes = [Stroke::Solid, Stroke::Dashed].into_iter();
    let each = strokes.flat_map(|stroke| PALETTE.into_iter().map(move |colour| (colour, stroke)));
    each.collect::<Vec<_>>().into_iter().cycle()
}

/// At how many different n there is a point.
fn sizes(series: &[Series]) -> usize {
    let points = series.iter().flat_map(|series| &series.points);
    points
        .map(|(n, _)| n.to_bits())
        .collect::<BTreeSet<u64>>()
        .len()
}

/// A name that any file system takes.
fn file_name(parts: &[&str]) -> String {
    let plain = |c: char| {
        if c.is_ascii_alphanumeric() || matches!(c, '.' | '_') {
            c
        } else {
            '-'
        }
    };
    parts.join("-").chars().map(plain).collect()
}
