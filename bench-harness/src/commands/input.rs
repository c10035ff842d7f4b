//! Where points come from: a file, or a point set from the catalogue.

use crate::failure::Failure;
use crate::output::catalogue::PointSet;
use clap::Args;
use geometry_core::hull2::sort_distinct;
use geometry_core::{Exact, Points};
use point_sets::Spec;
use point_sets::file::{Column, ReadOptions, read2};
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

    /// The columns that hold the coordinates, by name or by number from 1
    ///
    /// By default those that the header names as a pair, such as x and y or lon and lat, else the first two that
    /// hold numbers.
    #[arg(long, value_name = "X,Y", conflicts_with = "set", value_parser = parse_columns)]
    columns: Option<[Column; 2]>,

    /// Take a generated point set in place of a file (see `hullbench points --list`)
    #[arg(long, value_name = "SPEC")]
    set: Option<Spec>,

    #[command(flatten)]
    draw: DrawArgs,
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

impl DrawArgs {
    /// The points of `spec`.
    ///
    /// # Errors
    ///
    /// [`Failure::Usage`] if the set has no such size.
    pub fn draw(&self, spec: &Spec) -> Result<PointSet, Failure> {
        let count = self.count.or_else(|| spec.size());
        let seed = self.seed.unwrap_or(DEFAULT_SEED);
        let points = spec
            .generate(count.unwrap_or(DEFAULT_COUNT), seed)
            .map_err(|error| Failure::Usage(error.to_string()))?;
        Ok(PointSet {
            points,
            spec: spec.clone(),
            seed,
        })
    }
}

fn parse_columns(text: &str) -> Result<[Column; 2], String> {
    let columns: Vec<Column> = text
        .split(',')
        .filter(|column| !column.trim().is_empty())
        .map(|column| {
            column
                .parse()
                .unwrap_or_else(|never: Infallible| match never {})
        })
        .collect();
    columns
        .try_into()
        .map_err(|_| "name two columns, such as lon,lat or 1,2".into())
}

/// Points that are finite and can be indexed, and where they came from.
#[derive(Clone, Debug)]
pub struct Input {
    /// The points, in the order of the input.
    pub points: Vec<[f64; 2]>,
    /// Where they came from, in words.
    pub source: String,
    rows: Vec<u64>,
}

impl InputArgs {
    /// Reads or generates the points.
    ///
    /// # Errors
    ///
    /// [`Failure::Data`] for a file that is not what it should be, [`Failure::Io`] for one that cannot be
    /// read, [`Failure::Usage`] for a point set that cannot be generated.
    pub fn load(&self) -> Result<Input, Failure> {
        match (&self.file, &self.set) {
            (Some(path), _) => self.read(path),
            (None, Some(spec)) => self.generate(spec),
            (None, None) => Err(Failure::Usage("give a FILE of points or a --set".into())),
        }
    }

    fn read(&self, path: &Path) -> Result<Input, Failure> {
        if self.draw.count.is_some() || self.draw.seed.is_some() {
            return Err(Failure::Usage(
                "-n and --seed are for a generated --set; leave them out with a FILE".into(),
            ));
        }
        let options = ReadOptions {
            columns: self.columns.clone(),
            ..ReadOptions::default()
        };
        let file = read2(path, &options)?;
        let [x, y] = file.columns;
        let source = format!("{}, x in {x}, y in {y}", path.display());
        Input::new(file.points, file.rows, source)
    }

    fn generate(&self, spec: &Spec) -> Result<Input, Failure> {
        let set = self.draw.draw(spec)?;
        let source = set.headline();
        Input::new(set.points, Vec::new(), source)
    }
}

impl Input {
    fn new(points: Vec<[f64; 2]>, rows: Vec<u64>, source: String) -> Result<Self, Failure> {
        Points::new(&points).map_err(|error| Failure::Data(format!("{source}: {error}")))?;
        Ok(Self {
            points,
            source,
            rows,
        })
    }

    /// The points as the methods take them.
    pub fn view(&self) -> Points<'_, 2> {
        Points::new(&self.points).expect("checked when the input was made, and never changed since")
    }

    /// The line of the file that holds point `index`; none for a generated point.
    pub fn line(&self, index: u32) -> Option<u64> {
        self.rows.get(index as usize).copied()
    }

    /// How many points there are when copies count once. O(n log n).
    pub fn distinct(&self) -> usize {
        let points = self.view();
        let mut ids: Vec<u32> = points.ids().collect();
        sort_distinct(points, &mut ids, &Exact);
        ids.len()
    }
}
