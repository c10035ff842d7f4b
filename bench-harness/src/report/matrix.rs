//! A row a case, a column an engine.

use super::document::{Entry, Table};
use crate::analysis::cmp::{Cmp, Row};
use crate::analysis::h_text;
use crate::output::sheet::duration;
use crate::records::{Case, Outcome, Run};
use std::collections::{BTreeMap, BTreeSet};

/// The columns before those of the engines.
pub const LEAD: [&str; 3] = ["set", "n", "h"];

/// The table of the cases of `definition`: what `value` says of each engine, and where it says nothing, what became of
/// the engine. Engines of which nothing is said have no column; cases of which nothing is said have no row.
pub fn matrix(
    run: &Run,
    definition: &str,
    caption: &str,
    value: impl Fn(&Case, &str) -> Option<Entry>,
) -> Option<Table> {
    let failed = failures(run);
    let of = |case: &&Case| case.definition == definition;
    let cases: Vec<&Case> = run.cases().into_iter().filter(of).collect();
    let named = |case: &Case| -> Vec<&str> {
        let mut engines = run.timed(case);
        engines.extend(run.counted(case));
        engines
    };
    let engines: BTreeSet<&str> = cases.iter().flat_map(|case| named(case)).collect();
    let said = |engine: &&str| cases.iter().any(|case| value(case, engine).is_some());
    let engines: Vec<&str> = engines.into_iter().filter(said).collect();
    let mut columns = LEAD.to_vec();
    columns.extend(&engines);
    let mut table = Table::new(caption, &columns);
    for case in cases {
        let values: Vec<Option<Entry>> = engines.iter().map(|name| value(case, name)).collect();
        if values.iter().all(Option::is_none) {
            continue;
        }
        let shown = values.into_iter().zip(&engines).map(|(entry, engine)| {
            let outcome = failed.get(&(case, *engine));
            let instead = || outcome.map(|outcome| Entry::failed(outcome.to_string()));
            entry.or_else(instead).unwrap_or_else(|| Entry::new(""))
        });
        let lead = [case.set.clone(), case.n.to_string(), h_text(run.h(case))];
        let lead = lead.iter().map(|text| Entry::new(text));
        table.rows.push(lead.chain(shown).collect());
    }
    (!table.rows.is_empty()).then_some(table)
}

/// The times of `definition`, each over that of the baseline of its case; the baseline's own time stands beside its
/// one. Bold: the baseline's equals inside the A/A band, or better.
pub fn ratios(run: &Run, cmp: &Cmp, definition: &str) -> Option<Table> {
    let rows: BTreeMap<(&Case, &str), &Row> = cmp
        .rows
        .iter()
        .map(|row| ((&row.case, row.engine.as_str()), row))
        .collect();
    let best = cmp.band.half_width.exp();
    let entry = |case: &Case, engine: &str| {
        let row = rows.get(&(case, engine))?;
        let ratio = row.ratio.map_or(1.0, |ratio| ratio.ratio);
        let text = match row.engine == row.baseline {
            true => format!("1 ({})", duration(row.nanoseconds)),
            false => short(ratio),
        };
        let mut entry = Entry::new(&text);
        entry.strong = ratio <= best;
        Some(entry)
    };
    matrix(
        run,
        definition,
        &format!("{definition}: time over that of the baseline"),
        entry,
    )
}

/// Three significant digits.
pub fn short(value: f64) -> String {
    let digits = 2_usize.saturating_sub(value.abs().max(1.0).log10().floor() as usize);
    format!("{value:.digits$}")
}

/// What became of engines on cases, where it was no certificate.
fn failures(run: &Run) -> BTreeMap<(&Case, &str), Outcome> {
    let failed = run
        .cells
        .iter()
        .filter(|cell| cell.outcome != Outcome::Certified);
    let of = failed.map(|cell| {
        let subject = &cell.subject;
        ((&subject.case, subject.engine.as_str()), cell.outcome)
    });
    of.collect()
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn three_digits() {
        let texts = [0.987_6, 1.234_5, 12.345, 1_234.5].map(short);
        assert_eq!(texts, ["0.99", "1.23", "12.3", "1234"]);
    }
}
