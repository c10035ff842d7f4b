//! The first page of a paper's report.

use super::claims::{predicted, summary};
use super::folder::Folder;
use super::sheet::Sheet;
use crate::reproduce::data::Published;
use crate::reproduce::paper::{Asked, Findings, Paper};
use crate::reproduce::prediction::Checked;
use crate::reproduce::rows::{FailureRow, Records};
use crate::reproduce::verdict::Verdict;
use anyhow::Result;

/// Writes `REPORT.md`.
pub(crate) fn write<P: Paper>(
    folder: &Folder,
    asked: &Asked<P>,
    findings: &Findings<P>,
    verdicts: &[Verdict],
    predictions: &[Checked<'_>],
    published: &Published,
) -> Result<()> {
    let analysis = P::analysis(&findings.studies).trim();
    let mut body = format!("{}\n\n{analysis}\n\n", P::ABOUT);
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
    for topic in &asked.topics {
        body += &format!("- {}\n", topic.line);
    }
    body += &format!("\n{}", certificates::<P>(&findings.records));
    let title = format!("{}, reproduced", P::TITLE);
    folder.markdown("REPORT.md", &title, &body)
}

/// What was proved, and where the rows are.
fn certificates<P: Paper>(records: &Records<P::Rows>) -> String {
    let results: usize = records.sets.iter().map(|row| row.certified).sum();
    let hulls: u64 = records.sizes.iter().map(|row| row.replicates).sum();
    let mut parts = vec![format!(
        "{results} results on {} sets were held against what is certified",
        records.sets.len()
    )];
    parts.extend(
        (hulls > 0).then(|| format!("{hulls} more hulls were certified for their size alone")),
    );
    parts.extend(P::certificates(records));
    let mut text = format!(
        "## Certificates and records\n\n{}; {} results have no certificate.\n\nRows kept in this folder: \
         `records-*.csv`. Sets are named by seed and fingerprint in `records-sets.csv`, or by one digest a cell.\n",
        parts.join("; "),
        records.failures.len()
    );
    if !records.failures.is_empty() {
        text += &format!("\n{}", failures(&records.failures).markdown());
    }
    text
}

/// The first of the failures.
fn failures(rows: &[FailureRow]) -> Sheet {
    let mut sheet = Sheet::new(&["stage", "set", "n", "replicate", "method", "what"]);
    for row in rows.iter().take(20) {
        sheet.push(vec![
            row.stage.clone(),
            row.distribution.clone(),
            row.n.to_string(),
            row.replicate.to_string(),
            row.method.clone(),
            row.what.clone(),
        ]);
    }
    sheet
}
