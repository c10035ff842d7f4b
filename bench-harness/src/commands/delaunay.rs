//! `hullbench delaunay`: the Delaunay triangulation of points.

use crate::commands::input::InputArgs;
use crate::commands::select;
use crate::failure::Failure;
use crate::output::delaunay::DelaunayReport;
use crate::output::target::{OutputArgs, Report};
use clap::ValueHint;

const EXAMPLES: &str = "\
No point lies inside the circle through the corners of a triangle. The in-circle question is answered exactly,
however far the points are from the origin; where more than three points lie on one circle, their polygon is cut by a
stated rule. Collinear points have no triangles.

Every triangulation is certified by a checker that shares no arithmetic with the methods; one that it rejects is
an error (exit code 1) and is not written.

The CSV columns: triangle (from 0), a, b, c (indices of points, from 0, anticlockwise). The JSON object holds the
same under `triangles`, the edges of the hull, and the figures of the summary. OFF, OBJ and PLY hold the triangles in
the plane z = 0, SVG a drawing.

Examples:
  hullbench delaunay points.csv -o triangles.csv
  hullbench delaunay points.csv --columns lon,lat -o triangles.svg
  hullbench delaunay --set flattened-sphere:offset=1e7 -n 1024

Exit codes:
  0 done   1 not certified   2 usage   3 bad input data   4 a file could not be read or written";

/// The arguments of `hullbench delaunay`.
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "hullbench delaunay [OPTIONS] <FILE | --set SPEC>", after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    input: InputArgs,

    /// The method that triangulates, by its slug (see `hullbench methods`)
    #[arg(long, help_heading = "Method", value_name = "SLUG", default_value = select::default::DELAUNAY, value_hint = ValueHint::Other)]
    method: String,

    #[command(flatten)]
    output: OutputArgs,
}

/// Computes, certifies and writes the triangulation.
///
/// # Errors
///
/// Every kind of [`Failure`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let delivery = args.output.delivery(DelaunayReport::FORMATS)?;
    let (method, task) = select::delaunay(&args.method)?;
    let input = args.input.load2()?;

    let triangulation = (task.exact)(input.view())
        .map_err(|error| Failure::Verification(format!("method '{}': {error}", method.slug)))?;
    let certificate = hull_verify::check::delaunay(&input.points, &triangulation)
        .map_err(|findings| select::not_certified(method, &findings))?;
    let report = DelaunayReport::new(input, method, triangulation, &certificate);
    delivery.send(&report)
}
