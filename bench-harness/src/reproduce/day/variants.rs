//! The three rules of search by name.

use anyhow::{Context, Result};
use divide_and_conquer::preparata_hong_3d::Variant;

/// The rules: name, variant, registered method, and words for it.
const ALL: [(&str, Variant, &str, &str); 3] = [
    (
        "resumed",
        Variant::Resumed,
        "preparata-hong-3d",
        "resumed (Day)",
    ),
    (
        "rescanned",
        Variant::Rescanned,
        "preparata-hong-rescan",
        "anew at every step",
    ),
    (
        "sorted",
        Variant::Sorted,
        "preparata-hong-balan",
        "sorting at every step",
    ),
];

/// The names, Day's rule first.
pub(crate) const NAMES: [&str; 3] = [ALL[0].0, ALL[1].0, ALL[2].0];

/// The variant called `name`, and the slug under which it is registered as a method.
pub(crate) fn find(name: &str) -> Result<(Variant, &'static str)> {
    ALL.iter()
        .find(|(known, ..)| *known == name)
        .map(|&(_, variant, slug, _)| (variant, slug))
        .with_context(|| format!("no rule of search is called {name:?}"))
}

/// Words for the rule called `name`.
pub(crate) fn words(name: &str) -> &'static str {
    ALL.iter()
        .find(|(known, ..)| *known == name)
        .map_or("unknown", |(.., words)| words)
}
