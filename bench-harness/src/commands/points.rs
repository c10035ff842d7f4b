//! `hullbench points`: a point set from the catalogue.

use crate::commands::input::DrawArgs;
use crate::failure::Failure;
use crate::output::atomic::Existing;
use crate::output::catalogue::write_catalogue;
use crate::output::target::{Target, to_stdout};
use point_sets::{Spec, file};
use std::path::PathBuf;

const EXAMPLES: &str = "\
The file is CSV of x, y and for a set of space z, each with the fewest digits that read back as the same f64. It opens with comment
lines (#) that say how to make it again and give the fingerprint of its coordinates; every command that
reads points skips them.

Examples:
  hullbench points --list
  hullbench points disc -n 10000 --seed 7 -o disc.csv
  hullbench points oblique:cols=10,rows=10 | head
  hullbench points shuffled:of=circle-and-axis -n 2000 -o axis.csv

Exit codes:
  0 done   2 usage, such as an unknown point set   4 a file could not be written";

/// The arguments of `hullbench points`.
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "hullbench points [OPTIONS] <SPEC | --list>", after_help = EXAMPLES)]
pub struct Args {
    /// The point set: a name of the catalogue, with parameters after a colon
    #[arg(value_name = "SPEC", required_unless_present = "list")]
    spec: Option<Spec>,

    /// Show the catalogue: every point set with its parameters and its source
    #[arg(long, conflicts_with_all = ["spec", "output"])]
    list: bool,

    #[command(flatten)]
    draw: DrawArgs,

    /// Write the points to FILE; `-` is standard output
    ///
    /// The file appears whole or not at all.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Replace FILE if it exists
    #[arg(long, requires = "output")]
    force: bool,
}

/// Writes the points, or lists the catalogue.
///
/// # Errors
///
/// [`Failure::Usage`] for a set that cannot be generated, [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let Some(spec) = &args.spec else {
        return to_stdout(write_catalogue);
    };
    let existing = if args.force {
        Existing::Replace
    } else {
        Existing::Keep
    };
    let target = Target::new(args.output.as_deref(), existing)?;
    let headline = if spec.dimension() == 2 {
        let set = args.draw.draw(spec, Spec::generate)?;
        target.write(|out| set.write(out, file::write_csv2))?;
        set.headline()
    } else {
        let set = args.draw.draw(spec, Spec::generate3)?;
        target.write(|out| set.write(out, file::write_csv3))?;
        set.headline()
    };
    target.note(&headline);
    Ok(())
}
