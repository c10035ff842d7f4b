//! What we predicted before a run, beside what came out.

use anyhow::{Context, Result};
use serde::Deserialize;

/// A prediction of ours, made before the run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Prediction {
    pub(crate) id: String,
    /// The quantity, by the name under which it is computed.
    pub(crate) measure: String,
    pub(crate) statement: String,
    /// The paper's own value of it, if it has one.
    pub(crate) published: Option<f64>,
    /// The prediction holds from here …
    pub(crate) low: f64,
    /// … to here.
    pub(crate) high: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Predictions {
    prediction: Vec<Prediction>,
}

/// The predictions in the text of a `predictions.toml`.
pub(crate) fn predictions(text: &str) -> Result<Vec<Prediction>> {
    let predictions: Predictions = toml::from_str(text).context("in predictions.toml")?;
    Ok(predictions.prediction)
}

/// A prediction and the value it is about.
#[derive(Clone, Debug)]
pub(crate) struct Checked<'a> {
    pub(crate) prediction: &'a Prediction,
    /// `None` if the run did not measure it.
    pub(crate) measured: Option<f64>,
}

impl Checked<'_> {
    /// Whether the value lies where it was predicted to lie.
    pub(crate) fn held(&self) -> Option<bool> {
        self.measured
            .map(|value| (self.prediction.low..=self.prediction.high).contains(&value))
    }
}

/// Every prediction beside the value that `measure` gives of its id.
pub(crate) fn check(
    predictions: &[Prediction],
    measure: impl Fn(&str) -> Option<f64>,
) -> Vec<Checked<'_>> {
    let check = |prediction| Checked {
        prediction,
        measured: measure(&prediction.id),
    };
    predictions.iter().map(check).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_prediction_holds_between_its_ends() {
        let text = "[[prediction]]\nid = \"a\"\nmeasure = \"m\"\nstatement = \"s\"\nlow = 1.0\nhigh = 2.0\n";
        let predictions = predictions(text).expect("valid");
        for (value, held) in [
            (Some(1.0), Some(true)),
            (Some(2.5), Some(false)),
            (None, None),
        ] {
            let checked = check(&predictions, |id| value.filter(|_| id == "a"));
            assert_eq!(checked[0].held(), held);
        }
        assert!(super::predictions(&text.replace("low", "least")).is_err());
    }
}
