//! What of a paper is asked for, and what that needs.

use super::{Claim, Paper, Topic};

/// The name that stands for all claims.
const ALL_CLAIMS: &str = "claims";

/// The names of its tables, figures and claims.
pub(super) fn ids<P: Paper>() -> Vec<&'static str> {
    let topics = P::TOPICS.iter().map(|topic| topic.name);
    let claims = P::CLAIMS.iter().map(|claim| claim.id);
    topics.chain([ALL_CLAIMS]).chain(claims).collect()
}

/// The topics and claims that are asked for.
pub(crate) struct Asked<P: Paper> {
    pub(crate) topics: Vec<&'static Topic<P>>,
    pub(crate) claims: Vec<&'static Claim<P>>,
}

impl<P: Paper> Asked<P> {
    /// Those called `ids`, which are the paper's; all if there are none. Case does not matter.
    pub(super) fn of(ids: &[String]) -> Self {
        let called = |name: &str| ids.iter().any(|id| id.eq_ignore_ascii_case(name));
        let all = ids.is_empty();
        let topics = P::TOPICS.iter().filter(|topic| all || called(topic.name));
        let all = all || called(ALL_CLAIMS);
        let claims = P::CLAIMS.iter().filter(|claim| all || called(claim.id));
        Self {
            topics: topics.collect(),
            claims: claims.collect(),
        }
    }

    /// Whether the definition or study called `name` is needed.
    pub(super) fn needs(&self, name: &str) -> bool {
        let topics = self.topics.iter().map(|topic| topic.needs);
        let mut needs = topics.chain(self.claims.iter().map(|claim| claim.needs));
        needs.any(|needs| needs.contains(&name))
    }
}
