//! What was published: comparisons by others that ours can stand beside; and what is compared here.

use serde::Deserialize;

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
    use crate::reproduce::balan::SLUG;
    use crate::reproduce::data::rows;

    #[test]
    fn comparisons_name_registered_methods() {
        let comparisons: Vec<Comparison> = rows(SLUG, "comparisons.csv").expect("valid");
        for comparison in &comparisons {
            for slug in [&comparison.our_slower, &comparison.our_faster] {
                assert!(hullkit::method(slug).is_some(), "{slug}");
            }
        }
        assert!(slugs().all(|slug| hullkit::method(slug).is_some()));
        assert_eq!(slugs().count(), 8);
    }
}
