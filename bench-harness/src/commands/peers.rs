//! `hullbench peers`: outside programs, built and asked who they are.

use crate::commands::methods::ListFormat;
use crate::commands::select;
use crate::engine::catalogue::{Entry, Places};
use crate::engine::client::Session;
use crate::engine::peers::build::{self, Outcome};
use crate::engine::peers::{self, Peer, Program};
use crate::engine::protocol::{Problem, Receipt};
use crate::failure::Failure;
use crate::output::peers::{Line, write_list_json, write_outcomes, write_table};
use crate::output::target::{note, to_stdout};
use std::path::PathBuf;
use std::time::Duration;

const EXAMPLES: &str = "\
Peers are programs of others that answer the same questions: Qhull, CGAL, Boost.Geometry, GEOS, SciPy, Rust crates.
Nothing is ever installed: what is missing is named, and everything else works without.

Examples:
  hullbench peers list
  hullbench peers build
  hullbench peers build qhull cgal-3d

Exit codes:
  0 done   1 a peer that was named is missing   2 usage, such as a name that is none   4 the output could not be
  written";

/// The arguments of `hullbench peers`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(clap::Subcommand, Clone, Debug)]
enum Action {
    /// Builds the peers that can be built, and says what is missing for the others
    #[command(after_help = EXAMPLES)]
    Build(Selection),
    /// Every peer: what it computes, and its version or what is missing
    #[command(after_help = EXAMPLES)]
    List {
        #[command(flatten)]
        selection: Selection,

        /// A table for reading, or JSON with everything
        #[arg(long, value_enum, default_value = "table")]
        format: ListFormat,
    },
}

#[derive(clap::Args, Clone, Debug)]
struct Selection {
    /// Only these, by the name of a peer or of a program that is several
    #[arg(value_name = "NAME")]
    names: Vec<String>,

    /// The folder of their sources [default: bench-harness/peers of the workspace]
    #[arg(long, value_name = "FOLDER")]
    sources: Option<PathBuf>,

    /// The folder to build in [default: target/peers of the workspace]
    #[arg(long, value_name = "FOLDER")]
    cache: Option<PathBuf>,
}

impl Selection {
    fn places(&self) -> Result<Places, Failure> {
        Places::find(self.sources.as_deref(), self.cache.as_deref())
            .map_err(|error| Failure::io("the current folder", &error, "start from another one"))
    }

    /// Whether `peer` of `program` is among those asked for.
    fn takes(&self, program: &Program, peer: &Peer) -> bool {
        let named = |name: &String| name == program.name || name == peer.name;
        self.names.is_empty() || self.names.iter().any(named)
    }

    fn check_names(&self) -> Result<(), Failure> {
        let known = || {
            let programs = peers::PROGRAMS.iter().map(|program| program.name);
            programs.chain(peers::all().map(|(_, peer)| peer.name))
        };
        for name in &self.names {
            if peers::program(name).is_none() {
                let hint = match select::nearest(name, known()) {
                    Some(near) => format!("did you mean '{near}'? "),
                    None => String::new(),
                };
                return Err(Failure::Usage(format!(
                    "there is no peer '{name}'; {hint}`hullbench peers list` lists them all"
                )));
            }
        }
        Ok(())
    }

    /// A failure that names what was asked for by name and is `missing`.
    fn judge(&self, missing: &[&str]) -> Result<(), Failure> {
        if self.names.is_empty() || missing.is_empty() {
            return Ok(());
        }
        Err(Failure::Verification(format!(
            "not there: {}; what is missing is said above",
            missing.join(", ")
        )))
    }
}

/// Builds or lists peers.
///
/// # Errors
///
/// [`Failure::Verification`] if a peer that was named is missing; [`Failure::Usage`]; [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    match &args.action {
        Action::Build(selection) => build_all(selection),
        Action::List { selection, format } => list(selection, *format),
    }
}

fn build_all(selection: &Selection) -> Result<(), Failure> {
    selection.check_names()?;
    let places = selection.places()?;
    let mut outcomes = Vec::new();
    for program in peers::PROGRAMS {
        if program
            .engines
            .iter()
            .any(|peer| selection.takes(program, peer))
        {
            note(&format!("{} …", program.name));
            outcomes.push((program, build::build(program, &places)));
        }
    }
    to_stdout(|out| write_outcomes(out, &outcomes))?;
    let is_there = |outcome: &Outcome| matches!(outcome, Outcome::Ready | Outcome::Built);
    let missing = outcomes.iter().filter(|(_, outcome)| !is_there(outcome));
    selection.judge(&missing.map(|(program, _)| program.name).collect::<Vec<_>>())
}

fn list(selection: &Selection, format: ListFormat) -> Result<(), Failure> {
    selection.check_names()?;
    let places = selection.places()?;
    let chosen = peers::all().filter(|(program, peer)| selection.takes(program, peer));
    let lines: Vec<Line> = chosen
        .map(|(program, peer)| line(program, peer, &places))
        .collect();
    to_stdout(|out| match format {
        ListFormat::Table => write_table(out, &lines),
        ListFormat::Json => write_list_json(out, &lines),
    })?;
    let missing = lines.iter().filter(|line| line.receipt.is_err());
    selection.judge(&missing.map(|line| line.name).collect::<Vec<_>>())
}

fn line(program: &'static Program, peer: &'static Peer, places: &Places) -> Line {
    let missing = |fault: String| {
        let needs = build::missing(program);
        if needs.is_empty() {
            fault
        } else {
            format!("not built: needs {}", needs.join(" and "))
        }
    };
    Line {
        name: peer.name,
        program: program.name,
        problems: peer
            .problems
            .iter()
            .map(|problem| Problem::word(*problem))
            .collect(),
        about: peer.about,
        receipt: receipt(Entry::Peer(program, peer), places).map_err(missing),
    }
}

/// What the engine says of itself.
fn receipt(entry: Entry, places: &Places) -> Result<Receipt, String> {
    /// Interpreters take their time to import.
    const LIMIT: Duration = Duration::from_secs(30);
    let session = entry
        .launch(places)
        .and_then(|launch| Session::start(&launch, LIMIT))
        .map_err(|fault| fault.to_string())?;
    let receipt = session.receipt().clone();
    session.quit(Duration::from_secs(1));
    Ok(receipt)
}
