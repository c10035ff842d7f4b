//! The paper's claims, read from `data/published/`, and our predictions.

use super::definition::PAPER;
use crate::reproduce::data::{Claim, claims, in_checkout_or};
use crate::reproduce::prediction::{Prediction, predictions};
use anyhow::Result;

/// The paper as data.
#[derive(Clone, Debug)]
pub(crate) struct Published {
    pub(crate) claims: Vec<Claim>,
    /// What we predicted.
    pub(crate) predictions: Vec<Prediction>,
}

impl Published {
    /// Reads the paper's files.
    pub(crate) fn load() -> Result<Self> {
        let claims_text = in_checkout_or(
            &format!("data/published/{PAPER}/claims.toml"),
            include_str!("../../../../data/published/day-1990/claims.toml"),
        )?;
        let predictions_text = in_checkout_or(
            &format!("data/definitions/{PAPER}/predictions.toml"),
            include_str!("../../../../data/definitions/day-1990/predictions.toml"),
        )?;
        Ok(Self {
            claims: claims(&claims_text)?,
            predictions: predictions(&predictions_text)?,
        })
    }
}
