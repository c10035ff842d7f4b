//! Peers as a table or as JSON.
//!
//! The JSON is an array of objects of `name`, `program`, `problems`, `about`, and either `receipt` (what the engine
//! says of itself) or `missing`.

use crate::engine::peers::Program;
use crate::engine::peers::build::Outcome;
use crate::engine::protocol::Receipt;
use crate::output::rows::write_json;
use crate::output::text;
use serde::Serialize;
use std::io::{self, Write};

/// A peer, and what it says of itself or what is missing.
#[derive(Debug)]
pub struct Line {
    /// The name of the engine.
    pub name: &'static str,
    /// The program that is it.
    pub program: &'static str,
    /// What it computes.
    pub problems: Vec<&'static str>,
    /// What it is.
    pub about: &'static str,
    /// Its receipt, or what is missing.
    pub receipt: Result<Receipt, String>,
}

/// A line as JSON.
#[derive(Debug, Serialize)]
struct Entry<'a> {
    name: &'a str,
    program: &'a str,
    problems: &'a [&'a str],
    about: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    receipt: Option<&'a Receipt>,
    #[serde(skip_serializing_if = "Option::is_none")]
    missing: Option<&'a str>,
}

/// Writes `lines` as JSON.
///
/// # Errors
///
/// Those of `out`.
pub fn write_list_json(out: &mut dyn Write, lines: &[Line]) -> io::Result<()> {
    let entry = |line: &Line| -> serde_json::Value {
        serde_json::json!(Entry {
            name: line.name,
            program: line.program,
            problems: &line.problems,
            about: line.about,
            receipt: line.receipt.as_ref().ok(),
            missing: line.receipt.as_ref().err().map(String::as_str),
        })
    };
    write_json(out, &lines.iter().map(entry).collect::<Vec<_>>())
}

/// Writes `lines` as a table, one a line.
///
/// # Errors
///
/// Those of `out`.
pub fn write_table(out: &mut dyn Write, lines: &[Line]) -> io::Result<()> {
    let mut table = text::table(&["peer", "computes", "clock", "version, or what is missing"]);
    for line in lines {
        let (clock, version) = match &line.receipt {
            Ok(receipt) => (format!("{} ns", receipt.clock_ns), receipt.version.clone()),
            Err(missing) => ("-".into(), missing.clone()),
        };
        table.add_row([line.name, &line.problems.join(", "), &clock, &version]);
    }
    text::write_table(out, &table)
}

/// Writes what became of each build.
///
/// # Errors
///
/// Those of `out`.
pub fn write_outcomes(out: &mut dyn Write, outcomes: &[(&Program, Outcome)]) -> io::Result<()> {
    let mut table = text::table(&["program", "peers", "outcome"]);
    for (program, outcome) in outcomes {
        let engines: Vec<_> = program.engines.iter().map(|peer| peer.name).collect();
        let outcome = match outcome {
            Outcome::Ready => "ready".to_owned(),
            Outcome::Built => "built".to_owned(),
            Outcome::Missing(what) => format!("needs {}", what.join(" and ")),
            Outcome::Failed(why) => format!("failed: {why}"),
        };
        let engines = match &engines[..] {
            [only] => (*only).to_owned(),
            several => format!("{} engines", several.len()),
        };
        table.add_row([program.name, &engines, &outcome]);
    }
    text::write_table(out, &table)
}
