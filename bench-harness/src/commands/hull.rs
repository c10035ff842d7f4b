//! `hullbench hull`: the convex hull of points.

use crate::commands::input::{DimensionArg, InputArgs};
use crate::commands::select::{self, BoundaryArg, default};
use crate::failure::Failure;
use crate::output::hull::HullReport;
use crate::output::hull3::HullReport3;
use crate::output::target::{OutputArgs, Report};
use clap::ValueHint;

const EXAMPLES: &str = "\
The points are of space if three columns are chosen, if the header names x, y and z, or if three columns hold
numbers; if the set of the catalogue is; and if the file is a mesh (OFF, OBJ, PLY), whose points are taken.

Every hull is certified by a checker that shares no arithmetic with the methods; a hull that it rejects is
an error (exit code 1) and is not written.

The CSV columns: order (place on the boundary, from 0, anticlockwise; in space the order of the indices), index
(of the point, from 0), line (of the file), x, y and in space z. The JSON object holds the same under `vertices`,
and the figures of the summary; in space also the `facets`, anticlockwise seen from outside. OFF, OBJ, PLY and STL
hold the facets of a hull in space; STL rounds coordinates to single precision.

Examples:
  hullbench hull points.csv
  hullbench hull points.csv --columns lon,lat --boundary all -o hull.csv
  hullbench hull --set oblique:cols=10,rows=10 --method graham --format json
  hullbench hull --set ball -n 100000 -o hull.ply

Exit codes:
  0 done   1 not certified   2 usage   3 bad input data   4 a file could not be read or written";

/// The arguments of `hullbench hull`.
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "hullbench hull [OPTIONS] <FILE | --set SPEC>", after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    input: InputArgs,

    /// Whether points have two or three coordinates [default: found out]
    #[arg(long, help_heading = "Points", value_enum, value_name = "2|3")]
    dimension: Option<DimensionArg>,

    /// The method that finds the hull, by its slug (see `hullbench methods`) [default: fast-2d; hull-3d in space]
    #[arg(long, help_heading = "Method", value_name = "SLUG", value_hint = ValueHint::Other)]
    method: Option<String>,

    /// Which boundary points count as vertices, in the plane [default: extreme]
    #[arg(long, help_heading = "Method", value_enum)]
    boundary: Option<BoundaryArg>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Computes, certifies and writes the hull.
///
/// # Errors
///
/// Every kind of [`Failure`].
pub fn run(args: &Args) -> Result<(), Failure> {
    match args.input.dimension(args.dimension)? {
        DimensionArg::Plane => in_plane(args),
        DimensionArg::Space => in_space(args),
    }
}

fn in_plane(args: &Args) -> Result<(), Failure> {
    let delivery = args.output.delivery(HullReport::FORMATS)?;
    let (method, task) = select::hull(args.method.as_deref().unwrap_or(default::HULL))?;
    let boundary = args.boundary.unwrap_or(BoundaryArg::Extreme).into();
    let input = args.input.load2()?;

    let hull = (task.exact)(input.view(), boundary)
        .map_err(|error| Failure::Verification(format!("method '{}': {error}", method.slug)))?;
    let certificate = hull_verify::check::hull2(&input.points, boundary, &hull)
        .map_err(|findings| select::not_certified(method, &findings))?;
    let report = HullReport::new(&input, method, boundary, &hull, &certificate);
    delivery.send(&report)
}

fn in_space(args: &Args) -> Result<(), Failure> {
    let delivery = args.output.delivery(HullReport3::FORMATS)?;
    let (method, task) = select::hull3(args.method.as_deref().unwrap_or(default::HULL3))?;
    if args.boundary == Some(BoundaryArg::All) {
        return Err(Failure::Usage(
            "--boundary all is for points of the plane; in space only extreme points are vertices"
                .into(),
        ));
    }
    let input = args.input.load3()?;

    let hull = (task.exact)(input.view())
        .map_err(|error| Failure::Verification(format!("method '{}': {error}", method.slug)))?;
    let certificate = hull_verify::check::hull3(&input.points, &hull)
        .map_err(|findings| select::not_certified(method, &findings))?;
    let report = HullReport3::new(&input, method, &hull, &certificate);
    delivery.send(&report)
}
