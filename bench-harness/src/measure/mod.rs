//! Verified, counted and timed: the cells of definitions, into a run folder.
//!
//! ```text
//! for each realisation 0, 1, ...          so that a budget cuts realisations, never cells
//!   for each cell                         a point set at one size
//!     points                              a set, or a batch of sets where n is small
//!     for each engine: load, run, judge   -> cells.csv; who is not certified goes no further
//!     for each round, engines shuffled    -> samples.csv
//!     for each engine: counters           -> counts.csv
//! ```
//!
//! Stops where no time is taken go first, on all cores.
//!
//! An interrupted run is gone on with by the same command: what is recorded is not done again.
//!
//! | module | holds |
//! |---|---|
//! | `roster` | who can take part |
//! | `plan` | the stops of a run, in order |
//! | `realisation` | the points of a stop |
//! | `judge` | whether an answer is right, and how wrong a wrong one is |
//! | `stop` | one stop: sessions, verdicts, rounds, counters |
//! | `instructions` | instructions of a call, by valgrind |
//! | `ledger` | what is recorded, and what is not to be done again |
//! | `warnings` | what a reader should be careful about |

mod instructions;
mod judge;
mod ledger;
mod plan;
mod realisation;
mod roster;
mod stop;
mod warnings;

use crate::definition::Definition;
use crate::failure::Failure;
use crate::output::target::to_stdout;
use crate::progress::{Progress, say};
use crate::records::{Outcome, Run};
use crate::{analysis, commands, parallel};
use anyhow::Result;
use ledger::Ledger;
use plan::Stop;
use roster::{Guest, Roster};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

const EXAMPLES: &str = "\
NAME is the id of a definition (a file below data/definitions/), the name of a group of them, or the path of a TOML
file. Engines that are not built are recorded as absent; `hullbench peers build` builds them.

Examples:
  hullbench measure curated --budget 10m
  hullbench measure curated            (again: goes on where it was interrupted)
  hullbench verify small-n

Exit codes:
  0 done   2 usage   3 bad definition or run folder   4 a file could not be read or written";

/// The options of `hullbench measure` and `hullbench verify`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Definitions or groups of them
    #[arg(value_name = "NAME", required = true)]
    names: Vec<String>,

    /// The folder of the run [default: runs/NAME]
    #[arg(long, value_name = "FOLDER")]
    run: Option<PathBuf>,

    /// Begin nothing after so long: 90s, 10m, 2h [default: no limit]
    #[arg(long, value_name = "TIME", value_parser = duration)]
    budget: Option<Duration>,

    /// Only these engines [default: all of the definition]
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    engines: Vec<String>,

    /// A program of your own that speaks the protocol: it takes part in every cell; may be given several times
    #[arg(long = "with", value_name = "NAME=PROGRAM")]
    guests: Vec<Guest>,

    /// No more points than this [default: no limit]
    #[arg(long, value_name = "N")]
    at_most: Option<usize>,

    /// Realisations of each cell, at most [default: the definition's]
    #[arg(long, value_name = "N")]
    realisations: Option<u64>,
}

/// How far to go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Depth {
    /// Certify only.
    Verify,
    /// Certify, count and time.
    Measure,
}

/// Verifies every cell of the definitions, then counts and times those that are certified.
///
/// # Errors
///
/// A definition or a run folder with a fault; a file that cannot be read or written. What goes wrong with an engine is
/// recorded, not an error.
pub fn measure(args: &Args) -> Result<()> {
    run(args, Depth::Measure)
}

/// Verifies every cell of the definitions.
///
/// # Errors
///
/// As [`measure`].
pub fn verify(args: &Args) -> Result<()> {
    run(args, Depth::Verify)
}

fn run(args: &Args, depth: Depth) -> Result<()> {
    let started = Instant::now();
    let roster = Roster::new(&args.guests)?;
    let definitions = definitions(&args.names, &roster)?;
    let selection = plan::Selection {
        engines: args.engines.clone(),
        guests: args.guests.iter().map(|guest| guest.name.clone()).collect(),
        at_most: args.at_most,
        realisations: args.realisations,
    };
    definitions.iter().for_each(introduce);
    let stops = plan::stops(&definitions, &selection);
    let folder = args
        .run
        .clone()
        .unwrap_or_else(|| PathBuf::from("runs").join(args.names.join("+")));
    let mut ledger = Ledger::open(&folder, &definitions, &command(args, depth))?;
    let is_used_up = || {
        args.budget
            .is_some_and(|budget| started.elapsed() >= budget)
    };
    let left = go_round(&stops, depth, &roster, &mut ledger, &is_used_up)?;
    if left > 0 {
        ledger.note(&format!("the budget is used up with {left} stops left"));
    }
    ledger.close()?;
    summary(&ledger)
}

/// Measures all of `definitions` into the new or interrupted run in `folder`, on behalf of `command`.
///
/// # Errors
///
/// As [`measure`].
pub(crate) fn run_into(folder: &Path, definitions: &[Definition], command: &str) -> Result<Run> {
    let roster = Roster::new(&[])?;
    let stops = plan::stops(definitions, &plan::Selection::default());
    let mut ledger = Ledger::open(folder, definitions, command)?;
    go_round(&stops, Depth::Measure, &roster, &mut ledger, &|| false)?;
    ledger.close()?;
    Ok(Run::load(folder)?)
}

/// Visits `stops` until the budget is used up: first those where no time is taken, on all cores, then the others, each
/// alone on the machine. Returns how many are left.
fn go_round(
    stops: &[Stop<'_>],
    depth: Depth,
    roster: &Roster,
    ledger: &mut Ledger,
    is_used_up: &(dyn Fn() -> bool + Sync),
) -> Result<usize> {
    let progress = Progress::start("measure", stops.len());
    let left = AtomicUsize::new(0);
    let ledger = Mutex::new(ledger);
    let visit = |stop: &&Stop<'_>| {
        if is_used_up() {
            left.fetch_add(1, Ordering::Relaxed);
            return Ok(());
        }
        stop::visit(stop, depth, roster, &ledger)?;
        progress.finished(&stop.name());
        Ok(())
    };
    let is_timed = |stop: &&Stop<'_>| depth == Depth::Measure && stop.is_timed();
    let (timed, untimed): (Vec<_>, Vec<_>) = stops.iter().partition(is_timed);
    parallel::map(&untimed, visit)?;
    timed.iter().try_for_each(visit)?;
    Ok(left.into_inner())
}

/// Says what a definition asks, and who is left out.
fn introduce(definition: &Definition) {
    say(&format!(
        "{}: {}",
        definition.id,
        definition.question.trim()
    ));
    for (engine, reason) in &definition.left_out {
        say(&format!("{}: without {engine}: {reason}", definition.id));
    }
}

/// What became of the cells, by outcome.
fn summary(ledger: &Ledger) -> Result<()> {
    let outcomes = [
        Outcome::Certified,
        Outcome::Wrong,
        Outcome::Refused,
        Outcome::Timeout,
        Outcome::Crashed,
        Outcome::Garbled,
        Outcome::Absent,
    ];
    to_stdout(|out| {
        for outcome in outcomes {
            let count = ledger.outcomes().filter(|other| *other == outcome).count();
            if count > 0 {
                writeln!(out, "{count:>6} {outcome}")?;
            }
        }
        for note in ledger.notes() {
            writeln!(out, "{note}")?;
        }
        writeln!(out, "{}", ledger.folder().display())
    })?;
    targets(ledger)
}

/// What the fast methods were meant to take, if this run is about that.
fn targets(ledger: &Ledger) -> Result<()> {
    let run = Run::load(ledger.folder())?;
    let found = analysis::targets::targets(&run, &commands::targets::all()?);
    if !found.rows.is_empty() && !run.samples.is_empty() {
        to_stdout(|out| write!(out, "\n{}", found.page().markdown()))?;
    }
    Ok(())
}

/// The definitions called `names`, each a definition, a group or a file.
fn definitions(names: &[String], roster: &Roster) -> Result<Vec<Definition>> {
    let known = |name: &str, problem| roster.knows(name, problem);
    let mut found: Vec<Definition> = Vec::new();
    let all = Definition::all(&known)?;
    for name in names {
        let before = found.len();
        if name.ends_with(".toml") {
            found.push(Definition::at(name, &known)?);
        } else {
            let called = all.iter().filter(|d| d.id == *name || d.group == *name);
            found.extend(called.cloned());
        }
        if found.len() == before {
            let ids: Vec<&str> = all
                .iter()
                .map(|definition| definition.id.as_str())
                .collect();
            let message = format!(
                "no definition is called '{name}'; there are {}",
                ids.join(", ")
            );
            return Err(Failure::Usage(message).into());
        }
    }
    found.dedup_by(|a, b| a.id == b.id);
    Ok(found)
}

/// The command line, as it would be typed again.
fn command(args: &Args, depth: Depth) -> String {
    let verb = match depth {
        Depth::Verify => "verify",
        Depth::Measure => "measure",
    };
    let mut words = vec![format!("hullbench {verb}")];
    words.extend(args.names.iter().cloned());
    words.extend(
        args.budget
            .map(|budget| format!("--budget {}s", budget.as_secs())),
    );
    if !args.engines.is_empty() {
        words.push(format!("--engines {}", args.engines.join(",")));
    }
    let guests = args
        .guests
        .iter()
        .map(|guest| format!("--with {}=...", guest.name));
    words.extend(guests);
    words.extend(args.at_most.map(|n| format!("--at-most {n}")));
    words.extend(args.realisations.map(|n| format!("--realisations {n}")));
    words.join(" ")
}

/// `90s`, `10m`, `2h`.
fn duration(text: &str) -> Result<Duration, String> {
    let (number, unit) =
        text.split_at(text.len() - text.chars().next_back().map_or(0, char::len_utf8));
    let seconds = match unit {
        "s" => 1,
        "m" => 60,
        "h" => 3_600,
        _ => return Err("a whole number with s, m or h after it".to_owned()),
    };
    let number: u64 = number
        .parse()
        .map_err(|_| "a whole number with s, m or h after it")?;
    Ok(Duration::from_secs(number.saturating_mul(seconds)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn budgets_have_units() {
        assert_eq!(duration("90s"), Ok(Duration::from_secs(90)));
        assert_eq!(duration("2h"), Ok(Duration::from_secs(7_200)));
        assert!(duration("10").is_err() && duration("").is_err() && duration("xm").is_err());
    }

    #[test]
    fn every_definition_is_valid_and_found_by_its_group() {
        let roster = Roster::new(&[]).expect("a place to look");
        let called = |name: &str| definitions(&[name.to_owned()], &roster);
        assert!(!called("curated").expect("valid definitions").is_empty());
        assert!(called("nothing").is_err());
    }
}
