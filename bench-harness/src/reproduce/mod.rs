//! The papers, regenerated and judged.
//!
//! | module | holds |
//! |---|---|
//! | `paper` | what a paper is to the harness, and how any paper is reproduced |
//! | one folder a paper | what is asked for, its studies, records, verdicts and renderers |
//! | `data` | studies, published figures, claims and predictions, from `data/` |
//! | `recorded`, `rows` | from the records of a measured run to the rows of a paper |
//! | `ratio` | times of one contestant over another's |
//! | `theory` | expected numbers of vertices |
//! | `sets` | the point sets of studies |
//! | `space` | what studies in space share: certificates, counts, exponents |
//! | `timing` | what a study times that is no registered method: samples, interleaved and warm |
//! | `verdict`, `prediction` | outcomes and how parts make a whole; what we expected |
//! | `render` | the pieces of a report: sheets, plots, claims, the first page, the folder |

mod balan;
mod data;
mod day;
mod green_silverman;
mod nathan;
mod paper;
mod prediction;
mod ratio;
mod recorded;
pub(crate) mod render;
mod rows;
mod sets;
mod space;
mod theory;
mod timing;
mod verdict;

use crate::definition::Extent;
use crate::failure::Failure;
use crate::output::target::to_stdout;
use crate::{parallel, progress, provenance};
use anyhow::Result;
use paper::{Entry, Judged, Request, entry};
use provenance::Provenance;
use render::folder::Folder;
use std::path::PathBuf;
use std::time::Instant;

/// Every paper, in the order of the report.
const PAPERS: &[Entry] = &[
    entry::<green_silverman::GreenSilverman>(),
    entry::<day::Day>(),
    entry::<nathan::Nathan>(),
    entry::<balan::Balan>(),
];

/// The options of `hullbench reproduce`.
#[derive(clap::Args, Clone, Debug)]
pub struct Args {
    /// What to reproduce: a paper (green-silverman-1979), a table or figure of one (table1), or a claim (GS-1)
    /// [default: all of every paper]
    #[arg(value_name = "ID")]
    ids: Vec<String>,

    /// All of every paper: what no ID at all means too
    #[arg(long, conflicts_with = "ids")]
    all: bool,

    /// A smaller run, under a minute or two
    #[arg(long)]
    quick: bool,

    /// The folder below which each paper has its own [default: reports, with --quick reports/quick]
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,

    /// The seed from which every point set's seed is derived [default: the definition's]
    #[arg(long)]
    seed: Option<u64>,
}

/// Reproduces what is asked for, a paper after the other, and writes the reports.
///
/// A refuted claim is a result, not an error.
///
/// # Errors
///
/// An unknown ID; a file that cannot be read or written; at the end, results that could not be certified.
pub fn run(args: &Args) -> Result<()> {
    let started = Instant::now();
    let wanted = wanted(PAPERS, &args.ids)?;
    let command = command(args);
    let base = folder(args);
    let extent = if args.quick {
        Extent::Quick
    } else {
        Extent::Full
    };
    let mut judged = Vec::new();
    for (paper, ids) in wanted {
        let folder = base.join(paper.slug);
        let request = Request {
            ids: &ids,
            extent,
            seed: args.seed,
            folder: &folder,
            command: &command,
        };
        judged.push((paper, (paper.run)(&request)?));
    }
    let mut provenance = Provenance::collect(command, args.seed);
    provenance.finish(started.elapsed().as_secs());
    let folder = Folder::open(base, provenance)?;
    write_index(&folder, &judged)?;
    to_stdout(|out| {
        for (_, judged) in &judged {
            for verdict in &judged.verdicts {
                writeln!(out, "{}: {}", verdict.id, verdict.outcome)?;
            }
        }
        writeln!(out, "{}", folder.path().join("REPORT.md").display())
    })?;
    match judged.iter().map(|(_, judged)| judged.uncertified).sum() {
        0_usize => Ok(()),
        count => Err(Failure::Verification(format!(
            "{count} results could not be certified; see the report"
        ))
        .into()),
    }
}

/// The papers that `ids` concern, each with the ids that are its own; none stands for all.
fn wanted<'a>(papers: &'a [Entry], ids: &[String]) -> Result<Vec<(&'a Entry, Vec<String>)>> {
    let mut unknown: Vec<&String> = ids.iter().collect();
    let mut found = Vec::new();
    let mut known = Vec::new();
    for paper in papers {
        let names = (paper.ids)();
        let whole = ids.iter().any(|id| id.eq_ignore_ascii_case(paper.slug));
        let is_own = |id: &&String| names.iter().any(|name| name.eq_ignore_ascii_case(id));
        let own: Vec<String> = ids.iter().filter(is_own).cloned().collect();
        unknown.retain(|id| !is_own(id) && !id.eq_ignore_ascii_case(paper.slug));
        if ids.is_empty() || whole {
            found.push((paper, Vec::new()));
        } else if !own.is_empty() {
            found.push((paper, own));
        }
        known.push(format!("{} ({})", paper.slug, names.join(", ")));
    }
    match unknown.first() {
        None => Ok(found),
        Some(id) => Err(Failure::Usage(format!(
            "nothing to reproduce is called '{id}'; there are {}",
            known.join("; ")
        ))
        .into()),
    }
}

/// The command line, as it would be typed again.
fn command(args: &Args) -> String {
    let mut words = vec!["hullbench reproduce".to_owned()];
    words.extend(args.ids.iter().cloned());
    words.extend(args.quick.then(|| "--quick".to_owned()));
    words.extend(args.seed.map(|seed| format!("--seed {seed}")));
    words.join(" ")
}

fn folder(args: &Args) -> PathBuf {
    let default = if args.quick {
        "reports/quick"
    } else {
        "reports"
    };
    args.out.clone().unwrap_or_else(|| default.into())
}

/// Writes `REPORT.md`, the page that leads to the papers' own.
fn write_index(folder: &Folder, judged: &[(&Entry, Judged)]) -> Result<()> {
    let mut body = String::from(
        "Each paper's tables and figures regenerated, and each of its claims judged by an experiment that could have \
         come out otherwise.\n\n",
    );
    for (paper, judged) in judged {
        body += &format!("## [{}]({}/REPORT.md)\n\n", paper.title, paper.slug);
        if !judged.verdicts.is_empty() {
            let summary = render::claims::summary(&judged.verdicts, &judged.claims);
            body += &format!("{}\n", summary.markdown());
        }
    }
    folder.markdown("REPORT.md", "The papers, reproduced", &body)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn texts(folder: &Path) -> Vec<(String, String)> {
        let entries = std::fs::read_dir(folder).expect("a folder");
        let mut texts: Vec<(String, String)> = entries
            .map(|entry| {
                let path = entry.expect("a file").path();
                let name = path
                    .file_name()
                    .expect("a name")
                    .to_string_lossy()
                    .into_owned();
                (name, std::fs::read_to_string(&path).expect("text"))
            })
            .collect();
        texts.sort();
        texts
    }

    #[test]
    fn every_file_of_a_report_says_where_it_comes_from() {
        let folder = tempfile::tempdir().expect("a folder");
        let args = Args {
            all: false,
            ids: ["figure1", "figure2", "gs-8"].map(str::to_owned).to_vec(),
            quick: true,
            out: Some(folder.path().to_owned()),
            seed: Some(3),
        };
        run(&args).expect("a report");
        let paper = folder.path().join("green-silverman-1979");
        let texts = texts(&paper);
        for (name, text) in &texts {
            let head: String = text.lines().take(20).collect();
            for needed in [
                "command: hullbench reproduce figure1",
                "seed: 3",
                "commit: ",
                "machine: ",
                "date: ",
            ] {
                assert!(head.contains(needed), "{name}: {needed}");
            }
        }
        let names: Vec<&str> = texts.iter().map(|(name, _)| name.as_str()).collect();
        let expected = [
            "REPORT.md",
            "claims.csv",
            "claims.md",
            "figure1.csv",
            "figure1.svg",
            "figure2.csv",
            "figure2.svg",
            "records-rings.csv",
        ];
        assert_eq!(names, expected);
        let report = std::fs::read_to_string(folder.path().join("REPORT.md")).expect("text");
        assert!(report.contains("**CONFIRMED**"));
    }

    #[test]
    fn ids_find_their_papers() {
        let ids = |ids: &[&str]| {
            let ids: Vec<String> = ids.iter().map(|id| (*id).to_owned()).collect();
            wanted(PAPERS, &ids).map(|found| {
                let slug = |(paper, ids): (&Entry, Vec<String>)| (paper.slug, ids);
                found.into_iter().map(slug).collect::<Vec<_>>()
            })
        };
        assert_eq!(ids(&[]).expect("all").len(), PAPERS.len());
        assert_eq!(
            ids(&["green-silverman-1979"]).expect("a paper"),
            [("green-silverman-1979", vec![])]
        );
        let claim = ids(&["gs-8"]).expect("a claim");
        assert_eq!(claim, [("green-silverman-1979", vec!["gs-8".to_owned()])]);
        assert!(
            ids(&["table99"])
                .expect_err("unknown")
                .to_string()
                .contains("'table99'")
        );
    }
}
