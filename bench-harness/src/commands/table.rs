//! `hullbench table`: times and counts of a run in the layout of a paper.

use crate::analysis;
use crate::commands::recorded::{deliver, load, unknown};
use crate::failure::Failure;
use crate::output::target::OutputArgs;
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
A table a point set: a row a size with its h, a column an engine. Times are medians over realisations of the median time
of a call; counts are means over realisations. The least of a row is bold. An engine without a certificate shows what
became of it.

Examples:
  hullbench table RUN
  hullbench table RUN --counter orient --counter peak_bytes -o tables.tex

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

/// The arguments of `hullbench table`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: PathBuf,

    /// Show this count too; may be given several times
    #[arg(long = "counter", value_name = "COUNTER", value_hint = ValueHint::Other)]
    counters: Vec<String>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Lays out and writes.
///
/// # Errors
///
/// [`Failure::Usage`] for a counter that the run does not have; [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let run = load(&args.run)?;
    let known = run.counters();
    if let Some(counter) = args.counters.iter().find(|c| !known.contains(&c.as_str())) {
        return Err(unknown("counter", counter, &known));
    }
    let answer = analysis::table::table(&run, &args.counters);
    deliver(&answer.page(), &args.output)
}
