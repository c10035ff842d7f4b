//! What was published: the paper's claims, comparisons by others that ours can stand beside, our predictions.

use super::definition::PAPER;
use crate::reproduce::data::{Claim, claims, in_checkout_or, rows};
use crate::reproduce::prediction::{Prediction, predictions};
use anyhow::{Context, Result};
use serde::Deserialize;

/// The published figures and claims.
#[derive(Clone, Debug)]
pub(crate) struct Published {
    pub(crate) claims: Vec<Claim>,
    pub(crate) comparisons: Vec<Comparison>,
    pub(crate) predictions: Vec<Prediction>,
}

/// How many times slower one program was found than another, on a machine and in a library that are not ours.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Comparison {
    pub(crate) source: String,
    pub(crate) slower: String,
    pub(crate) faster: String,
    pub(crate) input: String,
    pub(crate) n: usize,
    pub(crate) slower_seconds: f64,
    pub(crate) faster_seconds: f64,
    /// Our distribution, and our methods of the same kind.
    pub(crate) distribution: String,
    pub(crate) our_slower: String,
    pub(crate) our_faster: String,
}

/// The text of a published file: the checkout's, or the copy built into the program.
macro_rules! text {
    ($folder:literal, $name:literal) => {
        in_checkout_or(
            &format!("data/{}/{PAPER}/{}", $folder, $name),
            include_str!(concat!(
                "../../../../data/",
                $folder,
                "/balan-munjal-rao/",
                $name
            )),
        )
    };
}

impl Published {
    /// Reads the paper's files.
    pub(crate) fn load() -> Result<Self> {
        Ok(Self {
            claims: claims(&text!("published", "claims.toml")?)?,
            comparisons: rows(&text!("published", "comparisons.csv")?)
                .context("in comparisons.csv")?,
            predictions: predictions(&text!("definitions", "predictions.toml")?)?,
        })
    }
}

/// The three programs of the paper: our slug, the paper's name.
pub(crate) const PROGRAMS: [(&str, &str); 3] = [
    ("preparata-hong-balan", "divide and conquer"),
    ("incremental-3d", "random incremental"),
    ("quickhull-balan", "quick hull"),
];

/// For each of [`PROGRAMS`], the method of the same kind without the paper's simplifications.
pub(crate) const TWINS: [(&str, &str); 3] = [
    ("preparata-hong-3d", "divide and conquer, searches resumed"),
    ("incremental-conflict", "random incremental, conflict graph"),
    ("quickhull-3d", "quickhull, one outside set a point"),
];

/// Methods of another kind, for the table.
pub(crate) const KIN: [(&str, &str); 2] = [
    ("pivot-wrap", "gift wrapping"),
    ("nathan", "Nathan's wrapping"),
];

/// The slugs of the table, in its order.
pub(crate) fn slugs() -> impl Iterator<Item = &'static str> {
    let pairs = PROGRAMS.into_iter().zip(TWINS);
    let paired = pairs.flat_map(|(program, twin)| [program.0, twin.0]);
    paired.chain(KIN.into_iter().map(|(slug, _)| slug))
}

/// The distributions of the table, in its order.
pub(crate) const DISTRIBUTIONS: [&str; 6] = [
    "ball",
    "sphere",
    "cube",
    "normal3",
    "cauchy3",
    "cubic-lattice",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_files_are_valid_and_name_registered_methods() {
        let published = Published::load().expect("valid");
        let ids: Vec<&str> = published
            .claims
            .iter()
            .map(|claim| claim.id.as_str())
            .collect();
        assert_eq!(ids, ["B-1", "B-2", "B-3", "B-4", "B-5", "B-6", "B-7"]);
        for comparison in &published.comparisons {
            for slug in [&comparison.our_slower, &comparison.our_faster] {
                assert!(hullkit::method(slug).is_some(), "{slug}");
            }
        }
        assert!(slugs().all(|slug| hullkit::method(slug).is_some()));
        assert_eq!(slugs().count(), 8);
    }
}
