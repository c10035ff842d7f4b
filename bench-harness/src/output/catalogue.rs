//! The catalogue of point sets, and a generated set as a file.

use point_sets::{Spec, catalogue, fingerprint};
use std::io::{self, Write};

/// A generated point set with what it takes to make it again.
#[derive(Debug)]
pub struct PointSet<const D: usize = 2> {
    /// The points.
    pub points: Vec<[f64; D]>,
    /// What was asked for.
    pub spec: Spec,
    /// The seed.
    pub seed: u64,
}

impl<const D: usize> PointSet<D> {
    /// Writes the set by `write_csv` under comment lines with its provenance.
    ///
    /// # Errors
    ///
    /// Those of `out`.
    pub fn write<'a>(
        &self,
        out: &'a mut dyn Write,
        write_csv: fn(&'a mut dyn Write, &[[f64; D]]) -> io::Result<()>,
    ) -> io::Result<()> {
        let version = env!("CARGO_PKG_VERSION");
        writeln!(out, "# {}", self.headline())?;
        writeln!(out, "# generator: hullbench {version}, ChaCha8")?;
        write_csv(out, &self.points)
    }

    /// What the set is, on one line.
    pub fn headline(&self) -> String {
        format!(
            "{}, n {}, seed {}, fingerprint {}",
            self.spec,
            self.points.len(),
            self.seed,
            fingerprint(&self.points)
        )
    }
}

/// Writes the catalogue for reading.
///
/// # Errors
///
/// Those of `out`.
pub fn write_catalogue(out: &mut dyn Write) -> io::Result<()> {
    for entry in catalogue() {
        writeln!(out, "{}", entry.name)?;
        writeln!(out, "    {}", entry.summary)?;
        let of = match entry.dimensions() {
            [2] => "points of the plane",
            [3] => "points of space",
            _ => "points of the plane or of space, as the set it is made of",
        };
        writeln!(out, "    {of}")?;
        for parameter in entry.parameters {
            writeln!(
                out,
                "    {}={}  {}",
                parameter.name, parameter.default, parameter.meaning
            )?;
        }
        writeln!(out, "    source: {}\n", entry.source)?;
    }
    writeln!(out, "Parameters follow the name: NAME:PARAMETER=VALUE,...")
}
