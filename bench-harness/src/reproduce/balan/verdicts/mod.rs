//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

mod b1;
mod b2;
mod b3;
mod b4;
mod b5;
mod b6;
mod b7;
#[cfg(test)]
mod made_up;
pub(crate) mod predictions;

use super::records::Records;
use crate::reproduce::verdict::{Outcome, Part, Verdict, all_of};

/// Every claim's id and its judge, in order.
type Judge = fn(&Records) -> Verdict;
const JUDGES: [(&str, Judge); 7] = [
    ("B-1", b1::judge),
    ("B-2", b2::judge),
    ("B-3", b3::judge),
    ("B-4", b4::judge),
    ("B-5", b5::judge),
    ("B-6", b6::judge),
    ("B-7", b7::judge),
];

/// The verdict on the claim `id`, if there is such a claim.
pub(crate) fn judge(id: &str, records: &Records) -> Option<Verdict> {
    let (_, judge) = JUDGES.iter().find(|(known, _)| *known == id)?;
    Some(judge(records))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::reproduce::balan::published::Published;

    #[test]
    fn without_records_nothing_is_testable() {
        let published = Published::load().expect("valid");
        for (id, _) in JUDGES {
            let verdict = judge(id, &Records::default()).expect("a claim");
            assert_eq!(verdict.outcome, Outcome::NotTestable, "{id}");
            assert_eq!(verdict.id, id);
            assert!(published.claims.iter().any(|claim| claim.id == id));
        }
    }
}
