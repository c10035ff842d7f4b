//! `hullbench report`: a recorded run as one HTML file.

use crate::analysis::cmp::cmp;
use crate::analysis::targets::{Target, targets};
use crate::analysis::threads;
use crate::commands::published::figures;
use crate::commands::recorded::{latest, load, unknown};
use crate::commands::targets as known_targets;
use crate::failure::Failure;
use crate::output::atomic::{self, Existing};
use crate::output::target::note;
use crate::records::Run;
use crate::report::splice::splice;
use crate::report::{
    Material, asked, document, html, matrix, papers, usual_baseline, usual_counters,
};
use clap::ValueHint;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Component, Path, PathBuf};

const EXAMPLES: &str = "\
One file that opens from disk: overview, engines side by side, ranks, who fails where, ratios, growth, counts, memory,
machine and method, each with the command that gives the same numbers. It has no script and asks nothing of the network.
With --papers, the verdicts on the papers and their tables beside ours.

--splice replaces what stands in a Markdown file between the lines
  <!-- report:NAME -->
  <!-- /report:NAME -->
by the table of the definition NAME: a row a point set and size, a column an engine, time over that of the baseline; the
tables of `hullbench targets` where NAME is targets or threads. Engines named after NAME are the columns.

Examples:
  hullbench report
  hullbench report runs/curated
  hullbench report runs/curated -o report.html --papers reports
  hullbench report runs/curated --splice README.md --baseline fast-2d

Exit codes:
  0 done   2 usage   3 bad records or marks   4 a file could not be read or written";

/// The names of the marks between which the tables of targets stand.
const TARGETS: &str = "targets";
const THREADS: &str = "threads";

/// The arguments of `hullbench report`.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of a recorded run [default: the one below runs/ that was written last]
    #[arg(value_name = "RUN", value_hint = ValueHint::DirPath)]
    run: Option<PathBuf>,

    /// Write the report to FILE, and replace one that is there [default: report.html in the run's folder]
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: Option<PathBuf>,

    /// Show the papers too, as `hullbench reproduce` wrote them to this folder
    #[arg(long, value_name = "FOLDER", value_hint = ValueHint::DirPath)]
    papers: Option<PathBuf>,

    /// Refresh the tables of this Markdown file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    splice: Option<PathBuf>,

    /// Compare with this engine [default: sort, if it was timed everywhere, or the fastest of each case]
    #[arg(long, value_name = "ENGINE", value_hint = ValueHint::Other)]
    baseline: Option<String>,

    /// Show this count [default: orientations and visits, or all if these were not counted]; may be given several times
    #[arg(long = "counter", value_name = "COUNTER", value_hint = ValueHint::Other)]
    counters: Vec<String>,
}

/// Reads, sets out and writes.
///
/// # Errors
///
/// [`Failure::Usage`] for a counter or an engine that the run does not have; [`Failure::Data`], [`Failure::Io`].
pub fn run(args: &Args) -> Result<(), Failure> {
    let folder = match &args.run {
        Some(folder) => folder.clone(),
        None => latest()?,
    };
    let run = load(&folder)?;
    check_names(args, &run)?;
    let counters = match args.counters.is_empty() {
        true => usual_counters(&run),
        false => args.counters.clone(),
    };
    let output = args
        .output
        .clone()
        .unwrap_or_else(|| folder.join("report.html"));
    let mut found = match &args.papers {
        Some(folder) => papers::read(folder)?,
        None => Vec::new(),
    };
    for paper in &mut found {
        paper.report = seen_from(&output, &paper.report);
    }
    let all = known_targets::all()?;
    let spliced = args
        .splice
        .as_deref()
        .map(|path| spliced(path, &run, &all, args));
    let spliced = spliced.transpose()?;
    let material = Material {
        run: &run,
        asked: &asked::of_run(&folder)?,
        targets: &all,
        figures: &figures()?,
        papers: &found,
        counters: &counters,
        baseline: baseline(args, &run),
    };
    let text = html::html(&document(&material)?)?;
    write(&output, &text)?;
    note(&format!("{}: the report", output.display()));
    if let (Some(path), Some((page, tables))) = (&args.splice, spliced) {
        write(path, &page)?;
        note(&format!("{}: {tables} tables", path.display()));
    }
    Ok(())
}

fn baseline<'a>(args: &'a Args, run: &Run) -> Option<&'a str> {
    args.baseline.as_deref().or_else(|| usual_baseline(run))
}

fn check_names(args: &Args, run: &Run) -> Result<(), Failure> {
    let known = run.counters();
    if let Some(counter) = args.counters.iter().find(|c| !known.contains(&c.as_str())) {
        return Err(unknown("counter", counter, &known));
    }
    let timed = run.cases().into_iter().flat_map(|case| run.timed(case));
    let engines: BTreeSet<&str> = timed.collect();
    match &args.baseline {
        Some(baseline) if !engines.contains(baseline.as_str()) => {
            let known: Vec<&str> = engines.into_iter().collect();
            Err(unknown("engine", baseline, &known))
        }
        _ => Ok(()),
    }
}

/// The page at `path` with the tables of `run`, and how many they are.
fn spliced(
    path: &Path,
    run: &Run,
    all: &[Target],
    args: &Args,
) -> Result<(String, usize), Failure> {
    let page = fs::read_to_string(path)
        .map_err(|error| Failure::io(path.display(), &error, "check the name"))?;
    let answered = cmp(run, baseline(args, run));
    let table = |name: &str, engines: &[&str]| {
        if name == TARGETS {
            let found = targets(run, all);
            return Ok(found.page().long.markdown());
        }
        if name == THREADS {
            return Ok(threads::sheet(&threads::gains(run)).markdown());
        }
        let known = run.definitions();
        if !known.contains(&name) {
            return Err(format!(
                "the run has no definition '{name}'; it has {}",
                known.join(", ")
            ));
        }
        let table = matrix::ratios(run, &answered, name)
            .ok_or_else(|| format!("nothing of '{name}' was timed"))?;
        let table = match engines {
            [] => table,
            named => table
                .only(matrix::LEAD.len(), named)
                .ok_or_else(|| format!("not all of {} were timed", named.join(", ")))?,
        };
        Ok(table.markdown())
    };
    splice(&page, table).map_err(|fault| Failure::Data(format!("{}:{fault}", path.display())))
}

fn write(path: &Path, text: &str) -> Result<(), Failure> {
    atomic::write(path, Existing::Replace, |out| {
        out.write_all(text.as_bytes())
    })
    .map_err(|error| Failure::io(path.display(), &error, "choose a place you can write to"))
}

/// `file` as a link in `page`: relative to its folder.
fn seen_from(page: &Path, file: &Path) -> PathBuf {
    let folder = match page.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let (Ok(folder), Ok(file)) = (folder.canonicalize(), file.canonicalize()) else {
        return file.to_path_buf();
    };
    let shared = folder.components().zip(file.components());
    let shared = shared.take_while(|(a, b)| a == b).count();
    let up = folder
        .components()
        .skip(shared)
        .map(|_| Component::ParentDir);
    up.chain(file.components().skip(shared)).collect()
}
