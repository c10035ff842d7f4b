//! A verdict for each claim, computed from the records alone.
//!
//! A verdict is made of parts, each with its own outcome and statistic; nothing here knows what the answer
//! should be.

mod gs1;
mod gs2;
mod gs3;
mod gs4;
mod gs5;
mod gs6;
mod gs7;
mod gs8;
mod gs9;
#[cfg(test)]
mod made_up;
pub(crate) mod predictions;

pub(crate) use gs5::{limit_from_above, limit_from_below};

use super::published::Published;
use super::records::Records;
use crate::reproduce::verdict::{Outcome, Part, Verdict, all_of, ratio_text, with_time};

/// Every claim's id and its judge, in order.
type Judge = fn(&Records, &Published) -> Verdict;
const JUDGES: [(&str, Judge); 9] = [
    ("GS-1", gs1::judge),
    ("GS-2", gs2::judge),
    ("GS-3", gs3::judge),
    ("GS-4", gs4::judge),
    ("GS-5", gs5::judge),
    ("GS-6", gs6::judge),
    ("GS-7", gs7::judge),
    ("GS-8", gs8::judge),
    ("GS-9", gs9::judge),
];

/// The verdict on the claim `id`, if there is such a claim.
pub(crate) fn judge(id: &str, records: &Records, published: &Published) -> Option<Verdict> {
    let (_, judge) = JUDGES.iter().find(|(known, _)| *known == id)?;
    Some(judge(records, published))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_records_nothing_is_testable() {
        let published = Published::load().expect("valid");
        for (id, _) in JUDGES {
            let verdict = judge(id, &Records::default(), &published).expect("a claim");
            assert_eq!(verdict.outcome, Outcome::NotTestable, "{id}");
            assert_eq!(verdict.id, id);
            assert!(published.claims.iter().any(|claim| claim.id == id));
        }
    }
}
