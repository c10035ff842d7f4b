//! `hullbench methods`: the registered methods.

use crate::commands::select;
use crate::failure::Failure;
use crate::output::methods::{write_entry, write_list_json, write_table};
use crate::output::target::to_stdout;
use clap::ValueEnum;

const EXAMPLES: &str = "\
Examples:
  hullbench methods
  hullbench methods gs
  hullbench methods --format json

Exit codes:
  0 done   2 usage, such as a slug that is not registered   4 standard output could not be written";

/// The arguments of `hullbench methods`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Show everything about this method: publication, cost, departures
    #[arg(value_name = "SLUG")]
    slug: Option<String>,

    /// A table for reading, or JSON with everything
    #[arg(long, value_enum, default_value = "table")]
    format: ListFormat,
}

/// How a list is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ListFormat {
    /// Aligned columns
    Table,
    /// A JSON array
    Json,
}

/// Lists the methods.
///
/// # Errors
///
/// [`Failure::Usage`] for a slug that is not registered; [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let chosen = args.slug.as_deref().map(select::any).transpose()?;
    let all: Vec<_> = chosen.map_or_else(|| hullkit::methods().collect(), |one| vec![one]);
    to_stdout(|out| match (args.format, chosen) {
        (ListFormat::Json, _) => write_list_json(out, &all),
        (ListFormat::Table, Some(method)) => write_entry(out, method),
        (ListFormat::Table, None) => write_table(out, &all),
    })
}
