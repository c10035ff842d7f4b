//! Papers and experiments as data: files below `data/`, found in the checkout or built into the program.

use super::prediction::{Prediction, predictions};
use crate::definition::Extent;
use crate::definition::find::BUILT_IN;
use anyhow::{Context, Result};
use include_dir::{Dir, include_dir};
use serde::Deserialize;
use serde::de::DeserializeOwned;
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

/// Every pair of a distribution and a size.
pub(crate) fn product(distributions: &[String], n: &[usize]) -> Vec<(String, usize)> {
    let pair = |distribution: &String| {
        n.iter()
            .map(|&n| (distribution.clone(), n))
            .collect::<Vec<_>>()
    };
    distributions.iter().flat_map(pair).collect()
}

/// A block of cells: every distribution with every n, so many sets of each.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Cells {
    pub(crate) distributions: Vec<String>,
    pub(crate) n: Vec<usize>,
    pub(crate) replicates: u64,
}

impl Cells {
    /// Each set of the block: distribution, size, replicate.
    pub(crate) fn sets(&self) -> Vec<(String, usize, u64)> {
        let cells = product(&self.distributions, &self.n).into_iter();
        let sets = cells.flat_map(|(distribution, n)| {
            (0..self.replicates).map(move |replicate| (distribution.clone(), n, replicate))
        });
        sets.collect()
    }
}

/// The reference run and the quick one.
#[cfg(test)]
pub(crate) const EXTENTS: [Extent; 2] = [Extent::Full, Extent::Quick];

static PUBLISHED: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../data/published");

/// What a paper claims, and what we predicted.
#[derive(Clone, Debug)]
pub(crate) struct Published {
    pub(crate) claims: Vec<Claim>,
    pub(crate) predictions: Vec<Prediction>,
}

impl Published {
    /// Reads the files of the paper called `slug`.
    pub(crate) fn load(slug: &str) -> Result<Self> {
        let claims: Claims = toml::from_str(&published(slug, "claims.toml")?)
            .with_context(|| format!("in claims.toml of {slug}"))?;
        Ok(Self {
            claims: claims.claim,
            predictions: predictions(&text("definitions", &BUILT_IN, slug, "predictions.toml")?)?,
        })
    }
}

/// The studies of the paper called `slug`: of the reference run or of the quick one.
pub(crate) fn studies<S: DeserializeOwned>(slug: &str, extent: Extent) -> Result<S> {
    let name = match extent {
        Extent::Full => "studies.toml",
        Extent::Quick => "studies-quick.toml",
    };
    let text = text("definitions", &BUILT_IN, slug, name)?;
    toml::from_str(&text).with_context(|| format!("in {name} of {slug}"))
}

/// The text of the file `name` in the folder of the paper called `slug`, below `data/published`.
pub(crate) fn published(slug: &str, name: &str) -> Result<String> {
    text("published", &PUBLISHED, slug, name)
}

/// The rows of a published CSV file.
pub(crate) fn rows<T: DeserializeOwned>(slug: &str, name: &str) -> Result<Vec<T>> {
    let text = published(slug, name)?;
    let rows: Result<Vec<T>, csv::Error> = csv::Reader::from_reader(text.as_bytes())
        .into_deserialize()
        .collect();
    rows.with_context(|| format!("in {name} of {slug}"))
}

/// The text of a file below `data`: the checkout's if the program runs in one, else the copy built into it.
fn text(folder: &str, built_in: &Dir<'_>, slug: &str, name: &str) -> Result<String> {
    let path = format!("data/{folder}/{slug}/{name}");
    if Path::new(&path).is_file() {
        return std::fs::read_to_string(&path).with_context(|| format!("reading {path}"));
    }
    let file = built_in.get_file(format!("{slug}/{name}"));
    let text = file.and_then(include_dir::File::contents_utf8);
    text.map(str::to_owned)
        .with_context(|| format!("no file {path} is built in"))
}
