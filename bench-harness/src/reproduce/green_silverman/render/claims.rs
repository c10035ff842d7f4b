//! The claims and the verdicts on them.

use crate::reproduce::green_silverman::published::Published;
use crate::reproduce::green_silverman::verdicts::predictions::Checked;
use crate::reproduce::render::claims::{long, section};
use crate::reproduce::render::folder::Folder;
use crate::reproduce::render::sheet::{Sheet, fixed};
use crate::reproduce::verdict::Verdict;
use anyhow::Result;

/// Writes `claims.md` and `claims.csv`.
pub(crate) fn write(
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
    folder.markdown(
        "claims.md",
        "The claims of Green and Silverman (1979)",
        &body,
    )?;
    folder.csv("claims.csv", &long(verdicts).csv())
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
