//! `hullbench hull`: the convex hull of points.

use crate::commands::input::InputArgs;
use crate::commands::select::{self, BoundaryArg};
use crate::failure::Failure;
use crate::output::hull::HullReport;
use crate::output::target::OutputArgs;
use clap::ValueHint;

const EXAMPLES: &str = "\
Every hull is certified by a checker that shares no arithmetic with the methods; a hull that it rejects is
an error (exit code 1) and is not written.

The CSV columns: order (place on the boundary, from 0, anticlockwise), index (of the point, from 0),
line (of the file), x, y. The JSON object holds the same under `vertices`, and the figures of the summary.

Examples:
  hullbench hull points.csv
  hullbench hull points.csv --columns lon,lat --boundary all -o hull.csv
  hullbench hull --set oblique:cols=10,rows=10 --method graham --format json

Exit codes:
  0 done   1 not certified   2 usage   3 bad input data   4 a file could not be read or written";

/// The arguments of `hullbench hull`.
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "hullbench hull [OPTIONS] <FILE | --set SPEC>", after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    input: InputArgs,

    /// The method that finds the hull, by its slug (see `hullbench methods`)
    #[arg(long, help_heading = "Method", value_name = "SLUG", default_value = "gs", value_hint = ValueHint::Other)]
    method: String,

    /// Which boundary points count as vertices
    #[arg(long, help_heading = "Method", value_enum, default_value = "extreme")]
    boundary: BoundaryArg,

    #[command(flatten)]
    output: OutputArgs,
}

/// Computes, certifies and writes the hull.
///
/// # Errors
///
/// Every kind of [`Failure`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let delivery = args.output.delivery()?;
    let (method, task) = select::hull(&args.method)?;
    let boundary = args.boundary.into();
    let input = args.input.load()?;

    let hull = (task.exact)(input.view(), boundary)
        .map_err(|error| Failure::Verification(format!("method '{}': {error}", method.slug)))?;
    let certificate = hull_verify::check::hull2(&input.points, boundary, &hull)
        .map_err(|findings| select::not_certified(method, &findings))?;
    let report = HullReport::new(&input, method, boundary, &hull, &certificate);
    delivery.send(&report)
}
