//! The registry as a table, as one entry for reading, or as JSON.
//!
//! The JSON is an array of objects of `slug`, `computes` (`"hull"`, `"layers"`, `"hull-3d"` or `"delaunay"`), `title`, `citation`,
//! `cost` and `departures`.

use crate::commands::select;
use crate::output::rows::write_json;
use crate::output::text;
use hullkit::Method;
use serde::Serialize;
use std::io::{self, Write};

/// A registry entry as JSON.
#[derive(Debug, Serialize)]
struct Entry {
    slug: &'static str,
    computes: &'static str,
    title: &'static str,
    citation: &'static str,
    cost: &'static str,
    departures: &'static [&'static str],
}

impl Entry {
    fn of(method: &'static Method) -> Self {
        Self {
            slug: method.slug,
            computes: select::computes(method),
            title: method.title,
            citation: method.citation,
            cost: method.cost,
            departures: method.departures,
        }
    }
}

/// Writes `methods` as JSON.
///
/// # Errors
///
/// Those of `out`.
pub fn write_list_json(out: &mut dyn Write, methods: &[&'static Method]) -> io::Result<()> {
    let entries: Vec<_> = methods.iter().map(|method| Entry::of(method)).collect();
    write_json(out, &entries)
}

/// Writes `methods` as a table, one a line.
///
/// # Errors
///
/// Those of `out`.
pub fn write_table(out: &mut dyn Write, methods: &[&'static Method]) -> io::Result<()> {
    let mut table = text::table(&["slug", "computes", "departures", "title", "cost"]);
    for method in methods {
        let departures = match method.departures.len() {
            0 => "none".to_string(),
            number => number.to_string(),
        };
        table.add_row([
            method.slug,
            select::computes(method),
            &departures,
            method.title,
            method.cost,
        ]);
    }
    text::write_table(out, &table)?;
    writeln!(
        out,
        "\n`hullbench methods SLUG` shows the publication and the departures from it."
    )
}

/// Writes everything about one method.
///
/// # Errors
///
/// Those of `out`.
pub fn write_entry(out: &mut dyn Write, method: &Method) -> io::Result<()> {
    text::line(out, "slug", method.slug)?;
    text::line(out, "title", method.title)?;
    text::line(out, "computes", select::computes(method))?;
    text::line(out, "citation", method.citation)?;
    text::line(out, "cost", method.cost)?;
    if method.departures.is_empty() {
        text::line(out, "departures", "none")?;
    }
    for (number, departure) in (1..).zip(method.departures) {
        let label = if number == 1 { "departures" } else { "" };
        text::line(out, label, format!("{number}. {departure}"))?;
    }
    Ok(())
}
