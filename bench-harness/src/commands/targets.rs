//! `hullbench targets`: whether the fast methods take no longer than they are meant to.

use crate::analysis::targets::{Target, targets};
use crate::commands::known::Known;
use crate::commands::recorded::{deliver, load};
use crate::failure::Failure;
use crate::output::target::OutputArgs;
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
The targets lie in data/definitions/fast/targets.csv; `hullbench measure fast` measures what they are about and prints
this table at its end.

Examples:
  hullbench targets runs/fast
  hullbench targets runs/fast -o targets.csv

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

const TARGETS: Known = Known {
    path: "data/definitions/fast/targets.csv",
    built_in: include_str!("../../../data/definitions/fast/targets.csv"),
};

/// The arguments of `hullbench targets`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: PathBuf,

    #[command(flatten)]
    output: OutputArgs,
}

/// Compares and writes.
///
/// # Errors
///
/// [`Failure::Data`] for bad records or targets; [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let run = load(&args.run)?;
    deliver(&targets(&run, &all()?).page(), &args.output)
}

/// Every target there is.
///
/// # Errors
///
/// [`Failure::Data`] with the line of a target that is not one; [`Failure::Io`].
pub fn all() -> Result<Vec<Target>, Failure> {
    TARGETS.rows()
}
