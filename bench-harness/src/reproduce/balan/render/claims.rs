//! The claims and the verdicts on them.

use crate::reproduce::balan::published::Published;
use crate::reproduce::prediction::Checked;
use crate::reproduce::render::claims::{long, predicted, section};
use crate::reproduce::render::folder::Folder;
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
    folder.markdown("claims.md", "The claims of Balan, Munjal and Rao", &body)?;
    folder.csv("claims.csv", &long(verdicts).csv())
}
