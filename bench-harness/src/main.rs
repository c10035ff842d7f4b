//! `hullbench`: convex hull algorithms run, certified and judged against the papers.
//!
//! This file parses the command line and dispatches; the work is in the library of the same package.

use bench_harness::commands::{check, delaunay, engine, hull, methods, peel, peers, points, sweep};
use bench_harness::commands::{claims, published};
use bench_harness::commands::{cmp, diff, export, fit, plot, rank, report, table, targets};
use bench_harness::failure::Failure;
use bench_harness::output::target::note;
use bench_harness::reproduce;
use bench_harness::{gate, measure};
use clap::{Parser, Subcommand};
use std::process::ExitCode;

const AFTER: &str = "\
Results go to standard output, everything else to standard error. No result is shown that an independent
checker has not certified.

Examples:
  hullbench hull points.csv -o hull.csv
  hullbench peel --set oblique:cols=10,rows=10 --boundary all
  hullbench points --list

Exit codes:
  0  done
  1  a result could not be certified, a claim does not hold, or a run got worse
  2  usage: an unknown option, method or point set
  3  bad input data
  4  a file could not be read or written";

const REPRODUCE: &str = "\
Examples:
  hullbench reproduce
  hullbench reproduce --quick

Exit codes:
  0 done   1 not certified   2 usage   3 bad input data   4 a file could not be read or written";

/// Convex hull algorithms run, certified and judged against the papers
#[derive(Parser)]
#[command(name = "hullbench", version, after_help = AFTER)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// The convex hull of points of the plane or of space, certified
    Hull(hull::Args),
    /// The convex layers of points, their c-ranks and mid-ranks, certified
    Peel(peel::Args),
    /// The Delaunay triangulation of points of the plane, certified
    Delaunay(delaunay::Args),
    /// The volume swept by a part that moves in a straight line, certified, and the obstacles in it
    Sweep(sweep::Args),
    /// Whether a hull made by anyone is the hull of the points, proved
    Check(check::Args),
    /// A point set from the catalogue
    Points(points::Args),
    /// The registered methods: publication, cost, departures
    Methods(methods::Args),
    /// Engines verified, counted and timed in turn, as definitions say
    Measure(measure::Args),
    /// Engines verified, as definitions say
    Verify(measure::Args),
    /// Whether the exact counts of a fixed small suite are those that are expected
    Gate(gate::Args),
    /// Writes the counts of that suite as the expected ones
    Bless(gate::Args),
    /// One of our methods, answering the pipe protocol of the harness
    Engine(engine::Args),
    /// Outside programs to compare with: built, and asked who they are
    Peers(peers::Args),
    /// The engines of a recorded run side by side, case by case
    Cmp(cmp::Args),
    /// The engines of a recorded run over all cases
    Rank(rank::Args),
    /// What has changed between two recorded runs; exit code 1 if something got worse
    Diff(diff::Args),
    /// By which law a cost grows, if the records can tell
    Fit(fit::Args),
    /// Times and counts of a recorded run in the layout of a paper
    Table(table::Args),
    /// Whether the fast methods take no longer than they are meant to
    Targets(targets::Args),
    /// Times that the authors of other programs print, beside the same programs here
    Published(published::Args),
    /// The verdicts on the papers' claims, from the reports
    Claims(claims::Args),
    /// Growth and ratios of a recorded run as drawings
    Plot(plot::Args),
    /// A recorded run as one HTML file, and its tables in a Markdown file
    Report(report::Args),
    /// The times of a recorded run in formats that other tools read
    Export(export::Args),
    /// The published tables, figures and claims, regenerated and judged
    #[command(after_help = REPRODUCE)]
    Reproduce(reproduce::Args),
}

fn main() -> ExitCode {
    let done = match Cli::parse().command {
        Command::Hull(args) => hull::run(&args),
        Command::Peel(args) => peel::run(&args),
        Command::Delaunay(args) => delaunay::run(&args),
        Command::Sweep(args) => sweep::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Points(args) => points::run(&args),
        Command::Methods(args) => methods::run(&args),
        Command::Measure(args) => measure::measure(&args).map_err(Failure::from),
        Command::Verify(args) => measure::verify(&args).map_err(Failure::from),
        Command::Gate(args) => gate::gate(&args).map_err(Failure::from),
        Command::Bless(args) => gate::bless(&args).map_err(Failure::from),
        Command::Engine(args) => engine::run(&args),
        Command::Peers(args) => peers::run(&args),
        Command::Cmp(args) => cmp::run(&args),
        Command::Rank(args) => rank::run(&args),
        Command::Diff(args) => diff::run(&args),
        Command::Fit(args) => fit::run(&args),
        Command::Table(args) => table::run(&args),
        Command::Targets(args) => targets::run(&args),
        Command::Published(args) => published::run(&args),
        Command::Claims(args) => claims::run(&args),
        Command::Plot(args) => plot::run(&args),
        Command::Report(args) => report::run(&args),
        Command::Export(args) => export::run(&args),
        Command::Reproduce(args) => reproduce::run(&args).map_err(Failure::from),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !matches!(failure, Failure::Closed) {
                note(&format!("error: {failure}"));
            }
            failure.exit_code()
        }
    }
}
