//! The report's first page, and the claims.

use crate::reproduce::day::published::Published;
use crate::reproduce::day::records::Records;
use crate::reproduce::day::topics::Topic;
use crate::reproduce::prediction::Checked;
use crate::reproduce::render::claims::{long, predicted, section, summary};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use crate::reproduce::verdict::Verdict;
use anyhow::Result;

/// Writes `claims.md` and `claims.csv`.
pub(crate) fn write_claims(
    folder: &Folder,
    verdicts: &[Verdict],
    predictions: &[Checked<'_>],
    published: &Published,
) -> Result<()> {
    let mut body = String::from(
        "The claims are the paper's, in our words. A verdict is computed from the records of this run and holds for \
         the range it names.\n\n",
    );
    for verdict in verdicts {
        body += &section(verdict, &published.claims);
    }
    body += &format!(
        "## Predictions published before the run\n\n{}",
        predicted(predictions).markdown()
    );
    folder.markdown("claims.md", "The claims of Day (1990)", &body)?;
    folder.csv("claims.csv", &long(verdicts).csv())
}

/// Writes `REPORT.md`.
pub(crate) fn write(
    folder: &Folder,
    analysis: &str,
    topics: &[Topic],
    records: &Records,
    verdicts: &[Verdict],
    predictions: &[Checked<'_>],
    published: &Published,
) -> Result<()> {
    let mut body = String::from(
        "A. M. Day, *The Implementation of an Algorithm to Find the Convex Hull of a Set of Three-Dimensional Points*, ACM \
         Transactions on Graphics 9(1), 1990: Preparata and Hong's divide and conquer made to run. The paper prints no table; \
         its claims are judged here, and what it reports in words is measured.\n\n",
    );
    body += &format!("{}\n\n", analysis.trim());
    if !verdicts.is_empty() {
        body += &format!(
            "## Verdicts\n\n{}\nDetails: [claims.md](claims.md)\n\n",
            summary(verdicts, &published.claims).markdown()
        );
    }
    let predicted = predicted(predictions);
    if !verdicts.is_empty() && !predicted.is_empty() {
        body += &format!("## Predictions\n\n{}\n", predicted.markdown());
    }
    body += "## Tables and figures\n\n";
    for line in topics.iter().filter_map(line) {
        body += &format!("- {line}\n");
    }
    body += &format!("\n{}", certificates(records));
    folder.markdown("REPORT.md", "Day (1990), reproduced", &body)
}

fn line(topic: &Topic) -> Option<&'static str> {
    Some(match topic {
        Topic::Precision => {
            "[Precision and eps2](precision.md): [figure](precision.svg), data: [ends](outcomes.csv), \
             [thresholds](thresholds.csv), [times](formats.csv)"
        }
        Topic::Merge => {
            "[The merge: questions at the top](merge.md): [figure](merge.svg), data: [growth](merge-growth.csv), \
             [by size](merge-sizes.csv)"
        }
        Topic::Edges => {
            "[Edge records made, and in use](edges.md): [figure](edges.svg), [data](edge-records.csv)"
        }
        Topic::Whole => {
            "[The whole call: questions, laws, times](whole.md): [figure](whole.svg), data: [questions](whole.csv), \
             [laws](laws.csv), [times](whole-times.csv)"
        }
        Topic::Degenerate => "[Degenerate sets](degenerate.md), [data](degenerate.csv)",
        Topic::Bases => {
            "[Where the recursion stops, and dummy points](bases.md), [data](bases.csv)"
        }
        Topic::Listing => "[Listing the faces by a spiral](spiral.md), [data](spiral.csv)",
        Topic::Checks => "[The paper's own check](checks.md), [data](checks.csv)",
        Topic::Parallel => "[Side by side](side-by-side.md), [data](side-by-side.csv)",
        Topic::Claim(_) => return None,
    })
}

/// What was proved, and where the rows are.
fn certificates(records: &Records) -> String {
    let results: usize = records.sets.iter().map(|row| row.certified).sum();
    let rounded: usize = records.controls.iter().map(|row| row.right).sum();
    let mut text = format!(
        "## Certificates and records\n\n{results} results on {} sets were held against a certified hull; {rounded} hulls of \
         rounded sets were certified for the study of precision; {} results have no certificate.\n\nRows kept in this \
         folder: `records-*.csv`. Sets are named by seed and fingerprint in `records-sets.csv`, or by one digest a cell.\n",
        records.sets.len(),
        records.failures.len()
    );
    if !records.failures.is_empty() {
        let mut sheet = Sheet::new(&["stage", "set", "n", "replicate", "method", "what"]);
        for row in records.failures.iter().take(20) {
            sheet.push(vec![
                row.stage.clone(),
                row.distribution.clone(),
                row.n.to_string(),
                row.replicate.to_string(),
                row.method.clone(),
                row.what.clone(),
            ]);
        }
        text += &format!("\n{}", sheet.markdown());
    }
    text
}
