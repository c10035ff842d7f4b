//! `hullbench peel`: the convex layers of points.

use crate::commands::input::InputArgs;
use crate::commands::select::{self, BoundaryArg};
use crate::failure::Failure;
use crate::output::peel::PeelReport;
use crate::output::target::{OutputArgs, Report};
use clap::ValueHint;

const EXAMPLES: &str = "\
A layer is the hull of the points that no earlier layer removed; it removes its vertices and their copies.
The layer of a point is the 1-based number of its ring, outermost first, which is its c-rank by definition
(Green and Silverman 1979, after Barnett 1976). The mid-rank runs from 1 to n from the outside in, points of
one layer sharing the mean of their places. The mean of the innermost layer is the multivariate median.

Every layer is certified by a checker that shares no arithmetic with the methods; layers that it rejects are
an error (exit code 1) and are not written.

The CSV columns, one row a point in the order of the input: index (from 0), line (of the file), x, y, layer,
c_rank, mid_rank. The JSON object holds the same under `ranks`, and the figures of the summary.

Examples:
  hullbench peel points.csv --boundary all
  hullbench peel --set oblique:cols=10,rows=10 --boundary all
  hullbench peel points.csv --method chain-peel -o ranks.csv

Exit codes:
  0 done   1 not certified   2 usage   3 bad input data   4 a file could not be read or written";

/// The arguments of `hullbench peel`.
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "hullbench peel [OPTIONS] <FILE | --set SPEC>", after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    input: InputArgs,

    /// The method that finds the layers, by its slug (see `hullbench methods`)
    #[arg(long, help_heading = "Method", value_name = "SLUG", default_value = select::default::LAYERS, value_hint = ValueHint::Other)]
    method: String,

    /// Which boundary points a layer removes
    #[arg(long, help_heading = "Method", value_enum, default_value = "extreme")]
    boundary: BoundaryArg,

    #[command(flatten)]
    output: OutputArgs,
}

/// Computes, certifies and writes the layers.
///
/// # Errors
///
/// Every kind of [`Failure`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let delivery = args.output.delivery(PeelReport::FORMATS)?;
    let (method, task) = select::layers(&args.method)?;
    let boundary = args.boundary.into();
    let input = args.input.load2()?;

    let layers = (task.exact)(input.view(), boundary)
        .map_err(|error| Failure::Verification(format!("method '{}': {error}", method.slug)))?;
    let certificate = hull_verify::check::layers(&input.points, boundary, &layers)
        .map_err(|findings| select::not_certified(method, &findings))?;
    let report = PeelReport::new(&input, method, boundary, &layers, &certificate);
    delivery.send(&report)
}
