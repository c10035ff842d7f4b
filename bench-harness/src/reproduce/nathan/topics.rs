//! What can be asked for, and which experiments it takes.

use super::published::Published;
use crate::failure::Failure;
use anyhow::Result;

/// A table, a figure or a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Topic {
    Wraps,
    Epsilon,
    Times,
    Figure1,
    Lifting,
    Sweep,
    Sizes,
    Claim(String),
}

/// An experiment that adds to the records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Experiment {
    Wraps,
    Starts,
    Epsilon,
    Corners,
    Methods,
    Lifting,
    Sweep,
    Sizes,
}

/// The topics that are no claims, by name. Where another paper has a topic of that name, the name asks for both.
const NAMED: [(&str, Topic); 7] = [
    ("wraps", Topic::Wraps),
    ("epsilon", Topic::Epsilon),
    ("wrap-times", Topic::Times),
    ("delaunay", Topic::Figure1),
    ("lifting", Topic::Lifting),
    ("sweep", Topic::Sweep),
    ("sizes-in-space", Topic::Sizes),
];

/// The topics called `ids`, all if there are none. Case does not matter.
///
/// # Errors
///
/// An id that names nothing.
pub(crate) fn parse(ids: &[String], published: &Published) -> Result<Vec<Topic>> {
    let claims = || {
        published
            .claims
            .iter()
            .map(|claim| Topic::Claim(claim.id.clone()))
    };
    if ids.is_empty() {
        let named = NAMED.iter().map(|(_, topic)| topic.clone());
        return Ok(named.chain(claims()).collect());
    }
    let mut topics = Vec::new();
    for id in ids {
        let named = NAMED.iter().find(|(name, _)| name.eq_ignore_ascii_case(id));
        let claim = published
            .claims
            .iter()
            .find(|claim| claim.id.eq_ignore_ascii_case(id));
        match (named, claim) {
            (Some((_, topic)), _) => topics.push(topic.clone()),
            (None, Some(claim)) => topics.push(Topic::Claim(claim.id.clone())),
            (None, None) => {
                let known = names(published).join(", ");
                return Err(Failure::Usage(format!(
                    "nothing to reproduce is called '{id}'; there are {known}"
                ))
                .into());
            }
        }
    }
    Ok(topics)
}

/// Every name that [`parse`] knows.
pub(crate) fn names(published: &Published) -> Vec<String> {
    let named = NAMED.iter().map(|(name, _)| (*name).to_owned());
    let claims = published.claims.iter().map(|claim| claim.id.clone());
    named.chain(claims).collect()
}

/// The experiments that `topic` is computed from.
pub(crate) fn experiments(topic: &Topic) -> &'static [Experiment] {
    use Experiment::{Corners, Epsilon, Lifting, Methods, Sizes, Starts, Sweep, Wraps};
    match topic {
        Topic::Wraps => &[Wraps],
        Topic::Epsilon => &[Epsilon, Starts],
        Topic::Times => &[Methods, Corners],
        Topic::Figure1 => &[],
        Topic::Lifting => &[Lifting],
        Topic::Sweep => &[Sweep],
        Topic::Sizes => &[Sizes],
        Topic::Claim(id) => match id.as_str() {
            "N-4" => &[Starts],
            "N-5" => &[Epsilon],
            "N-6" => &[Corners],
            "N-7" => &[Lifting],
            "N-8" => &[Sweep],
            _ => &[Wraps],
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
            parse(
                &ids.iter().map(|id| (*id).to_owned()).collect::<Vec<_>>(),
                &published,
            )
        };
        assert_eq!(
            parse(&["Wraps", "n-7"]).expect("known"),
            [Topic::Wraps, Topic::Claim("N-7".into())]
        );
        assert_eq!(parse(&[]).expect("known").len(), 7 + published.claims.len());
        assert!(
            parse(&["table9"])
                .expect_err("unknown")
                .to_string()
                .contains("table9")
        );
    }
}
