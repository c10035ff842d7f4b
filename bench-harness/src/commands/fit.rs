//! `hullbench fit`: by which law a cost grows.

use crate::analysis;
use crate::analysis::fit::Quantity;
use crate::commands::recorded::{deliver, load, unknown};
use crate::failure::Failure;
use crate::output::target::OutputArgs;
use clap::ValueHint;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Candidates: n, n log h, n log n, n log² n, n^(4/3), n^1.5, n h, n^(5/3), n², n² log n, each alone or with one term of
lower order, fitted by least squares of the relative error. A law is declared only if AICc prefers it to each other by
more than 10, it foretells the upper 30 % of the sizes best when fitted to the lower 70 %, and what it leaves over has
no pattern. Otherwise: not distinguishable on this range.

Beside the slope of the logarithms stands the slope that each law would have at the same sizes: n log n has 1.1 between
a thousand and a million. No law is declared from time across the border of a cache (L2 and beyond); cut the range with
--from and --to.

Examples:
  hullbench fit RUN --counter orient
  hullbench fit RUN --time --to 50000

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

/// The arguments of `hullbench fit`.
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "hullbench fit [OPTIONS] <--counter COUNTER | --time> <RUN>", after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: PathBuf,

    /// Fit this count
    #[arg(long, value_name = "COUNTER", value_hint = ValueHint::Other, required_unless_present = "time")]
    counter: Option<String>,

    /// Fit the time of a call
    #[arg(long, conflicts_with = "counter")]
    time: bool,

    /// Leave out smaller n
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    from: usize,

    /// Leave out larger n
    #[arg(long, value_name = "N", default_value_t = usize::MAX, hide_default_value = true)]
    to: usize,

    #[command(flatten)]
    output: OutputArgs,
}

/// Fits and writes.
///
/// # Errors
///
/// [`Failure::Usage`] for a counter that the run does not have; [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let run = load(&args.run)?;
    let quantity = match &args.counter {
        None => Quantity::Time,
        Some(counter) => {
            let known = run.counters();
            if !known.contains(&counter.as_str()) {
                return Err(unknown("counter", counter, &known));
            }
            Quantity::Counter(counter.clone())
        }
    };
    let answer = analysis::fit::fit(&run, &quantity, &(args.from..=args.to));
    deliver(&answer.page(), &args.output)
}
