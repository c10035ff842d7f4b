//! `hullbench engine`: one of our methods, answering the pipe protocol.

use crate::commands::select;
use crate::engine::own::Own;
use crate::engine::server::{Engine, serve};
use crate::engine::yardstick::{Measure, Yardstick};
use crate::failure::Failure;
use clap::ValueHint;
use std::io;

const EXAMPLES: &str = "\
The harness starts this for every method it measures; outside programs answer the same protocol. It is written down
in bench-harness/PROTOCOL.md.

Examples:
  hullbench engine gs
  printf 'version\\nquit\\n' | hullbench engine quickhull-3d

Exit codes:
  0 done   2 usage, such as a slug that is not registered   4 the pipe is broken, or spoke something else";

/// The arguments of `hullbench engine`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The method, by its slug (see `hullbench methods`), or a yardstick: sort, pass, arithmetic,
    /// pass-parallel, arithmetic-parallel
    #[arg(value_name = "SLUG", value_hint = ValueHint::Other)]
    slug: String,
}

/// Answers until the other end says `quit` or is gone.
///
/// # Errors
///
/// [`Failure::Usage`] for a slug that is not registered; [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    if let Some(yardstick) = Yardstick::find(&args.slug) {
        return answer(&mut Measure::new(yardstick));
    }
    let method = select::any(&args.slug)?;
    let mut engine = Own::new(method).ok_or_else(|| {
        Failure::Usage(format!(
            "method '{}' computes nothing that the protocol has a word for",
            method.slug
        ))
    })?;
    answer(&mut engine)
}

fn answer(engine: &mut dyn Engine) -> Result<(), Failure> {
    let mut output = io::BufWriter::new(io::stdout().lock());
    serve(engine, &mut io::stdin().lock(), &mut output)
        .map_err(|error| Failure::io("the pipe", &error, "see bench-harness/PROTOCOL.md"))
}
