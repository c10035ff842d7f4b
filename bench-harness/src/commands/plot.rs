//! `hullbench plot`: growth and ratios of a run as drawings.

use crate::analysis;
use crate::commands::recorded::{load, unknown};
use crate::failure::Failure;
use crate::output::atomic::{self, Existing};
use crate::output::target::to_stdout;
use clap::ValueHint;
use std::fs;
use std::path::PathBuf;

const EXAMPLES: &str = "\
For each point set: time and counts against n, both axes logarithmic, with the fit of the law if one is declared, and the
sizes at which the points fill a cache; and the ratio of each engine to the one that is fastest at the largest size,
with 95 % intervals and the A/A band. The names of the files are written to standard output.

Examples:
  hullbench plot RUN
  hullbench plot RUN --counter orient --out plots

Exit codes:
  0 done   2 usage   3 bad records   4 a file could not be read or written";

/// The arguments of `hullbench plot`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: PathBuf,

    /// Draw this count [default: every one]; may be given several times
    #[arg(long = "counter", value_name = "COUNTER", value_hint = ValueHint::Other)]
    counters: Vec<String>,

    /// Write the drawings to this folder, and replace those there [default: plots in the run's folder]
    #[arg(long, value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    out: Option<PathBuf>,
}

/// Draws and writes.
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
    let counters = if args.counters.is_empty() {
        known.into_iter().map(str::to_owned).collect()
    } else {
        args.counters.clone()
    };
    let drawings = analysis::plot::plot(&run, &counters)?;
    let folder = args.out.clone().unwrap_or_else(|| args.run.join("plots"));
    let cannot_write = |path: &PathBuf, error| {
        Failure::io(path.display(), &error, "choose a place you can write to")
    };
    fs::create_dir_all(&folder).map_err(|error| cannot_write(&folder, error))?;
    let mut paths = Vec::new();
    for drawing in &drawings {
        let path = folder.join(format!("{}.svg", drawing.name));
        atomic::write(&path, Existing::Replace, |out| {
            out.write_all(drawing.svg.as_bytes())
        })
        .map_err(|error| cannot_write(&path, error))?;
        paths.push(path);
    }
    to_stdout(|out| {
        paths
            .iter()
            .try_for_each(|path| writeln!(out, "{}", path.display()))
    })
}
