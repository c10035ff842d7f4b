//! `hullbench sweep`: the volume swept by a part that moves in a straight line.

use crate::commands::input::{Input, InputArgs};
use crate::commands::select;
use crate::failure::Failure;
use crate::output::sweep::SweepReport;
use crate::output::target::{OutputArgs, Report};
use hullkit::sweep::swept_volume;

const EXAMPLES: &str = "\
The swept volume is the hull of the points of the part before and after the move (Nathan 2015): no obstacle is
missed, however far the move; one may be reported that passes through a hollow of the part. Where the end of a
corner is not representable, the hull contains the true volume. Whether an obstacle is inside is decided exactly.

The part is a file of points of space, or a mesh (OFF, OBJ, PLY). The hull is certified, and written as that of
`hullbench hull`; its indices are those of the corners at the start and then of those at the end.

Examples:
  hullbench sweep part.off --by 10,0,0
  hullbench sweep part.csv --by 0,0,-2.5 --obstacle 1,2,-1 --obstacle 4,0,0
  hullbench sweep part.csv --by 1,1,0 -o swept.ply

Exit codes:
  0 done   1 not certified   2 usage   3 bad input data   4 a file could not be read or written";

/// The arguments of `hullbench sweep`.
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "hullbench sweep [OPTIONS] --by X,Y,Z <FILE | --set SPEC>", after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    input: InputArgs,

    /// The move
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vector, allow_hyphen_values = true)]
    by: Vector,

    /// A point, to be located against the swept volume; may be given several times
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vector, allow_hyphen_values = true)]
    obstacle: Vec<Vector>,

    #[command(flatten)]
    output: OutputArgs,
}

/// Three finite numbers.
type Vector = [f64; 3];

fn parse_vector(text: &str) -> Result<Vector, String> {
    let numbers = text.split(',').map(|number| number.trim().parse::<f64>());
    let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().unwrap_or_default();
    let vector: Result<Vector, _> = numbers.try_into();
    vector
        .ok()
        .filter(|vector| vector.iter().all(|coordinate| coordinate.is_finite()))
        .ok_or_else(|| "write three finite numbers, such as 1,0,-2.5".into())
}

/// Computes, certifies and writes the swept volume, and locates the obstacles.
///
/// # Errors
///
/// Every kind of [`Failure`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let delivery = args.output.delivery(SweepReport::FORMATS)?;
    let part = args.input.load3()?;
    let bad_data = |error: hullkit::HullError| Failure::Data(format!("{}: {error}", part.source));

    let sweep = swept_volume(&part.points, args.by).map_err(bad_data)?;
    let (method, _) = select::hull3(select::default::HULL3)?;
    let certificate = hull_verify::check::hull3(sweep.points(), sweep.hull())
        .map_err(|findings| select::not_certified(method, &findings))?;
    let located = args
        .obstacle
        .iter()
        .map(|&obstacle| Ok((obstacle, sweep.locate(obstacle)?)));
    let located = located.collect::<Result<Vec<_>, _>>().map_err(bad_data)?;

    let source = format!("{}, moved by {:?}", part.source, args.by);
    let lines = (0..part.points.len() as u32).map_while(|id| part.line(id));
    let swept = Input::new(sweep.points().to_vec(), lines.collect(), source)?;
    let report = SweepReport::new(&swept, method, &sweep, &certificate, args.by, &located);
    delivery.send(&report)
}
