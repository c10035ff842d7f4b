//! The report's first page, and the claims.

use crate::reproduce::nathan::published::Published;
use crate::reproduce::nathan::records::Records;
use crate::reproduce::nathan::topics::Topic;
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
    folder.markdown("claims.md", "The claims of Nathan (2015)", &body)?;
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
        "P. Nathan, *Obtaining the convex hull from a set of points using the gift wrapping algorithm*, 2015: its claims \
         judged, its figure drawn anew.\n\n",
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
    folder.markdown("REPORT.md", "Nathan (2015), reproduced", &body)
}

fn line(topic: &Topic) -> Option<&'static str> {
    Some(match topic {
        Topic::Wraps => "[What wrapping asks](wraps.md), [figures](wraps.csv)",
        Topic::Epsilon => {
            "[The epsilon, and the first points](epsilon.md), figures: [epsilon](epsilon.csv), [starts](starts.csv)"
        }
        Topic::Times => "[Times of wrapping](wrap-times.md), [figures](wrap-times.csv)",
        Topic::Figure1 => {
            "Figure 1: [Delaunay triangulation of flattened points of the sphere](delaunay.svg), [triangles](delaunay.csv)"
        }
        Topic::Lifting => {
            "[Delaunay triangulations by lifting](lifting.md), figures: [offsets](lifting.csv), [grids](grids.csv)"
        }
        Topic::Sweep => "[The swept volume of a moving box](sweep.md), [figures](sweep.csv)",
        Topic::Sizes => "[Sizes in space](sizes.md), [figures](sizes.csv)",
        Topic::Claim(_) => return None,
    })
}

/// What was proved, and where the rows are.
fn certificates(records: &Records) -> String {
    let hulls: u64 = records.sizes.iter().map(|row| row.replicates).sum();
    let triangulations: usize = records.lifting.iter().map(|row| row.exact_right).sum();
    let mut text = format!(
        "## Certificates and records\n\n{} wraps counted, each equal to a certified hull; {hulls} hulls certified for their \
         size alone; {triangulations} triangulations certified; {} results have no certificate.\n\nRows kept in this folder: \
         `records-*.csv`. Sets are named by seed and fingerprint in `records-sets.csv`, or by one digest a cell.\n",
        records.wraps.len(),
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
