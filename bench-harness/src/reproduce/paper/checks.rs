//! What must hold of every paper: its data fit its files.

use super::Paper;
use super::asked::Asked;
use crate::definition::Definition;
use crate::reproduce::data::{self, EXTENTS, Published};
use crate::reproduce::prediction;
use crate::reproduce::rows::Records;
use crate::reproduce::verdict::Outcome;
use std::collections::BTreeMap;

/// All of it.
pub(crate) fn all<P: Paper>() {
    names::<P>();
    needs::<P>();
    claims::<P>();
    let held = predictions::<P>(&Records::default());
    assert!(
        held.values().all(Option::is_none),
        "measured without records: {held:?}"
    );
}

/// Whether each prediction holds of `records`, by id.
pub(crate) fn predictions<P: Paper>(records: &Records<P::Rows>) -> BTreeMap<String, Option<bool>> {
    let predictions = Published::load(P::SLUG).expect("valid").predictions;
    let checked = prediction::check(&predictions, |id| P::measure(id, records));
    let held = checked
        .iter()
        .map(|checked| (checked.prediction.id.clone(), checked.held()));
    held.collect()
}

/// Claims are those of the paper's file, and without records nothing is testable.
fn claims<P: Paper>() {
    let published = Published::load(P::SLUG).expect("valid");
    let ids: Vec<&str> = published
        .claims
        .iter()
        .map(|claim| claim.id.as_str())
        .collect();
    let judged: Vec<&str> = P::CLAIMS.iter().map(|claim| claim.id).collect();
    assert_eq!(ids, judged);
    let (records, figures) = (Records::default(), P::figures().expect("valid"));
    for claim in P::CLAIMS {
        let verdict = (claim.judge)(&records, &figures);
        assert_eq!(
            (verdict.id, verdict.outcome),
            (claim.id, Outcome::NotTestable)
        );
    }
}

/// What is needed is a definition of both extents or a study, and each of these is needed.
fn needs<P: Paper>() {
    let asked = Asked::<P>::of(&[]);
    let topics = asked.topics.iter().flat_map(|topic| topic.needs);
    let needs = topics.chain(asked.claims.iter().flat_map(|claim| claim.needs));
    let needs: Vec<&str> = needs.copied().collect();
    for extent in EXTENTS {
        let mut studies: P::Studies = data::studies(P::SLUG, extent).expect("valid");
        let seed = *P::seed(&mut studies);
        assert!(!P::analysis(&studies).is_empty());
        let definitions = Definition::of_paper(P::SLUG, extent).expect("valid");
        let seeds = definitions.iter().map(|definition| definition.seed);
        assert!(seeds.into_iter().all(|other| other == seed));
        let mut names: Vec<&str> = P::STUDIES.iter().map(|study| study.name).collect();
        names.extend(definitions.iter().map(|definition| definition.id.as_str()));
        assert!(names.iter().all(|name| asked.needs(name)), "{names:?}");
        assert!(needs.iter().all(|need| names.contains(need)), "{needs:?}");
    }
}

/// Names are found whatever their case.
fn names<P: Paper>() {
    let of = |ids: &[&str]| {
        let ids: Vec<String> = ids.iter().map(|id| (*id).to_owned()).collect();
        let asked = Asked::<P>::of(&ids);
        (asked.topics.len(), asked.claims.len())
    };
    let topic = P::TOPICS[0].name.to_ascii_uppercase();
    let claim = P::CLAIMS[0].id.to_ascii_lowercase();
    assert_eq!(of(&[&topic, &claim]), (1, 1));
    assert_eq!(of(&["claims"]), (0, P::CLAIMS.len()));
    assert_eq!(of(&[]), (P::TOPICS.len(), P::CLAIMS.len()));
}
