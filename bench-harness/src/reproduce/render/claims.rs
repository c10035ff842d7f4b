//! Claims and the verdicts on them, and predictions, for any paper.

use super::folder::Folder;
use super::sheet::{Sheet, fixed};
use crate::reproduce::data::{Claim, Published};
use crate::reproduce::prediction::Checked;
use crate::reproduce::verdict::{Outcome, Verdict};
use anyhow::Result;

/// Writes `claims.md` and `claims.csv` of the paper called `title`.
pub(crate) fn write(
    folder: &Folder,
    title: &str,
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
    folder.markdown("claims.md", &format!("The claims of {title}"), &body)?;
    folder.csv("claims.csv", &long(verdicts).csv())
}

fn find<'a>(claims: &'a [Claim], id: &str) -> Option<&'a Claim> {
    claims.iter().find(|claim| claim.id == id)
}

/// A claim, how it was tested, and the outcome of each part.
fn section(verdict: &Verdict, claims: &[Claim]) -> String {
    let mut text = format!("## {}: {}\n\n", verdict.id, verdict.outcome);
    if let Some(claim) = find(claims, verdict.id) {
        text += &format!(
            "**Claim** (section {}): {}\n\n**Test**: {}\n\n",
            claim.section, claim.statement, claim.test
        );
    }
    let mut sheet = Sheet::new(&["part", "outcome", "statistic"]);
    for part in &verdict.parts {
        sheet.push(vec![
            part.what.clone(),
            part.outcome.to_string(),
            part.statistic.clone(),
        ]);
    }
    text += &sheet.markdown();
    for note in &verdict.notes {
        text += &format!("\n- {note}");
    }
    text + if verdict.notes.is_empty() {
        "\n"
    } else {
        "\n\n"
    }
}

/// Every part of every verdict, a row each.
fn long(verdicts: &[Verdict]) -> Sheet {
    let mut sheet = Sheet::new(&["claim", "verdict", "part", "outcome", "statistic"]);
    for verdict in verdicts {
        for part in &verdict.parts {
            sheet.push(vec![
                verdict.id.to_owned(),
                verdict.outcome.to_string(),
                part.what.clone(),
                part.outcome.to_string(),
                part.statistic.clone(),
            ]);
        }
    }
    sheet
}

/// The verdicts in one table.
pub(crate) fn summary(verdicts: &[Verdict], claims: &[Claim]) -> Sheet {
    let mut sheet = Sheet::new(&["claim", "", "verdict", "parts confirmed"]);
    for verdict in verdicts {
        let confirmed = verdict
            .parts
            .iter()
            .filter(|part| part.outcome == Outcome::Confirmed)
            .count();
        let statement =
            find(claims, verdict.id).map_or_else(String::new, |claim| claim.statement.clone());
        sheet.push(vec![
            verdict.id.to_owned(),
            statement,
            format!("**{}**", verdict.outcome),
            format!("{confirmed} of {}", verdict.parts.len()),
        ]);
    }
    sheet
}

/// The predictions that this run measured, in one table.
pub(crate) fn predicted(predictions: &[Checked<'_>]) -> Sheet {
    let mut sheet = Sheet::new(&[
        "prediction",
        "measure",
        "in the paper",
        "predicted",
        "measured",
        "held",
    ]);
    for checked in predictions {
        let Some(held) = checked.held() else { continue };
        let prediction = checked.prediction;
        sheet.push(vec![
            prediction.statement.clone(),
            prediction.measure.clone(),
            fixed(prediction.published, 2),
            format!("{} to {}", prediction.low, prediction.high),
            fixed(checked.measured, 4),
            if held {
                "yes".to_owned()
            } else {
                "**no**".to_owned()
            },
        ]);
    }
    sheet
}
