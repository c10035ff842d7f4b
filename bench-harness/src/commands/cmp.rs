//! `hullbench cmp`: the engines of a run side by side.

use crate::analysis;
use crate::commands::recorded::{deliver, load, unknown};
use crate::failure::Failure;
use crate::output::target::OutputArgs;
use clap::ValueHint;
use std::collections::BTreeSet;
use std::path::PathBuf;

const EXAMPLES: &str = "\
For each case: the median and the shortest time of a call, the ratio to the baseline with its 95 % interval, and what is
established. The ratio is the median, over rounds in which both were sampled, of the ratio in that round; the interval
draws realisations and rounds again. Slower or faster: the ratio lies beyond the A/A band, p < 0.05 adjusted for all
cells (Holm). h stands beside every time. The signed-rank p-value and the drift of the ratio are in CSV and JSON.

Examples:
  hullbench cmp RUN
  hullbench cmp RUN --baseline gs --format csv -o cmp.csv

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

/// The arguments of `hullbench cmp`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: PathBuf,

    /// Compare with this engine [default: the fastest of each case]
    #[arg(long, value_name = "ENGINE", value_hint = ValueHint::Other)]
    baseline: Option<String>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Compares and writes.
///
/// # Errors
///
/// [`Failure::Usage`] for an engine that was not timed; [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let run = load(&args.run)?;
    let timed = run.cases().into_iter().flat_map(|case| run.timed(case));
    let engines: BTreeSet<&str> = timed.collect();
    if let Some(baseline) = &args.baseline
        && !engines.contains(baseline.as_str())
    {
        let known: Vec<&str> = engines.into_iter().collect();
        return Err(unknown("engine", baseline, &known));
    }
    let answer = analysis::cmp::cmp(&run, args.baseline.as_deref());
    deliver(&answer.page(), &args.output)
}
