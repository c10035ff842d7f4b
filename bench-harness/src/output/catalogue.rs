//! The catalogue of point sets, and a generated set as a file.

use point_sets::{Spec, catalogue, file, fingerprint};
use std::io::{self, Write};

/// A generated point set with what it takes to make it again.
#[derive(Debug)]
pub struct PointSet {
    /// The points.
    pub points: Vec<[f64; 2]>,
    /// What was asked for.
    pub spec: Spec,
    /// The seed.
    pub seed: u64,
}

impl PointSet {
    /// Writes the set as CSV under comment lines with its provenance.
    ///
    /// # Errors
    ///
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let version = env!("CARGO_PKG_VERSION");
        writeln!(out, "# {}", self.headline())?;
        writeln!(out, "# generator: hullbench {version}, ChaCha8")?;
        file::write_csv2(out, &self.points)
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
