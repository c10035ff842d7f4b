//! `hullbench diff`: what has changed between two runs.

use crate::analysis;
use crate::commands::recorded::{deliver, load};
use crate::failure::Failure;
use crate::output::target::OutputArgs;
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
A cell is an engine on a point set of one size; cells are matched by definition, set, n, seed, engine, and the
fingerprint of the points. The ratio of a cell is the geometric mean over its realisations of the median time now over
the median time before.

The rule: a cell is slower if
  - the 95 % interval of its ratio (realisations and rounds drawn again) lies above the A/A band, and
  - a true ratio inside the band has p < 0.05, adjusted for all matched cells (Holm).
The A/A band holds 95 % of the ratios of a program to itself (its twin) within either run, and at least 0.98 to 1.02.
A cell is lost if it was certified before and is not now.

The exit code is 1 if a cell is slower or lost, else 0. Counts that differ are listed and do not count as slower.

Examples:
  hullbench diff OLD NEW
  hullbench diff OLD NEW --format json -o diff.json

Exit codes:
  0 nothing got worse   1 a cell is slower, or its certificate is lost   2 usage   3 bad records
  4 a file could not be read or written";

/// The arguments of `hullbench diff`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of the run to compare with
    #[arg(value_name = "OLD", value_hint = ValueHint::DirPath)]
    old: PathBuf,

    /// The folder of the run in question
    #[arg(value_name = "NEW", value_hint = ValueHint::DirPath)]
    new: PathBuf,

    #[command(flatten)]
    output: OutputArgs,
}

/// Compares, writes, and fails if something got worse.
///
/// # Errors
///
/// [`Failure::Verification`] if a cell is slower or lost; [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let (old, new) = (load(&args.old)?, load(&args.new)?);
    let answer = analysis::diff::diff(&old, &new);
    deliver(&answer.page(), &args.output)?;
    match answer.regression() {
        Some(what) => Err(Failure::Verification(what)),
        None => Ok(()),
    }
}
