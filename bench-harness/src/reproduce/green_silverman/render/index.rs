//! The report's first page.

use crate::reproduce::green_silverman::definition::Definition;
use crate::reproduce::green_silverman::published::Published;
use crate::reproduce::green_silverman::records::Records;
use crate::reproduce::green_silverman::topics::Topic;
use crate::reproduce::prediction::Checked;
use crate::reproduce::render::claims::{predicted, summary};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::Sheet;
use crate::reproduce::verdict::Verdict;
use anyhow::Result;

/// Writes `REPORT.md`.
pub(crate) fn write(
    folder: &Folder,
    definition: &Definition,
    topics: &[Topic],
    records: &Records,
    verdicts: &[Verdict],
    predictions: &[Checked<'_>],
    published: &Published,
) -> Result<()> {
    let mut body = String::from(
        "P. J. Green and B. W. Silverman, *Constructing the convex hull of a set of points in the plane*, The \
         Computer Journal 22(3), 262–266, 1979: its tables and figures regenerated, its claims judged.\n\n",
    );
    body += &format!("{}\n\n", definition.analysis.trim());
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
    for topic in topics {
        if let Some(line) = line(topic) {
            body += &format!("- {line}\n");
        }
    }
    body += &format!("\n{}", certificates(records));
    folder.markdown("REPORT.md", "Green & Silverman (1979), reproduced", &body)
}

fn line(topic: &Topic) -> Option<&'static str> {
    Some(match topic {
        Topic::Table1 => "[Table 1: the tolerance](table1.md), [figures](table1.csv)",
        Topic::Table2 => {
            "[Table 2: seven methods](table2.md), [figures](table2.csv), [vertices](vertices.csv)"
        }
        Topic::Figure1 => {
            "Figure 1: [peels of 100 random points](figure1.svg), [points](figure1.csv)"
        }
        Topic::Figure2 => {
            "Figure 2: [peels of an oblique lattice](figure2.svg), [points](figure2.csv)"
        }
        Topic::Figure7 => "[Figure 7: growth of GS and E](figure7.md), [figures](figure7.csv)",
        Topic::Storage => "[Storage: the stack of method GS](storage.md), [figures](storage.csv)",
        Topic::Peeling => "[Peeling: what all layers cost](peeling.md), [figures](peeling.csv)",
        Topic::Claim(_) => return None,
    })
}

/// What was proved, and where the rows are.
fn certificates(records: &Records) -> String {
    let results: usize = records.sets.iter().map(|row| row.certified).sum();
    let hulls: u64 = records.sizes.iter().map(|row| row.replicates).sum();
    let mut text = format!(
        "## Certificates and records\n\n{results} results on {} sets were held against a certified hull or peeling, \
         {hulls} more hulls were certified for their size alone; {} results have no certificate.\n\nRows kept in this \
         folder: `records-*.csv`. Sets are named by seed and fingerprint in `records-sets.csv`.\n",
        records.sets.len(),
        records.failures.len()
    );
    if !records.failures.is_empty() {
        let mut sheet = Sheet::new(&["stage", "distribution", "n", "replicate", "method", "what"]);
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
