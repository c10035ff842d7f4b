//! Where points come from: a file, or a point set from the catalogue; of the plane, or of space.

use crate::failure::Failure;
use crate::output::catalogue::PointSet;
use clap::{Args, ValueEnum};
use geometry_core::Points;
use point_sets::file::{self, Column, Delimiter, FileError, Header, PointFile, ReadOptions};
use point_sets::mesh_file::{MeshFormat, read_mesh};
use point_sets::{Spec, SpecError};
use std::cmp::Ordering;
use std::convert::Infallible;
use std::path::{Path, PathBuf};

/// The number of points of a generated set whose size is not given.
const DEFAULT_COUNT: usize = 1000;

/// The seed of a generated set whose seed is not given.
const DEFAULT_SEED: u64 = 1979;

/// The arguments that say where points come from.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Points")]
pub struct InputArgs {
    /// The file of points
    #[arg(
        help_heading = None,
        value_name = "FILE",
        required_unless_present = "set",
        conflicts_with = "set"
    )]
    file: Option<PathBuf>,

    #[command(flatten)]
    table: TableArgs,

    /// Take a generated point set in place of a file (see `hullbench points --list`)
    #[arg(long, value_name = "SPEC", conflicts_with_all = ["columns", "header", "separator"])]
    set: Option<Spec>,

    #[command(flatten)]
    draw: DrawArgs,
}

/// The arguments that say how a file of points is laid out.
#[derive(Args, Clone, Debug)]
pub struct TableArgs {
    /// The columns that hold the coordinates, by name or by number from 1
    ///
    /// By default those that the header names as coordinates, such as x and y or lon and lat, else the first that
    /// hold numbers.
    #[arg(long, value_name = "X,Y[,Z]", value_parser = parse_columns)]
    columns: Option<Columns>,

    /// Whether the first line is a header [default: found out]
    #[arg(long, value_enum, value_name = "WHETHER")]
    header: Option<HeaderArg>,

    /// What separates the fields of a line [default: found out]
    #[arg(long, value_enum, value_name = "WHAT")]
    separator: Option<SeparatorArg>,
}

/// Two or three columns.
#[derive(Clone, Debug)]
struct Columns(Vec<Column>);

/// Whether there is a header, on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum HeaderArg {
    /// The first line holds names
    Present,
    /// The first line is a point
    Absent,
}

/// What separates fields, on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SeparatorArg {
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// A tab
    Tab,
    /// Any number of blanks and tabs
    Blank,
}

fn parse_columns(text: &str) -> Result<Columns, String> {
    let columns: Vec<Column> = text
        .split(',')
        .filter(|column| !column.trim().is_empty())
        .map(|column| {
            column
                .parse()
                .unwrap_or_else(|never: Infallible| match never {})
        })
        .collect();
    match columns.len() {
        2 | 3 => Ok(Columns(columns)),
        _ => Err("name two or three columns, such as lon,lat or 1,2,3".into()),
    }
}

/// The dimension of points, on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DimensionArg {
    /// Points of the plane
    #[value(name = "2")]
    Plane,
    /// Points of space
    #[value(name = "3")]
    Space,
}

/// The arguments that say how a point set is generated.
#[derive(Args, Clone, Copy, Debug)]
pub struct DrawArgs {
    /// How many points to generate [default: what the parameters of the set say, else 1000]
    #[arg(short = 'n', long, value_name = "N")]
    count: Option<usize>,

    /// The seed of the generator [default: 1979]
    #[arg(long, value_name = "S")]
    seed: Option<u64>,
}

/// How a set of dimension D is made.
type Maker<const D: usize> = fn(&Spec, usize, u64) -> Result<Vec<[f64; D]>, SpecError>;

/// How a file of points of dimension D is read.
type Reader<const D: usize> = fn(&Path, &ReadOptions<D>) -> Result<PointFile<D>, FileError>;

impl DrawArgs {
    /// The points of `spec`, made by [`Spec::generate`] or [`Spec::generate3`].
    ///
    /// # Errors
    ///
    /// [`Failure::Usage`] if the set has no such size or is of the other dimension.
    pub fn draw<const D: usize>(
        &self,
        spec: &Spec,
        make: Maker<D>,
    ) -> Result<PointSet<D>, Failure> {
        let count = self.count.or_else(|| spec.size());
        let seed = self.seed.unwrap_or(DEFAULT_SEED);
        let points = make(spec, count.unwrap_or(DEFAULT_COUNT), seed)
            .map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(PointSet {
            points,
            spec: spec.clone(),
            seed,
        })
    }
}

/// Points that are finite and can be indexed, and where they came from.
#[derive(Clone, Debug)]
pub struct Input<const D: usize = 2> {
    /// The points, in the order of the input.
    pub points: Vec<[f64; D]>,
    /// Where they came from, in words.
    pub source: String,
    rows: Vec<u64>,
}

impl InputArgs {
    /// Reads or generates points of the plane.
    ///
    /// # Errors
    ///
    /// [`Failure::Data`] for a file that is not what it should be, [`Failure::Io`] for one that cannot be
    /// read, [`Failure::Usage`] for a point set that cannot be generated.
    pub fn load2(&self) -> Result<Input, Failure> {
        match self.file_without_draw()? {
            Some(path) => self.table.load2(path),
            None => self.generate(Spec::generate),
        }
    }

    /// Reads or generates points of space; the points of a mesh, if the file is one.
    ///
    /// # Errors
    ///
    /// As [`load2`](Self::load2).
    pub fn load3(&self) -> Result<Input<3>, Failure> {
        match self.file_without_draw()? {
            Some(path) => self.table.load3(path),
            None => self.generate(Spec::generate3),
        }
    }

    /// The dimension of the points, without reading more of them than that takes.
    ///
    /// # Errors
    ///
    /// [`Failure::Usage`] if it is not clear; otherwise as [`load2`](Self::load2).
    pub fn dimension(&self, asked: Option<DimensionArg>) -> Result<DimensionArg, Failure> {
        match (&self.set, self.file_without_draw()?) {
            (Some(spec), _) if asked.is_none() => Ok(DimensionArg::of(spec.dimension())),
            (_, Some(path)) => self.table.dimension(path, asked),
            _ => Ok(asked.unwrap_or(DimensionArg::Plane)),
        }
    }

    /// The file, if there is one.
    fn file_without_draw(&self) -> Result<Option<&Path>, Failure> {
        if self.file.is_some() && (self.draw.count.is_some() || self.draw.seed.is_some()) {
            return Err(Failure::Usage(
                "-n and --seed are for a generated --set; leave them out with a FILE".into(),
            ));
        }
        Ok(self.file.as_deref())
    }

    fn generate<const D: usize>(&self, make: Maker<D>) -> Result<Input<D>, Failure> {
        let missing = || Failure::Usage("give a FILE of points or a --set".into());
        let set = self
            .draw
            .draw(self.set.as_ref().ok_or_else(missing)?, make)?;
        let source = set.headline();
        Input::new(set.points, Vec::new(), source)
    }
}

impl TableArgs {
    /// Reads points of the plane from the file `path`.
    ///
    /// # Errors
    ///
    /// As [`InputArgs::load2`].
    pub fn load2(&self, path: &Path) -> Result<Input, Failure> {
        self.read(path, file::read2)
    }

    /// Reads points of space from the file `path`; the points of a mesh, if the file is one.
    ///
    /// # Errors
    ///
    /// As [`InputArgs::load2`].
    pub fn load3(&self, path: &Path) -> Result<Input<3>, Failure> {
        if MeshFormat::of(path).is_none() {
            return self.read(path, file::read3);
        }
        let points = read_mesh(path)?.points;
        Input::new(points, Vec::new(), format!("{}, a mesh", path.display()))
    }

    /// The dimension of the points in the file `path`: as `asked`, else as many as columns are chosen, else by the
    /// look of the file.
    ///
    /// # Errors
    ///
    /// As [`InputArgs::dimension`].
    pub fn dimension(
        &self,
        path: &Path,
        asked: Option<DimensionArg>,
    ) -> Result<DimensionArg, Failure> {
        let chosen = self.columns.as_ref().map(|Columns(columns)| columns.len());
        if let Some(dimension) = asked.or(chosen.map(DimensionArg::of)) {
            return Ok(dimension);
        }
        if MeshFormat::of(path).is_some() {
            return Ok(DimensionArg::Space);
        }
        let found = file::dimension(path, &self.options(None))?;
        found.map(DimensionArg::of).ok_or_else(|| {
            Failure::Usage(format!(
                "{}: more than three columns hold numbers; choose --columns, or say --dimension 2 or 3 for the first \
                 two or three",
                path.display()
            ))
        })
    }

    fn read<const D: usize>(&self, path: &Path, read: Reader<D>) -> Result<Input<D>, Failure> {
        let columns = match &self.columns {
            None => None,
            Some(Columns(columns)) => Some(columns.clone().try_into().map_err(|_| {
                Failure::Usage(format!(
                    "a point has {D} coordinates here; name {D} --columns"
                ))
            })?),
        };
        let file = read(path, &self.options(columns))?;
        let axes = ["x", "y", "z"].iter().zip(&file.columns);
        let columns: Vec<_> = axes
            .map(|(axis, column)| format!("{axis} in {column}"))
            .collect();
        let source = format!("{}, {}", path.display(), columns.join(", "));
        Input::new(file.points, file.rows, source)
    }

    fn options<const D: usize>(&self, columns: Option<[Column; D]>) -> ReadOptions<D> {
        ReadOptions {
            columns,
            header: match self.header {
                None => Header::Auto,
                Some(HeaderArg::Present) => Header::Present,
                Some(HeaderArg::Absent) => Header::Absent,
            },
            delimiter: self.separator.map(|separator| match separator {
                SeparatorArg::Comma => Delimiter::Comma,
                SeparatorArg::Semicolon => Delimiter::Semicolon,
                SeparatorArg::Tab => Delimiter::Tab,
                SeparatorArg::Blank => Delimiter::Whitespace,
            }),
        }
    }
}

impl DimensionArg {
    fn of(dimension: usize) -> Self {
        match dimension {
            3 => DimensionArg::Space,
            _ => DimensionArg::Plane,
        }
    }
}

impl<const D: usize> Input<D> {
    /// `points` from `source`, point i from line `rows[i]` if there are lines.
    ///
    /// # Errors
    ///
    /// [`Failure::Data`] for a point that is not finite, or too many.
    pub fn new(points: Vec<[f64; D]>, rows: Vec<u64>, source: String) -> Result<Self, Failure> {
        Points::new(&points).map_err(|error| Failure::Data(format!("{source}: {error}")))?;
        Ok(Self {
            points,
            source,
            rows,
        })
    }

    /// The points as the methods take them.
    pub fn view(&self) -> Points<'_, D> {
        Points::new(&self.points).expect("checked when the input was made, and never changed since")
    }

    /// The line of the file that holds point `index`; none for a generated point.
    pub fn line(&self, index: u32) -> Option<u64> {
        self.rows.get(index as usize).copied()
    }

    /// How many points there are when copies count once. O(n log n).
    pub fn distinct(&self) -> usize {
        let mut points = self.points.clone();
        points.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        points.dedup();
        points.len()
    }
}
