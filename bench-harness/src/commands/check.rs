//! `hullbench check`: whether a hull made by anyone is the hull of the points.

use crate::claimed;
use crate::commands::claim;
use crate::commands::input::{DimensionArg, Input, TableArgs};
use crate::commands::select::BoundaryArg;
use crate::failure::Failure;
use crate::output::hull::Account;
use crate::output::hull3::Account3;
use crate::output::target::to_stdout;
use crate::output::text;
use hull_verify::check;
use std::fmt::Display;
use std::path::PathBuf;

const EXAMPLES: &str = "\
HULL, for points of the plane: the indices of the vertices, from 0, anticlockwise, as a CSV file with a column
named index (as `hullbench hull` writes it) or one index a line. For points of space: a mesh (OFF, also what Qhull
prints with option o; OBJ; PLY), whose vertices are matched to the points by their exact coordinates; facets
may be cut into coplanar triangles. JSON as `hullbench hull` writes it is read for either.

What is wrong is listed on standard output, one finding a line.

Examples:
  hullbench check points.csv hull.csv
  hullbench check points.csv hull.ply
  hullbench check points.csv scipy.txt --boundary all

Exit codes:
  0 proved to be the hull   1 it is not   2 usage   3 bad input data   4 a file could not be read";

/// The most findings that are listed.
const LISTED: usize = 100;

/// The arguments of `hullbench check`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The file of points
    #[arg(value_name = "POINTS")]
    points: PathBuf,

    /// The file of the hull
    #[arg(value_name = "HULL")]
    hull: PathBuf,

    #[command(flatten)]
    table: TableArgs,

    /// Whether points have two or three coordinates [default: found out]
    #[arg(long, value_enum, value_name = "2|3")]
    dimension: Option<DimensionArg>,

    /// Which boundary points count as vertices, in the plane
    #[arg(long, value_enum, default_value = "extreme")]
    boundary: BoundaryArg,
}

/// Proves the hull, or lists what is wrong with it.
///
/// # Errors
///
/// [`Failure::Verification`] if it is not the hull; every other kind of [`Failure`].
pub fn run(args: &Args) -> Result<(), Failure> {
    match args.table.dimension(&args.points, args.dimension)? {
        DimensionArg::Plane => in_plane(args),
        DimensionArg::Space => in_space(args),
    }
}

fn in_plane(args: &Args) -> Result<(), Failure> {
    let input = args.table.load2(&args.points)?;
    let hull = claim::in_plane(&args.hull, &input)?;
    match check::hull2(&input.points, args.boundary.into(), &hull) {
        Ok(certificate) => show(args, &input, None, &Account::of(&certificate).in_words()),
        Err(findings) => refuse(args, &findings),
    }
}

fn in_space(args: &Args) -> Result<(), Failure> {
    let input = args.table.load3(&args.points)?;
    let hull = match claim::in_space(&args.hull, &input)? {
        Ok(hull) => hull,
        Err(findings) => return refuse(args, &findings),
    };
    let given = hull.facets().count();
    match claimed::certify3(input.view(), &hull) {
        Ok(certificate) => {
            let merged = (given != certificate.facets).then(|| {
                format!(
                    "{given} polygons of the file are {} facets",
                    certificate.facets
                )
            });
            let account = Account3::of(&certificate).in_words();
            show(args, &input, merged.as_deref(), &account)
        }
        Err(findings) => refuse(args, &findings),
    }
}

fn show<const D: usize>(
    args: &Args,
    input: &Input<D>,
    facets: Option<&str>,
    account: &str,
) -> Result<(), Failure> {
    to_stdout(|out| {
        text::line(out, "source", &input.source)?;
        text::line(out, "hull", args.hull.display())?;
        if let Some(facets) = facets {
            text::line(out, "facets", facets)?;
        }
        text::line(out, "certificate", account)
    })
}

fn refuse(args: &Args, findings: &[impl Display]) -> Result<(), Failure> {
    to_stdout(|out| {
        for finding in findings.iter().take(LISTED) {
            writeln!(out, "{finding}")?;
        }
        match findings.len().saturating_sub(LISTED) {
            0 => Ok(()),
            more => writeln!(out, "... and {more} more"),
        }
    })?;
    Err(Failure::Verification(format!(
        "{} is not the hull of {}: {}",
        args.hull.display(),
        args.points.display(),
        text::count(findings.len(), "finding", "findings")
    )))
}
