//! Where a result goes, in which format, and the one way to write it there.

use crate::failure::Failure;
use crate::output::atomic::{self, Existing};
use clap::{Args, ValueEnum};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// The options that say where a result goes.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Output")]
pub struct OutputArgs {
    /// Write the result to FILE instead of a summary to standard output; `-` is standard output
    ///
    /// The file appears whole or not at all.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Write the result in this format [default: by the extension of FILE, csv for `-`]; not every result has all
    #[arg(long, value_enum, value_name = "FORMAT")]
    format: Option<Format>,

    /// Replace FILE if it exists
    #[arg(long, requires = "output")]
    force: bool,
}

/// A format that other programs read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Comma-separated values with a header line
    Csv,
    /// One JSON object
    Json,
    /// Points and polygons, Object File Format
    Off,
    /// Points and polygons, Wavefront
    Obj,
    /// Points and polygons, Stanford, binary
    Ply,
    /// The same as text
    PlyText,
    /// Triangles, binary, rounded to single precision
    Stl,
    /// A drawing
    Svg,
    /// Tables that read well as text too
    #[value(name = "md")]
    Markdown,
    /// Tables for the package booktabs
    #[value(name = "tex")]
    Latex,
}

/// What the user wants to have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Delivery {
    /// A summary for reading, on standard output.
    Summary,
    /// The whole result.
    Data {
        /// Where to.
        target: Target,
        /// In which format.
        format: Format,
    },
}

/// Where bytes go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Target {
    /// Standard output.
    Stdout,
    /// A file.
    File {
        /// Its path.
        path: PathBuf,
        /// What to do if it exists.
        existing: Existing,
    },
}

/// A certified result that can be written in every way a command offers.
pub trait Report {
    /// The formats in which it can be written.
    const FORMATS: &'static [Format];

    /// Writes the whole result in one of its formats.
    ///
    /// # Errors
    ///
    /// Those of `out`; [`io::ErrorKind::InvalidInput`] if the format cannot hold this result.
    fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()>;

    /// Writes a summary for reading.
    ///
    /// # Errors
    ///
    /// Those of `out`.
    fn write_summary(&self, out: &mut dyn Write) -> io::Result<()>;

    /// What the result holds, in a few words.
    fn headline(&self) -> String;

    /// What is lost in a format, if anything is.
    fn warning(&self, _format: Format) -> Option<String> {
        None
    }
}

impl Delivery {
    /// Delivers `report`.
    ///
    /// # Errors
    ///
    /// [`Failure::Io`]; [`Failure::Closed`] if nobody reads standard output any more.
    pub fn send(&self, report: &impl Report) -> Result<(), Failure> {
        match self {
            Delivery::Summary => to_stdout(|out| report.write_summary(out)),
            Delivery::Data { target, format } => {
                target.write(|out| report.write(out, *format))?;
                target.note(&report.headline());
                if let Some(warning) = report.warning(*format) {
                    note(&format!("warning: {warning}"));
                }
                Ok(())
            }
        }
    }
}

impl OutputArgs {
    /// What is asked for, in one of `formats`. Neither a file nor a format asks for a summary.
    ///
    /// # Errors
    ///
    /// [`Failure::Usage`] if the format is another or the extension names none, [`Failure::Io`] if the file could
    /// not be written.
    pub fn delivery(&self, formats: &[Format]) -> Result<Delivery, Failure> {
        let format = match (self.format, &self.output) {
            (None, None) => return Ok(Delivery::Summary),
            (Some(format), _) => format,
            (None, Some(path)) => Format::of(path, formats)?,
        };
        if !formats.contains(&format) {
            return Err(Failure::Usage(format!(
                "this result cannot be written as {}; take one of {}",
                format.name(),
                names(formats).join(", ")
            )));
        }
        let existing = if self.force {
            Existing::Replace
        } else {
            Existing::Keep
        };
        let target = Target::new(self.output.as_deref(), existing)?;
        Ok(Delivery::Data { target, format })
    }
}

impl Format {
    /// The one of `formats` that a file has by its extension; CSV for `-`.
    fn of(path: &Path, formats: &[Format]) -> Result<Self, Failure> {
        if path == Path::new("-") {
            return Ok(Format::Csv);
        }
        let extension = path.extension().and_then(|extension| extension.to_str());
        let extension = extension.map(str::to_ascii_lowercase).unwrap_or_default();
        let named = |format: &&Format| format.name() == extension;
        formats.iter().find(named).copied().ok_or_else(|| {
            Failure::Usage(format!(
                "{}: the extension names no format of this result; use one of .{}, or add --format",
                path.display(),
                names(formats).join(", .")
            ))
        })
    }

    /// Its name on the command line, which is also the extension of its files.
    fn name(self) -> &'static str {
        match self {
            Format::Csv => "csv",
            Format::Json => "json",
            Format::Off => "off",
            Format::Obj => "obj",
            Format::Ply => "ply",
            Format::PlyText => "ply-text",
            Format::Stl => "stl",
            Format::Svg => "svg",
            Format::Markdown => "md",
            Format::Latex => "tex",
        }
    }

    /// The failure to write a result in a format that it does not have.
    ///
    /// # Errors
    ///
    /// Always.
    pub fn refuse(self) -> io::Result<()> {
        let text = format!("this result has no {} form", self.name());
        Err(io::Error::new(io::ErrorKind::InvalidInput, text))
    }
}

impl Target {
    /// The target `path`, or standard output for none and for `-`.
    ///
    /// # Errors
    ///
    /// [`Failure::Io`] if the file exists and is to be kept, or its folder does not exist.
    pub fn new(path: Option<&Path>, existing: Existing) -> Result<Self, Failure> {
        let Some(path) = path.filter(|path| *path != Path::new("-")) else {
            return Ok(Target::Stdout);
        };
        atomic::refuse_to_replace(path, existing).map_err(|error| cannot_write(path, &error))?;
        Ok(Target::File {
            path: path.to_path_buf(),
            existing,
        })
    }

    /// Writes what `content` writes.
    ///
    /// # Errors
    ///
    /// [`Failure::Io`]; [`Failure::Closed`] if nobody reads standard output any more.
    pub fn write(
        &self,
        content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Failure> {
        match self {
            Target::Stdout => to_stdout(content),
            Target::File { path, existing } => {
                atomic::write(path, *existing, content).map_err(|error| cannot_write(path, &error))
            }
        }
    }

    /// Says on standard error what was written, if it went to a file.
    pub fn note(&self, what: &str) {
        if let Target::File { path, .. } = self {
            note(&format!("{}: {what}", path.display()));
        }
    }
}

/// Writes what `content` writes to standard output.
///
/// # Errors
///
/// [`Failure::Io`]; [`Failure::Closed`] if nobody reads standard output any more.
pub fn to_stdout(content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    content(&mut out)
        .and_then(|()| out.flush())
        .map_err(|error| Failure::io("standard output", &error, "check where it leads"))
}

/// Writes one line to standard error. A standard error that nobody reads is no reason to stop.
pub fn note(line: &str) {
    let _ = writeln!(io::stderr().lock(), "{line}");
}

fn names(formats: &[Format]) -> Vec<&'static str> {
    formats.iter().map(|format| format.name()).collect()
}

fn cannot_write(path: &Path, error: &io::Error) -> Failure {
    let path_shown = path.display();
    match error.kind() {
        io::ErrorKind::AlreadyExists => Failure::Io(format!(
            "{path_shown}: the file exists; add --force to replace it, or choose another name"
        )),
        io::ErrorKind::IsADirectory => Failure::Io(format!(
            "{path_shown}: is a folder; give the name of a file in it"
        )),
        io::ErrorKind::NotFound => Failure::Io(format!(
            "{path_shown}: the folder to write in does not exist; create it first"
        )),
        io::ErrorKind::InvalidInput => {
            Failure::Data(format!("{path_shown}: {error}; choose another format"))
        }
        _ => Failure::io(path_shown, error, "choose a place you can write to"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_names_the_format() {
        let of = |path: &str| Format::of(Path::new(path), &[Format::Csv, Format::Json]);
        assert_eq!(of("a/b.CSV").unwrap(), Format::Csv);
        assert_eq!(of("b.json").unwrap(), Format::Json);
        assert_eq!(of("-").unwrap(), Format::Csv);
        for unknown in ["b", "b.txt", ".csv", "b.ply"] {
            let failure = of(unknown).unwrap_err();
            assert!(matches!(failure, Failure::Usage(_)), "{unknown}");
        }
    }

    #[test]
    fn neither_file_nor_format_asks_for_a_summary() {
        let args = OutputArgs {
            output: None,
            format: None,
            force: false,
        };
        assert_eq!(args.delivery(&[Format::Csv]).unwrap(), Delivery::Summary);
    }

    #[test]
    fn a_format_alone_goes_to_standard_output() {
        let args = OutputArgs {
            output: None,
            format: Some(Format::Json),
            force: false,
        };
        let expected = Delivery::Data {
            target: Target::Stdout,
            format: Format::Json,
        };
        assert_eq!(args.delivery(&[Format::Json]).unwrap(), expected);
        assert!(args.delivery(&[Format::Csv]).is_err());
    }
}
