//! What can be asked for, and which experiments it takes.

use super::published::Published;
use crate::failure::Failure;
use anyhow::Result;

/// A table, a figure or a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Topic {
    Precision,
    Merge,
    Edges,
    Whole,
    Degenerate,
    Bases,
    Listing,
    Checks,
    Parallel,
    Claim(String),
}

/// An experiment that adds to the records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Experiment {
    Precision,
    Speed,
    Merges,
    Counts,
    Times,
    Battery,
    Bases,
    Listing,
    Checks,
    Parallel,
}

/// The topics that are no claims, by name.
const NAMED: [(&str, Topic); 9] = [
    ("precision", Topic::Precision),
    ("merge", Topic::Merge),
    ("edges", Topic::Edges),
    ("whole", Topic::Whole),
    ("degenerate", Topic::Degenerate),
    ("bases", Topic::Bases),
    ("spiral", Topic::Listing),
    ("checks", Topic::Checks),
    ("side-by-side", Topic::Parallel),
];

/// The name that stands for every claim of this paper.
const CLAIMS: &str = "day-claims";

/// The topics called `ids`, all if there are none. Case does not matter.
///
/// # Errors
///
/// An id that names nothing.
pub(crate) fn parse(ids: &[String], published: &Published) -> Result<Vec<Topic>> {
    let claim = |id: &str| Topic::Claim(id.to_owned());
    let claims = || published.claims.iter().map(|known| claim(&known.id));
    let named = || NAMED.iter().map(|(_, topic)| topic.clone());
    if ids.is_empty() {
        return Ok(named().chain(claims()).collect());
    }
    let mut topics = Vec::new();
    for id in ids {
        let same = |name: &str| name.eq_ignore_ascii_case(id);
        if same(CLAIMS) {
            topics.extend(claims());
        } else if let Some((_, topic)) = NAMED.iter().find(|(name, _)| same(name)) {
            topics.push(topic.clone());
        } else if let Some(known) = published.claims.iter().find(|known| same(&known.id)) {
            topics.push(claim(&known.id));
        } else {
            return Err(Failure::Usage(format!(
                "nothing of Day's to reproduce is called '{id}'; there are {}",
                names(published).join(", ")
            ))
            .into());
        }
    }
    Ok(topics)
}

/// Every name that [`parse`] knows.
pub(crate) fn names(published: &Published) -> Vec<String> {
    let named = NAMED.iter().map(|(name, _)| (*name).to_owned());
    let claims = published.claims.iter().map(|claim| claim.id.clone());
    named.chain([CLAIMS.to_owned()]).chain(claims).collect()
}

/// The experiments that `topic` is computed from.
pub(crate) fn experiments(topic: &Topic) -> &'static [Experiment] {
    use Experiment::{
        Bases, Battery, Checks, Counts, Listing, Merges, Parallel, Precision, Speed, Times,
    };
    match topic {
        Topic::Precision => &[Precision, Speed],
        Topic::Merge | Topic::Edges => &[Merges],
        Topic::Whole => &[Counts, Times],
        Topic::Degenerate => &[Battery],
        Topic::Bases => &[Bases],
        Topic::Listing => &[Listing],
        Topic::Checks => &[Checks],
        Topic::Parallel => &[Parallel, Times],
        Topic::Claim(id) => match id.as_str() {
            "D-1" => &[Precision],
            "D-2" => &[Speed],
            "D-6" => &[Bases],
            "D-7" => &[Counts, Times],
            "D-8" => &[Battery],
            "D-9" => &[Listing],
            "D-10" => &[Checks],
            "D-11" => &[Parallel, Times],
            _ => &[Merges],
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_whatever_their_case() {
        let published = Published::load().expect("valid");
        let parse = |ids: &[&str]| {
            let ids: Vec<String> = ids.iter().map(|id| (*id).to_owned()).collect();
            parse(&ids, &published)
        };
        assert_eq!(
            parse(&["Merge", "d-8"]).expect("known"),
            [Topic::Merge, Topic::Claim("D-8".into())]
        );
        assert_eq!(parse(&["day-claims"]).expect("known").len(), 11);
        assert_eq!(parse(&[]).expect("known").len(), 20);
        assert!(parse(&["table3"]).is_err());
    }
}
