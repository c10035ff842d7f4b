//! What can be asked for, and which experiments it takes.

use super::published::Published;
use crate::failure::Failure;
use anyhow::Result;

/// A table, a figure or a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Topic {
    Counts,
    Times,
    Angles,
    Visibility,
    Orders,
    Evaluations,
    Claim(String),
}

/// An experiment that adds to the records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Experiment {
    Counts,
    Merges,
    Orders,
    Angles,
    Times,
}

/// The topics that are no claims, by name.
const NAMED: [(&str, Topic); 6] = [
    ("balan-counts", Topic::Counts),
    ("balan-times", Topic::Times),
    ("balan-angles", Topic::Angles),
    ("visibility", Topic::Visibility),
    ("insertion-orders", Topic::Orders),
    ("evaluations", Topic::Evaluations),
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
    let all = || NAMED.iter().map(|(_, topic)| topic.clone()).chain(claims());
    if ids.is_empty() {
        return Ok(all().collect());
    }
    let called = |id: &String| {
        let named = NAMED.iter().find(|(name, _)| id.eq_ignore_ascii_case(name));
        let claim = claims()
            .find(|topic| matches!(topic, Topic::Claim(known) if known.eq_ignore_ascii_case(id)));
        named.map(|(_, topic)| topic.clone()).or(claim)
    };
    let mut topics = Vec::new();
    for id in ids {
        match called(id) {
            Some(topic) => topics.push(topic),
            None if id.eq_ignore_ascii_case("claims") => topics.extend(claims()),
            None => {
                let message = format!(
                    "nothing to reproduce is called '{id}'; there are {}",
                    names(published).join(", ")
                );
                return Err(Failure::Usage(message).into());
            }
        }
    }
    Ok(topics)
}

/// Every name that [`parse`] knows.
pub(crate) fn names(published: &Published) -> Vec<String> {
    let named = NAMED.iter().map(|(name, _)| (*name).to_owned());
    let claims = published.claims.iter().map(|claim| claim.id.clone());
    named.chain(["claims".to_owned()]).chain(claims).collect()
}

/// The experiments that `topic` is computed from.
pub(crate) fn experiments(topic: &Topic) -> &'static [Experiment] {
    use Experiment::{Angles, Counts, Merges, Orders, Times};
    match topic {
        Topic::Counts | Topic::Visibility | Topic::Evaluations => &[Counts],
        Topic::Times => &[Times],
        Topic::Angles => &[Angles],
        Topic::Orders => &[Orders],
        Topic::Claim(id) => match id.as_str() {
            "B-1" => &[Counts, Merges],
            "B-2" => &[Angles],
            "B-5" => &[Orders],
            "B-7" => &[Times],
            _ => &[Counts],
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
            parse(&["Visibility", "b-2"]).expect("known"),
            [Topic::Visibility, Topic::Claim("B-2".into())]
        );
        assert_eq!(parse(&["claims"]).expect("known").len(), 7);
        assert_eq!(parse(&[]).expect("known").len(), 13);
        assert!(parse(&["table3"]).is_err());
    }
}
