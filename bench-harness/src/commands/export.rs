//! `hullbench export`: the times of a run in formats that other tools read.

use crate::analysis::export::{Tool, export};
use crate::commands::recorded::load;
use crate::failure::Failure;
use crate::output::atomic::Existing;
use crate::output::rows::write_json;
use crate::output::target::Target;
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
A benchmark is called definition/set/n/engine; its value is the median time of a call in nanoseconds.

  github-action-benchmark   for its tool customSmallerIsBetter
  bencher                   for `bencher run --adapter json --file FILE`; counts are measures too
  criterion                 for `critcmp OLD.json NEW.json`, which compares means; the baseline has the folder's name

Examples:
  hullbench export RUN --format github-action-benchmark -o output.json
  hullbench export RUN --format criterion -o new.json

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

/// The arguments of `hullbench export`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: PathBuf,

    /// Which tool it is for
    #[arg(long, value_enum)]
    format: Tool,

    /// Write to this file; - is standard output [default: -]
    #[arg(long, short, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// Replace the file if it exists
    #[arg(long, requires = "output")]
    force: bool,
}

/// Writes the times.
///
/// # Errors
///
/// [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let existing = if args.force {
        Existing::Replace
    } else {
        Existing::Keep
    };
    let target = Target::new(args.output.as_deref(), existing)?;
    let value = export(&load(&args.run)?, args.format);
    target.write(|out| write_json(out, &value))?;
    target.note("written");
    Ok(())
}
