//! Papers and experiments as data: files below `data/`, found in the checkout or built into the program.

use anyhow::{Context, Result};
use serde::Deserialize;
use std::path::Path;

/// A claim of the paper, in our words.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Claim {
    pub(crate) id: String,
    pub(crate) section: String,
    pub(crate) statement: String,
    pub(crate) test: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Claims {
    claim: Vec<Claim>,
}

/// The claims in the text of a `claims.toml`.
pub(crate) fn claims(text: &str) -> Result<Vec<Claim>> {
    let claims: Claims = toml::from_str(text).context("in claims.toml")?;
    Ok(claims.claim)
}

/// The rows of a CSV text.
pub(crate) fn rows<T: for<'a> Deserialize<'a>>(text: &str) -> Result<Vec<T>> {
    let rows: Result<Vec<T>, csv::Error> = csv::Reader::from_reader(text.as_bytes())
        .into_deserialize()
        .collect();
    Ok(rows?)
}

/// Every pair of a distribution and a size.
pub(crate) fn product(distributions: &[String], n: &[usize]) -> Vec<(String, usize)> {
    let pair = |distribution: &String| {
        n.iter()
            .map(|&n| (distribution.clone(), n))
            .collect::<Vec<_>>()
    };
    distributions.iter().flat_map(pair).collect()
}

/// The text of the file at `path` below the current folder, or `built_in` if there is none.
pub(crate) fn in_checkout_or(path: &str, built_in: &str) -> Result<String> {
    if Path::new(path).is_file() {
        std::fs::read_to_string(path).with_context(|| format!("reading {path}"))
    } else {
        Ok(built_in.to_owned())
    }
}
