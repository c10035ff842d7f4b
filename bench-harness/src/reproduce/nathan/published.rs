//! The paper's claims and our predictions, read from `data/`.

use super::definition::PAPER;
use crate::reproduce::data::{Claim, claims, in_checkout_or};
use crate::reproduce::prediction::{Prediction, predictions};
use anyhow::Result;

/// The paper as data. It prints no figures of its own.
#[derive(Clone, Debug)]
pub(crate) struct Published {
    /// The claims.
    pub(crate) claims: Vec<Claim>,
    /// What we predicted.
    pub(crate) predictions: Vec<Prediction>,
}

impl Published {
    /// Reads the paper's files.
    pub(crate) fn load() -> Result<Self> {
        let claims_text = in_checkout_or(
            &format!("data/published/{PAPER}/claims.toml"),
            include_str!("../../../../data/published/nathan-2015/claims.toml"),
        )?;
        let predictions_text = in_checkout_or(
            &format!("data/definitions/{PAPER}/predictions.toml"),
            include_str!("../../../../data/definitions/nathan-2015/predictions.toml"),
        )?;
        Ok(Self {
            claims: claims(&claims_text)?,
            predictions: predictions(&predictions_text)?,
        })
    }
}
