//! `hullbench rank`: the engines of a run over all cases.

use crate::analysis;
use crate::commands::recorded::{deliver, load};
use crate::failure::Failure;
use crate::output::target::OutputArgs;
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
For each engine: the geometric mean of its ratios to the fastest engine of each case, with a 95 % interval over
realisations and rounds; on how many cases it is the fastest, and on how many within the A/A band of the fastest. An
engine that was not measured on every case stands after the others: its mean may be that of the easy cases.

Examples:
  hullbench rank RUN
  hullbench rank RUN --format md

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

/// The arguments of `hullbench rank`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: PathBuf,

    #[command(flatten)]
    output: OutputArgs,
}

/// Ranks and writes.
///
/// # Errors
///
/// [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let run = load(&args.run)?;
    deliver(&analysis::rank::rank(&run).page(), &args.output)
}
