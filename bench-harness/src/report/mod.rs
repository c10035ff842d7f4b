//! A recorded run as one HTML file that needs nothing else: no script, no font, no network.
//!
//! ```text
//! run, texts of its definitions, reports of papers  ->  Document  ->  HTML
//! ```
//!
//! What stands in it is what the commands on recorded runs answer, and each section names the command. The numbers come
//! from [`crate::analysis`]; here they are only set out.
//!
//! | module | holds |
//! |---|---|
//! | [`mod@document`] | what a report consists of: sections, tables, figures |
//! | [`asked`] | the questions of the run's definitions, and who was left out |
//! | [`papers`] | the verdicts on the papers, from a folder of reports |
//! | [`matrix`] | a row a case, a column an engine |
//! | `sections` | the sections, a file each |
//! | [`picture`] | drawings that suit light and dark |
//! | [`html`] | the document as HTML |
//! | [`splice`] | the tables between marks of a Markdown file |

pub mod asked;
pub mod document;
pub mod html;
pub mod matrix;
pub mod papers;
pub mod picture;
mod sections;
pub mod splice;

use crate::analysis::published::Figure;
use crate::analysis::targets::Target;
use crate::records::Run;
use anyhow::Result;
use asked::Asked;
use document::Document;
use papers::Paper;

/// What goes into a report.
#[derive(Clone, Copy, Debug)]
pub struct Material<'a> {
    /// The run.
    pub run: &'a Run,
    /// The definitions whose texts lie with it.
    pub asked: &'a [Asked],
    /// What the fast methods are meant to take.
    pub targets: &'a [Target],
    /// Times that the authors of other programs print.
    pub figures: &'a [Figure],
    /// The papers that were reproduced.
    pub papers: &'a [Paper],
    /// The counts to show.
    pub counters: &'a [String],
    /// The engine that the others are compared with; the fastest of each case if there is none.
    pub baseline: Option<&'a str>,
}

/// The report. A pure function: the same material gives the same document.
///
/// # Errors
///
/// A fault of a drawing.
pub fn document(material: &Material<'_>) -> Result<Document> {
    let sections = [
        Some(sections::overview::section(material)),
        sections::verdicts::section(material),
        sections::targets::section(material),
        sections::published::section(material),
        sections::side_by_side::section(material),
        sections::ranking::section(material),
        sections::failures::section(material),
        sections::ratios::section(material)?,
        sections::growth::time(material)?,
        sections::growth::counts(material)?,
        sections::memory::section(material),
        Some(sections::machine::section(material)),
    ];
    let ids = material.run.definitions();
    Ok(Document {
        title: format!("Convex hulls measured: {}", ids.join(", ")),
        lead: "Engines that compute convex hulls, each proved right by an independent checker before it was timed. \
               Nothing is timed that is not proved; nothing is claimed inside the noise of a program against itself."
            .to_owned(),
        sections: sections.into_iter().flatten().collect(),
    })
}

/// What an algorithm asks most, and how often it looks at a point: the counts that tell methods apart.
const TELLING: [&str; 4] = [
    "questions",
    "orientations",
    "orientations-in-space",
    "visits",
];

/// The counts that a report shows if none is named: the telling ones, or every count if there is none of these.
pub fn usual_counters(run: &Run) -> Vec<String> {
    let known = run.counters();
    let telling = known.iter().filter(|counter| TELLING.contains(counter));
    let telling: Vec<String> = telling.map(|counter| (*counter).to_owned()).collect();
    if !telling.is_empty() {
        return telling;
    }
    let others = known
        .into_iter()
        .filter(|counter| *counter != sections::memory::COUNTER);
    others.map(str::to_owned).collect()
}

/// The engine that the others are compared with if none is named: the sorting yardstick, if every timed case has it.
pub fn usual_baseline(run: &Run) -> Option<&'static str> {
    const SORT: &str = "sort";
    let cases = run.cases().into_iter();
    let mut timed = cases
        .map(|case| run.timed(case))
        .filter(|engines| !engines.is_empty())
        .peekable();
    timed.peek()?;
    timed.all(|engines| engines.contains(&SORT)).then_some(SORT)
}

/// A command on the run, as it is typed.
fn command(run: &Run, verb: &str, options: &str) -> String {
    let folder = match run.folder.to_string_lossy() {
        folder if folder.is_empty() => "RUN".into(),
        folder => folder,
    };
    let words = ["hullbench", verb, &folder, options];
    words.map(str::trim).join(" ").trim().to_owned()
}
