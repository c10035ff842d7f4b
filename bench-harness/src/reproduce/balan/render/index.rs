//! The report's first page.

use crate::reproduce::balan::definition::Definition;
use crate::reproduce::balan::published::Published;
use crate::reproduce::balan::records::Records;
use crate::reproduce::balan::topics::Topic;
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
        "A. Balan, G. Munjal and T. R. Rao, *Implementation of Convex Hull Algorithms in 3D space*: three programs \
         described, their costs stated, no times printed. Here the costs are counted, the claims judged, and the table \
         that is missing is supplied.\n\n",
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
    folder.markdown("REPORT.md", "Balan, Munjal & Rao, reproduced", &body)
}

fn line(topic: &Topic) -> Option<&'static str> {
    Some(match topic {
        Topic::Counts => {
            "[Counts: questions asked and facets made](counts.md), [figures](counts.csv)"
        }
        Topic::Times => {
            "[Times: the table the paper does not print](times.md), [figures](times.csv)"
        }
        Topic::Angles => "[Angles: the sign of the cosine](angles.md), [figures](angles.csv)",
        Topic::Visibility => {
            "[Visibility tests without a conflict graph, against n](visibility.svg), [figures](visibility.csv)"
        }
        Topic::Orders => {
            "[Facets made in the worst order and in random order, against n](orders.svg), [figures](orders.csv)"
        }
        Topic::Evaluations => {
            "[Plane evaluations of quickhull a point, against n](evaluations.svg), [figures](evaluations.csv)"
        }
        Topic::Claim(_) => return None,
    })
}

/// What was proved, and where the rows are.
fn certificates(records: &Records) -> String {
    let results: usize = records.sets.iter().map(|row| row.certified).sum();
    let mut text = format!(
        "## Certificates and records\n\n{results} results on {} sets were held against a certified hull; {} results have \
         no certificate.\n\nRows kept in this folder: `records-*.csv`. Sets are named by seed and fingerprint in \
         `records-sets.csv`.\n",
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
