//! What can be asked for, and which experiments it takes.

use super::published::Published;
use crate::failure::Failure;
use anyhow::Result;

/// A table, a figure or a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Topic {
    Table1,
    Table2,
    Figure1,
    Figure2,
    Figure7,
    Storage,
    Peeling,
    Claim(String),
}

/// An experiment that adds to the records.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Experiment {
    Sizes,
    Counts,
    Times,
    Peels,
    Lattices,
    Tolerance,
}

/// The topics that are no claims, by name.
const NAMED: [(&str, Topic); 7] = [
    ("table1", Topic::Table1),
    ("table2", Topic::Table2),
    ("figure1", Topic::Figure1),
    ("figure2", Topic::Figure2),
    ("figure7", Topic::Figure7),
    ("storage", Topic::Storage),
    ("peeling", Topic::Peeling),
];

/// The topics called `ids`, all if there are none. `claims` stands for every claim; case does not matter.
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
        return Ok(NAMED
            .iter()
            .map(|(_, topic)| topic.clone())
            .chain(claims())
            .collect());
    }
    let mut topics = Vec::new();
    for id in ids {
        let wanted = id.to_ascii_lowercase();
        if wanted == "claims" {
            topics.extend(claims());
        } else if let Some((_, topic)) = NAMED.iter().find(|(name, _)| *name == wanted) {
            topics.push(topic.clone());
        } else if let Some(claim) = published
            .claims
            .iter()
            .find(|claim| claim.id.eq_ignore_ascii_case(id))
        {
            topics.push(Topic::Claim(claim.id.clone()));
        } else {
            let names: Vec<&str> = NAMED.iter().map(|(name, _)| *name).collect();
            return Err(Failure::Usage(format!(
                "nothing to reproduce is called '{id}'; there are {}, claims, and GS-1 to GS-{}",
                names.join(", "),
                published.claims.len()
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
    named.chain(["claims".to_owned()]).chain(claims).collect()
}

/// The experiments that `topic` is computed from.
pub(crate) fn experiments(topic: &Topic) -> &'static [Experiment] {
    use Experiment::{Counts, Lattices, Peels, Sizes, Times, Tolerance};
    match topic {
        Topic::Table1 => &[Tolerance, Lattices],
        Topic::Table2 => &[Sizes, Counts, Times],
        Topic::Figure1 | Topic::Figure2 => &[],
        Topic::Figure7 => &[Counts, Times],
        Topic::Storage | Topic::Peeling => &[Peels],
        Topic::Claim(id) => match id.as_str() {
            "GS-2" => &[Sizes],
            "GS-5" => &[Tolerance, Lattices],
            "GS-7" | "GS-9" => &[Peels],
            "GS-8" => &[Lattices],
            _ => &[Counts, Times],
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
            parse(&["Table1", "gs-8"]).expect("known"),
            [Topic::Table1, Topic::Claim("GS-8".into())]
        );
        assert_eq!(parse(&["claims"]).expect("known").len(), 9);
        assert_eq!(parse(&[]).expect("known").len(), 16);
        assert!(
            parse(&["table3"])
                .expect_err("unknown")
                .to_string()
                .contains("table3")
        );
    }
}
