//! By which laws times and counts grow.

use crate::analysis::fit::{Fits, Quantity, fit};
use crate::analysis::plot::growth;
use crate::records::{Count, Run};
use crate::report::document::{Entry, Part, Section, Table, answer};
use crate::report::matrix::{matrix, short};
use crate::report::picture::inline;
use crate::report::{Material, command};
use crate::stats::growth::choice::FEWEST_SIZES;
use crate::stats::summary::mean;
use anyhow::Result;
use std::collections::BTreeMap;

/// How the time of a call grows.
pub(in crate::report) fn time(material: &Material<'_>) -> Result<Option<Section>> {
    let run = material.run;
    let fits = fit(run, &Quantity::Time, &(0..=usize::MAX));
    let mut parts = vec![Part::text(
        "Times are the median of a realisation. A vertical line marks the n at which the points fill a cache; across that of L2 \
         or of a larger one no law is declared from time, for there the slope is the machine's.",
    )];
    let found = growing(run, &fits)?;
    let any = !found.is_empty();
    parts.extend(found);
    Ok(any.then(|| Section {
        id: "growth".into(),
        heading: "Growth of time".into(),
        commands: vec![command(run, "fit", "--time"), command(run, "plot", "")],
        parts,
    }))
}

/// How the counts grow.
pub(in crate::report) fn counts(material: &Material<'_>) -> Result<Option<Section>> {
    let run = material.run;
    let mut commands = Vec::new();
    let mut parts = Vec::new();
    for counter in material.counters {
        let tables = mean_counts(run, counter);
        if tables.is_empty() {
            continue;
        }
        parts.push(Part::heading(counter));
        parts.extend(tables.into_iter().map(Part::Table));
        let fits = fit(run, &Quantity::Counter(counter.clone()), &(0..=usize::MAX));
        parts.extend(growing(run, &fits)?);
        commands.push(command(run, "fit", &format!("--counter {counter}")));
        commands.push(command(run, "plot", &format!("--counter {counter}")));
    }
    if parts.is_empty() {
        return Ok(None);
    }
    let others: Vec<&str> = run
        .counters()
        .into_iter()
        .filter(|counter| material.counters.iter().all(|shown| shown != counter))
        .collect();
    let more = match others.is_empty() {
        true => String::new(),
        false => format!(
            " Also counted, and shown with --counter: {}.",
            others.join(", ")
        ),
    };
    let first = format!(
        "Exact integers of separate runs, without a clock: the same on every machine. Each is that of one call; \
         means over the realisations.{more}"
    );
    parts.insert(0, Part::text(first));
    Ok(Some(Section {
        id: "counts".into(),
        heading: "Counts".into(),
        commands,
        parts,
    }))
}

/// Verdicts and drawings, where there is more than one size.
fn growing(run: &Run, fits: &Fits) -> Result<Vec<Part>> {
    let mut parts = Vec::new();
    let drawings = growth(run, fits)?
        .into_iter()
        .filter(|drawing| drawing.sizes > 1);
    let figures: Vec<Part> = drawings
        .map(|drawing| Part::Figure {
            svg: inline(&drawing.svg, &drawing.caption),
            caption: drawing.caption,
        })
        .collect();
    if figures.is_empty() {
        return Ok(parts);
    }
    let page = fits.page();
    let most = fits
        .fitted
        .iter()
        .map(|fitted| fitted.choice.sizes.len())
        .max();
    if most.is_some_and(|sizes| sizes >= FEWEST_SIZES) {
        parts.extend(page.preface.iter().map(Part::text));
        parts.extend(page.sections.first().into_iter().flat_map(answer));
        parts.push(Part::Fold {
            summary: "Every candidate law".into(),
            parts: page.sections.iter().skip(1).flat_map(answer).collect(),
        });
    } else {
        parts.push(Part::text(format!(
            "No law is asked for: that takes {FEWEST_SIZES} sizes or more."
        )));
    }
    parts.extend(figures);
    Ok(parts)
}

/// The mean count, a table a definition.
fn mean_counts(run: &Run, counter: &str) -> Vec<Table> {
    let mut values: BTreeMap<_, Vec<f64>> = BTreeMap::new();
    let of = |count: &&Count| count.counter == counter && count.value > 0;
    for count in run.counts.iter().filter(of) {
        let key = (&count.subject.case, count.subject.engine.as_str());
        values.entry(key).or_default().push(count.value as f64);
    }
    let tables = run.definitions().into_iter().filter_map(|id| {
        matrix(run, id, &format!("{id}: {counter}"), |case, engine| {
            let counts = values.get(&(case, engine))?;
            Some(Entry::new(&short(mean(counts))))
        })
    });
    tables.collect()
}
