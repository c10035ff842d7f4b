//! `hullbench rank`: the engines of a run over all cases.

use crate::analysis;
use crate::commands::recorded::{deliver, load, unknown};
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

    /// Only the cases of this definition [default: all]
    #[arg(long, value_name = "ID", value_hint = ValueHint::Other)]
    definition: Option<String>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Ranks and writes.
///
/// # Errors
///
/// [`Failure::Usage`] for a definition that the run does not have; [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let mut run = load(&args.run)?;
    if let Some(id) = &args.definition {
        let known = run.definitions();
        if !known.contains(&id.as_str()) {
            return Err(unknown("definition", id, &known));
        }
        run = run.only(id);
    }
    deliver(&analysis::rank::rank(&run).page(), &args.output)
}
