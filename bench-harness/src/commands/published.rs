//! `hullbench published`: times that the authors of other programs print, beside the same programs here.

use crate::analysis::published::{Figure, published};
use crate::commands::known::Known;
use crate::commands::recorded::{deliver, load};
use crate::failure::Failure;
use crate::output::target::OutputArgs;
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
The published times lie in data/published/others/figures.csv, each with its source; `hullbench measure published`
measures the same programs on the same kind of points.

Examples:
  hullbench published runs/published

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

const FIGURES: Known = Known {
    path: "data/published/others/figures.csv",
    built_in: include_str!("../../../data/published/others/figures.csv"),
};

/// The arguments of `hullbench published`.
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
/// [`Failure::Data`] for bad records or figures; [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let run = load(&args.run)?;
    deliver(&published(&run, &figures()?).page(), &args.output)
}

/// Every published time.
///
/// # Errors
///
/// [`Failure::Data`] with the line of one that is not one; [`Failure::Io`].
pub fn figures() -> Result<Vec<Figure>, Failure> {
    FIGURES.rows()
}
