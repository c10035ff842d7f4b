//! The papers, regenerated and judged.

use anyhow::Result;
use std::path::PathBuf;

/// The options of `hullbench reproduce`.
#[derive(clap::Args, Clone, Debug)]
pub struct Args {
    /// What to reproduce: a table, a figure or a claim of Green & Silverman (1979) [default: all]
    #[arg(value_name = "ID")]
    ids: Vec<String>,

    /// A smaller run of under a minute
    #[arg(long)]
    quick: bool,

    /// The folder of the report [default: reports/green-silverman-1979, with --quick reports/quick/green-silverman-1979]
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,

    /// The seed from which every point set's seed is derived [default: the definition's]
    #[arg(long)]
    seed: Option<u64>,
}

/// Runs the experiments that the asked-for tables, figures and claims need, and writes the report.
///
/// # Errors
///
/// An unknown ID, a file that cannot be read or written.
pub fn run(args: &Args) -> Result<()> {
    anyhow::bail!("not built yet: {args:?}")
}
